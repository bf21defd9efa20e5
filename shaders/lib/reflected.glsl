// From irradiance to radiance. Lambertians reflect all directions alike, so that their loops sum irradiance and multiply
// once; loops for glossy surfaces sum radiance.
#ifndef MANYLIGHT_REFLECTED_GLSL
#define MANYLIGHT_REFLECTED_GLSL
#include "shaders/lib/surface.glsl"
#include "shaders/lib/vpl_shading.glsl"

Receiver receiverOf(Surface surface, vec3 toViewer) {
    return Receiver(surface.position, surface.normal, surface.geometricNormal, toViewer, surface.bsdf);
}

bool isGlossy(float f90) { return kGlossy && f90 > 0.0; }

// What a loop sums for irradiance from the unit direction `toLight`.
vec3 summand(Receiver receiver, vec3 irradiance, vec3 toLight) {
    if (!isGlossy(receiver.bsdf.f90)) return irradiance;
    return irradiance * evaluateBsdf(receiver.bsdf, receiver.normal, toLight, receiver.toViewer);
}

vec3 radianceFromSum(Receiver receiver, vec3 sum) {
    return isGlossy(receiver.bsdf.f90) ? sum : receiver.bsdf.diffuse * kInvPi * sum;
}

// How far a reflectance rises above what any Lambertian has: the bound on the geometry term counts it in.
float peak(vec3 reflectance) { return max(1.0, kPi * largestChannel(reflectance)); }

float peakTowards(Receiver receiver, vec3 toLight) {
    if (!isGlossy(receiver.bsdf.f90)) return 1.0;
    return peak(evaluateBsdf(receiver.bsdf, receiver.normal, toLight, receiver.toViewer));
}

#endif
