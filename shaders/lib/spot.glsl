#ifndef MANYLIGHT_SPOT_GLSL
#define MANYLIGHT_SPOT_GLSL

// Spot: full inside the beam, linear in the angle out to the cutoff.
float spotFalloff(float cosAngle, float cosBeam, float cosCutoff) {
    if (cosAngle >= cosBeam) return 1.0;
    if (cosAngle <= cosCutoff) return 0.0;
    const float cutoff = acos(clamp(cosCutoff, -1.0, 1.0));
    return clamp((cutoff - acos(clamp(cosAngle, -1.0, 1.0))) / max(cutoff - acos(clamp(cosBeam, -1.0, 1.0)), 1e-6), 0.0, 1.0);
}

#endif
