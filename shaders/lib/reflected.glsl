// From irradiance to radiance. Lambertians reflect all directions alike, so that their loops sum irradiance and multiply
// once; where the scene has glossy surfaces, loops sum radiance.
#ifndef MANYLIGHT_REFLECTED_GLSL
#define MANYLIGHT_REFLECTED_GLSL
#include "shaders/lib/surface.glsl"
#include "shaders/lib/vpl_shading.glsl"

Receiver receiverOf(Surface surface, vec3 toViewer) {
    return Receiver(surface.position, surface.normal, surface.geometricNormal, toViewer, surface.bsdf);
}

// What a loop sums for irradiance from the unit direction `toLight`.
vec3 summand(Receiver receiver, vec3 irradiance, vec3 toLight) {
    if (!kGlossy) return irradiance;
    return irradiance * evaluateBsdf(receiver.bsdf, receiver.normal, toLight, receiver.toViewer);
}

vec3 radianceFromSum(Receiver receiver, vec3 sum) { return kGlossy ? sum : receiver.bsdf.diffuse * kInvPi * sum; }

// How far a reflectance rises above what any Lambertian has: what the bound on the geometry term counts with it.
float peak(vec3 reflectance) { return max(1.0, kPi * largestChannel(reflectance)); }

#endif
