// What the bound on the geometry term cuts off, given back (Kollig and Keller 2006):
//   integral of f_r cos max(0, 1 - b / G) L over directions, L = light that the surface y there reflects.
// G > b needs d^2 < cos / b, so that rays are short, most meet nothing, and a miss contributes exactly 0.
#ifndef MANYLIGHT_COMPENSATION_GLSL
#define MANYLIGHT_COMPENSATION_GLSL
#include "shaders/lib/arriving.glsl"
#include "shaders/lib/light_samples.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/vpl_texels.glsl"

// At y few lights are asked: what is cut off is a small part of the picture, and so is the noise in it.
const uint kLightsAsked = 2u;
const uint kVplsAsked = 4u;
const uint kMostCompensations = 64u;  // one after the other; each needs a surface within its short reach
const uint kDimensionCompensation = 0x20000u;
const uint kDimensionsPerCompensation = 8u;

// One or more emitters by their power, from the lights of direct light: an estimate of all of them.
vec3 directIrradiance(Receiver y, uint seed, uint dimension) {
    vec3 irradiance = vec3(0.0);
    for (uint s = 0u; s < kLightsAsked; ++s) {
        const uint index = frame.frame * kLightsAsked + s;
        const Emitter emitter = emitters[chooseEmitter(sample2d(index, seed, dimension).x, false)];
        const float weight = 1.0 / (emitter.probability * float(kLightsAsked));
        const bool isArea = emitter.kind == kEmitterTriangle || emitter.kind == kEmitterConstant;
        LightData light = deltaLight(emitter);
        if (isArea) light = sampleOfEmitter(emitter, sample2d(index, seed, dimension + 1u), weight);
        else light.intensity *= weight;
        irradiance += arriving(irradianceOfLight(y, light), y, light);
    }
    return irradiance;
}

// A stratified few of the VPLs, bounded as everywhere. `room`: the bounces that y and those before it leave a VPL.
vec3 vplIrradiance(Receiver y, float bound, uint room, uint seed, uint dimension) {
    vec3 irradiance = vec3(0.0);
    const float u = sample2d(frame.frame, seed, dimension).x;
    const float stride = float(frame.vplCount) / float(kVplsAsked);
    for (uint s = 0u; s < kVplsAsked; ++s) {
        const LightData vpl = loadVpl(min(uint((float(s) + u) * stride), frame.vplCount - 1u));
        const vec3 unshadowed = vpl.depth <= room ? irradianceOfVpl(y, vpl, bound) * stride : vec3(0.0);
        irradiance += arriving(unshadowed, y, vpl);
    }
    return irradiance;
}

// Radiance that the receiver, seen by the camera, lacks.
vec3 compensation(Receiver x, vec3 albedo, uint seed) {
    const float bound = frame.geometryBound;
    const uint bounces = min(frame.bounceCount, kMostCompensations);
    vec3 radiance = vec3(0.0);
    vec3 throughput = albedo;
    for (uint bounce = 1u; bounce <= bounces; ++bounce) {
        const uint dimension = kDimensionCompensation + bounce * kDimensionsPerCompensation;
        const vec3 local = squareToCosineHemisphere(sample2d(frame.frame, seed, dimension));
        const vec3 direction = normalize(toWorld(local, x.normal));
        const float cosine = max(dot(direction, x.normal), 0.0);
        const float reach = min(sqrt(cosine / max(bound, 1e-30)), kBeyondTheScene);
        const bool matters = throughput != vec3(0.0) && dot(x.geometricNormal, direction) > 0.0;
        const Hit hit =
            closestHit(offsetPoint(x.position, x.geometricNormal), matters ? direction : vec3(0.0), reach);
        if (hit.triangle == kNoHit) break;
        const Surface surface = surfaceAt(hit.triangle, hit.barycentrics, -direction);
        const Receiver y = Receiver(surface.position, surface.normal, surface.geometricNormal);
        const float g = geometryTerm(x.normal, y.geometricNormal, y.position - x.position);
        if (g <= bound) break;
        throughput *= 1.0 - bound / g;

        const vec3 irradiance = directIrradiance(y, seed, dimension + 1u) +
                                vplIrradiance(y, bound, frame.bounceCount - bounce, seed, dimension + 3u);
        radiance += throughput * surface.albedo * kInvPi * irradiance;

        const float survival = max(surface.albedo.x, max(surface.albedo.y, surface.albedo.z));
        if (sample2d(frame.frame, seed, dimension + 4u).x >= survival) break;
        throughput *= surface.albedo / survival;
        x = y;
    }
    return radiance;
}

#endif
