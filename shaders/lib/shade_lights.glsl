// The loop over the real lights, for deferred and forward shading alike.
#ifndef MANYLIGHT_SHADE_LIGHTS_GLSL
#define MANYLIGHT_SHADE_LIGHTS_GLSL
#include "shaders/lib/arriving.glsl"
#include "shaders/lib/light_samples.glsl"
#include "shaders/lib/reflected.glsl"
#include "shaders/lib/reservoir.glsl"

vec3 directionTo(LightData light, Receiver receiver) {
    if (light.kind == kLightDirectional) return -light.direction;
    const vec3 toLight = light.position - receiver.position;
    return toLight * inversesqrt(max(dot(toLight, toLight), 1e-30));
}

vec3 unshadowedLight(Receiver receiver, LightData light) {
    return summand(receiver, irradianceOfLight(receiver, light), directionTo(light, receiver));
}

// Where reflection depends on directions these are sampled too, see reflectedLights(), and a sample of an area light counts
// for its share.
float shareOfArea(Receiver receiver, AreaSample area) {
    if (!kCastShadows || !isGlossy(receiver.bsdf.f90)) return 1.0;
    const vec3 direction = directionTo(area.light, receiver);
    const float density = bsdfDensity(receiver.bsdf, receiver.normal, direction, receiver.toViewer);
    return shareOfLightSample(densityOfSample(area, receiver.position), density);
}

// Sample s of area lights: a ray to one of its candidates.
vec3 summandOfArea(Receiver receiver, uint s, uint seed) {
    const uint index = frame.frame * frame.lightSampleCount + s;
    const float u = kAreaCandidates > 1u ? sample2d(index, seed, kDimensionOfCandidate).x : 0.0;
    Reservoir reservoir = emptyReservoir(u);
    for (uint c = 0u; c < kAreaCandidates; ++c) {
        const AreaSample area = candidateOfArea(s, c, seed);
        offer(reservoir, area.light, shareOfArea(receiver, area) * unshadowedLight(receiver, area.light));
    }
    return arrivingFrom(reservoir, receiver);
}

// Summands of entries [first, first + count) of: point, spot and directional lights, then samples of area lights.
vec3 sumOfLights(Receiver receiver, uint seed, uint first, uint count) {
    const uint deltaLightCount = frame.deltaLightCount;
    vec3 sum = vec3(0.0);
    for (uint i = first; i < min(first + count, deltaLightCount); ++i) {
        const LightData light = deltaLight(loadEmitter(i));
        sum += arriving(unshadowedLight(receiver, light), receiver, light);
    }
    for (uint i = max(first, deltaLightCount); i < first + count; ++i)
        sum += summandOfArea(receiver, i - deltaLightCount, seed);
    return sum;
}

// The other half of direct light from area lights on glossy surfaces: one direction by the reflectance, and what shines
// there, weighted against the samples of the lights (Veach and Guibas 1995).
vec3 reflectedLights(Receiver receiver, uint seed) {
    const vec2 u = sample2d(frame.frame, seed, kDimensionReflected);
    const float uLobe = sample2d(frame.frame, seed, kDimensionReflected + 1u).x;
    const vec3 direction = sampleBsdf(receiver.bsdf, receiver.normal, receiver.toViewer, uLobe, u);
    const float density = bsdfDensity(receiver.bsdf, receiver.normal, direction, receiver.toViewer);
    const float cosine = dot(receiver.normal, direction);
    const bool matters = kCastShadows && frame.lightSampleCount > 0u && cosine > 0.0 && density > 0.0 && receiver.bsdf.f90 > 0.0 &&
                         dot(receiver.geometricNormal, direction) > 0.0;
    const vec3 origin = offsetPoint(receiver.position, receiver.geometricNormal);
    const Hit hit = closestHit(origin, matters ? direction : vec3(0.0), kBeyondTheScene);
    if (!matters) return vec3(0.0);
    const EmissionMet met = emissionMetBy(hit, direction);
    const float share = 1.0 - shareOfLightSample(met.density, density);
    return evaluateBsdf(receiver.bsdf, receiver.normal, direction, receiver.toViewer) * met.radiance *
           (cosine / density * share);
}

#endif
