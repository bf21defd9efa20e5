#ifndef MANYLIGHT_SPOT_GLSL
#define MANYLIGHT_SPOT_GLSL

// Spot: full inside the beam, linear in the angle out to the cutoff.
float spotFalloff(float cosAngle, float cosBeam, float cosCutoff) {
    if (cosAngle >= cosBeam) return 1.0f;
    if (cosAngle <= cosCutoff) return 0.0f;
    const float cutoff = acos(clamp(cosCutoff, -1.0f, 1.0f));
    return clamp((cutoff - acos(clamp(cosAngle, -1.0f, 1.0f))) / max(cutoff - acos(clamp(cosBeam, -1.0f, 1.0f)), 1e-6f), 0.0f, 1.0f);
}

#endif
