// Next-event estimation for the path tracer, and the density it would have had for what a path met by itself. Written
// apart from the VPL techniques, which are tested against it: the two share the emitter table and nothing else of this.
#ifndef MANYLIGHT_PATH_LIGHT_GLSL
#define MANYLIGHT_PATH_LIGHT_GLSL
#include "shaders/lib/emitter_radiance.glsl"
#include "shaders/lib/range.glsl"
#include "shaders/lib/ray.glsl"
#include "shaders/lib/surface.glsl"

struct LightSample {
    vec3 end;         // where the shadow ray ends
    vec3 direction;   // unit, to the light
    vec3 irradiance;  // on a plane across `direction`, over the probability of the sample
    float density;    // 1/sr; 0 for lights that no other way of sampling finds
};

// Per solid angle at distance d, of the point on an emissive triangle that next-event estimation would choose.
float densityOfEmitterPoint(float meanEmission, float area, float squaredDistance, float cosLight) {
    const float power = kPi * area * meanEmission;
    const float probability = frame.emitterPowerShare * power + frame.emitterEqualShare;
    return probability / area * squaredDistance / max(cosLight, 1e-20);
}

float densityOfEnvironment(vec3 direction) {
    return kEnvironmentMapped ? frame.environmentProbability * densityOfEnvironmentMap(direction)
                              : frame.environmentProbability / (4.0 * kPi);
}

LightSample sampleTriangle(Emitter emitter, vec3 position, vec2 u) {
    LightSample light;
    const vec3 normal = normalOfTriangle(emitter);
    const vec3 point = pointOnTriangle(emitter, u);
    const vec3 toLight = point - position;
    const float squaredDistance = max(dot(toLight, toLight), 1e-30);
    light.direction = toLight * inversesqrt(squaredDistance);
    const float cosLight = -dot(normal, light.direction);
    light.density = emitter.probability / emitter.area * squaredDistance / max(cosLight, 1e-20);
    light.irradiance = cosLight > 0.0 ? radianceOfTriangle(emitter, u) / light.density : vec3(0.0);
    light.end = offsetRayOrigin(point, normal, -toLight);
    return light;
}

LightSample sampleDeltaLight(Emitter emitter, vec3 position) {
    LightSample light;
    const bool isParallel = emitter.kind == kEmitterDirectional;
    const vec3 toLight = isParallel ? -8.0 * emitter.edge1 : emitter.position - position;
    const float squaredDistance = max(dot(toLight, toLight), 1e-30);
    light.direction = toLight * inversesqrt(squaredDistance);
    const float falloff = emitter.kind == kEmitterSpot
                              ? spotFalloff(-dot(light.direction, emitter.edge1), emitter.cosBeam, emitter.cosCutoff)
                              : 1.0;
    const float window = rangeWindow(sqrt(squaredDistance), emitter.inverseRange);
    light.irradiance = emitter.emission * (isParallel ? 1.0 : window * falloff / squaredDistance) / emitter.probability;
    light.density = 0.0;
    light.end = position + toLight;
    return light;
}

// All constant lights are one light: the sum of their radiances, chosen with the sum of their probabilities. A map has
// them in it.
LightSample sampleEnvironment(vec3 position, uvec2 bits, vec2 inCell) {
    LightSample light;
    vec3 radiance = frame.environmentRadiance;
    if (kEnvironmentMapped) {
        const EnvironmentSample drawn = sampleEnvironmentMap(bits, inCell);
        light.direction = drawn.direction;
        light.density = frame.environmentProbability * drawn.density;
        radiance = drawn.radiance;
    } else {
        light.direction = squareToCone(unitFloats(bits), -1.0);
        light.density = densityOfEnvironment(light.direction);
    }
    light.irradiance = light.density > 0.0 ? radiance / light.density : vec3(0.0);
    light.end = position + 8.0 * light.direction;
    return light;
}

// `inCell` is for maps of environments only.
LightSample sampleLight(vec3 position, uint emitterBits, uvec2 bits, vec2 inCell) {
    const Emitter emitter = loadEmitter(chooseEmitter(emitterBits, false));
    if (emitter.kind == kEmitterTriangle) return sampleTriangle(emitter, position, unitFloats(bits));
    if (emitter.kind == kEmitterEnvironment) return sampleEnvironment(position, bits, inCell);
    return sampleDeltaLight(emitter, position);
}

// Balance heuristic (Veach and Guibas 1995): the share of a sample drawn with `density` where the other technique has
// density `other`.
float misWeight(float density, float other) { return density / (density + other); }

#endif
