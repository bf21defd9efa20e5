// What the bound on the geometry term cuts off, given back (Kollig and Keller 2006):
//   integral of f_r cos max(0, 1 - b / G) L over directions, L = light that the surface y there reflects.
// G > b needs d^2 < cos / b, so that rays are short, most meet nothing, and a miss contributes exactly 0. Where surfaces are
// glossy the bound is on G and the peaks of both reflectances, rays go as far as they like, and 1 - b / G differs with
// each light that y reflects.
#ifndef MANYLIGHT_COMPENSATION_GLSL
#define MANYLIGHT_COMPENSATION_GLSL
#include "shaders/lib/glossy_vpls.glsl"
#include "shaders/lib/shade_lights.glsl"
#include "shaders/lib/vpl_texels.glsl"

// At y one ray goes to emitters and one to VPLs: each to one of some candidates, drawn in proportion to what they would give
// (Talbot et al. 2005).
const uint kEmitterCandidates = 4u;
const uint kVplCandidates = 16u;
const uint kMostCompensations = 64u;  // one after the other; each needs a surface within its short reach
const uint kDimensionCompensation = 0x20000u;
const uint kDimensionsPerCompensation = 8u;

// Share of a connection that the bound cuts off; `product` is the geometry term times the peaks of both reflectances.
float shareCutOff(float product) { return product > frame.geometryBound ? 1.0 - frame.geometryBound / product : 0.0; }

// What y reflects of light from `toLight`, of which the bound takes a share that a glossy y has a say in; `product` is
// without y's peak.
vec3 cutOffAtY(Receiver y, vec3 summand, vec3 toLight, float product) {
    return isGlossy(y.bsdf.f90) ? summand * shareCutOff(product * peakTowards(y, toLight)) : summand;
}

// Candidates by their power, from the lights of direct light.
vec3 sumOfEmitters(Receiver y, float product, uint seed, uint dimension, float u) {
    Reservoir reservoir = emptyReservoir(u);
    for (uint s = 0u; s < kEmitterCandidates; ++s) {
        const uint index = frame.frame * kEmitterCandidates + s;
        const Emitter emitter = loadEmitter(chooseEmitter(sampleBits(index, seed, dimension).x, false));
        const float probability = emitter.probability * float(kEmitterCandidates);
        const bool isArea = emitter.kind == kEmitterTriangle || emitter.kind == kEmitterEnvironment;
        LightData light = deltaLight(emitter);
        if (isArea)
            light = sampleOfEmitter(emitter, sampleBits(index, seed, dimension + 1u),
                                    sampleInCell(index, seed, dimension + 5u), probability).light;
        else light.intensity *= 1.0 / probability;
        offer(reservoir, light, cutOffAtY(y, unshadowedLight(y, light), directionTo(light, y), product));
    }
    return arrivingFrom(reservoir, y);
}

vec3 summandOfVpl(Receiver y, LightData vpl, uint i, float product) {
    if (!kGlossy) return irradianceOfVpl(y, vpl, frame.geometryBound);
    const vec3 reflected = summandOfGlossyVpl(y, vpl, loadGloss(i), frame.geometryBound, false);
    return cutOffAtY(y, reflected, directionTo(vpl, y), product);
}

// Stratified candidates, bounded as everywhere. `room`: the bounces that y and those before it leave a VPL.
vec3 sumOfVpls(Receiver y, float product, uint room, uint seed, uint dimension, float u) {
    Reservoir reservoir = emptyReservoir(u);
    const float place = sample2d(frame.frame, seed, dimension).x;
    const float stride = float(frame.vplCount) / float(kVplCandidates);
    for (uint s = 0u; s < kVplCandidates; ++s) {
        const uint i = min(uint((float(s) + place) * stride), frame.vplCount - 1u);
        const LightData vpl = loadVpl(i);
        offer(reservoir, vpl, vpl.depth <= room ? summandOfVpl(y, vpl, i, product) * stride : vec3(0.0));
    }
    return arrivingFrom(reservoir, y);
}

// A direction from x, reflectance * cosine / density there, and the reflectance's peak.
struct Continuation {
    vec3 direction;
    vec3 weight;
    float peak;
};

Continuation continueFrom(Receiver x, uint seed, uint dimension) {
    Continuation next;
    const vec2 u = sample2d(frame.frame, seed, dimension);
    if (!isGlossy(x.bsdf.f90)) {
        next.direction = normalize(toWorld(squareToCosineHemisphere(u), x.normal));
        next.weight = x.bsdf.diffuse;
        next.peak = 1.0;
        return next;
    }
    next.direction = sampleBsdf(x.bsdf, x.normal, x.toViewer, sample2d(frame.frame, seed, dimension + 5u).x, u);
    const vec3 reflectance = evaluateBsdf(x.bsdf, x.normal, next.direction, x.toViewer);
    const float density = bsdfDensity(x.bsdf, x.normal, next.direction, x.toViewer);
    next.peak = peak(reflectance);
    next.weight = reflectance * (max(dot(x.normal, next.direction), 0.0) / max(density, 1e-30));
    return next;
}

// Radiance that the receiver, seen by the camera, lacks.
vec3 compensation(Receiver x, uint seed) {
    const float bound = frame.geometryBound;
    const uint bounces = min(frame.bounceCount, kMostCompensations);
    vec3 radiance = vec3(0.0);
    vec3 throughput = vec3(1.0);
    float product = 0.0;  // of the last connection, if its share is not known yet
    for (uint bounce = 1u; bounce <= bounces; ++bounce) {
        const uint dimension = kDimensionCompensation + bounce * kDimensionsPerCompensation;
        const Continuation next = continueFrom(x, seed, dimension);
        throughput *= next.weight;
        // What was cut off the light of a glossy x depends on where that came from.
        if (bounce > 1u && isGlossy(x.bsdf.f90)) throughput *= shareCutOff(product * next.peak);
        const float cosine = max(dot(next.direction, x.normal), 0.0);
        const float shortReach = min(sqrt(cosine / max(bound, 1e-30)), kBeyondTheScene);
        const float reach = kGlossy ? kBeyondTheScene : shortReach;
        const bool matters = throughput != vec3(0.0) && dot(x.geometricNormal, next.direction) > 0.0;
        const Hit hit =
            closestHit(offsetPoint(x.position, x.geometricNormal), matters ? next.direction : vec3(0.0), reach);
        if (hit.triangle == kNoHit) break;
        const Receiver y = receiverOf(surfaceAt(hit.triangle, hit.barycentrics, -next.direction), -next.direction);
        const float g = geometryTerm(x.normal, y.geometricNormal, y.position - x.position);
        product = g * next.peak;
        if (!isGlossy(y.bsdf.f90)) {
            if (product <= bound) break;
            throughput *= shareCutOff(product);
        }

        const vec2 u = sample2d(frame.frame, seed, dimension + 7u);
        const vec3 sum = sumOfEmitters(y, product, seed, dimension + 1u, u.x) +
                         sumOfVpls(y, product, frame.bounceCount - bounce, seed, dimension + 3u, u.y);
        radiance += throughput * radianceFromSum(y, sum);

        const float survival = min(largestChannel(y.bsdf.diffuse + y.bsdf.f0), 1.0);
        if (sample2d(frame.frame, seed, dimension + 4u).x >= survival) break;
        throughput /= survival;
        x = y;
    }
    return radiance;
}

#endif
