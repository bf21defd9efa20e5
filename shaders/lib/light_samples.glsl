// The real lights as shading sees them: point, spot and directional lights as they are, area lights and the environment
// by stratified samples of the receiver's own, so that neighbouring pixels err independently.
#ifndef MANYLIGHT_LIGHT_SAMPLES_GLSL
#define MANYLIGHT_LIGHT_SAMPLES_GLSL
#include "shaders/lib/emitter_radiance.glsl"

const uint kDimensionOfLight = 0x10000u;
const uint kDimensionOnLight = 0x10001u;
const uint kDimensionReflected = 0x10002u;

LightData lightFrom(vec3 spectrum, uint kind) {
    LightData light;
    light.position = vec3(0.0);
    light.intensity = max(spectrum.x, max(spectrum.y, spectrum.z));
    light.direction = vec3(0.0, 0.0, 1.0);
    light.kind = kind;
    light.colour = light.intensity > 0.0 ? spectrum / light.intensity : vec3(0.0);
    light.cosCutoff = 0.0;
    light.cosBeam = 1.0;
    light.depth = 0u;
    light.pathIndex = 0u;
    light.unused = 0u;
    return light;
}

LightData deltaLight(Emitter emitter) {
    LightData light = lightFrom(emitter.emission, emitter.kind);
    light.position = emitter.position;
    light.direction = emitter.edge1;
    light.cosCutoff = emitter.cosCutoff;
    light.cosBeam = emitter.cosBeam;
    return light;
}

// A point on an area light, or a direction of the environment, as a light. `weight` is 1 / (probability of the emitter *
// number of samples).
LightData sampleOfEmitter(Emitter emitter, vec2 u, float weight) {
    if (emitter.kind == kEmitterConstant) {
        // Uniform over the sphere: radiance / (1 / 4 pi) arrives as if it were parallel.
        LightData light = lightFrom(emitter.emission * weight * (4.0 * kPi), kLightDirectional);
        light.direction = squareToCone(u, -1.0);
        return light;
    }
    LightData light = lightFrom(radianceOfTriangle(emitter, u) * weight * emitter.area, kLightSurface);
    light.position = pointOnTriangle(emitter, u);
    light.direction = normalOfTriangle(emitter);
    return light;
}

// A sample among several of the same kind. `density` of them all: per area of a triangle, per solid angle of the
// environment.
struct AreaSample {
    LightData light;
    float density;
};

// Sample s of this frame's lightSampleCount. `seed` tells receivers apart.
AreaSample sampleOfArea(uint s, uint seed) {
    const uint index = frame.frame * frame.lightSampleCount + s;
    const vec2 uEmitter = sample2d(index, seed, kDimensionOfLight);
    const vec2 uPoint = sample2d(index, seed, kDimensionOnLight);
    const Emitter emitter = emitters[chooseEmitter(uEmitter.x, true)];
    const float density = emitter.areaProbability * float(frame.lightSampleCount);
    return AreaSample(sampleOfEmitter(emitter, uPoint, 1.0 / density),
                      density / (emitter.kind == kEmitterTriangle ? emitter.area : 4.0 * kPi));
}

// Per solid angle at `position`.
float densityOfSample(AreaSample area, vec3 position) {
    if (area.light.kind == kLightDirectional) return area.density;
    const vec3 toLight = area.light.position - position;
    const float squaredDistance = max(dot(toLight, toLight), 1e-30);
    const float cosLight = -dot(area.light.direction, toLight) * inversesqrt(squaredDistance);
    return area.density * squaredDistance / max(cosLight, 1e-20);
}

// What a ray meets that shines by itself, and the density that sampleOfArea() has for it.
struct EmissionMet {
    vec3 radiance;
    float density;  // 1/sr, of all samples of a receiver
};

EmissionMet emissionMetBy(Hit hit, vec3 direction) {
    const float count = float(frame.lightSampleCount);
    if (hit.triangle == kNoHit)
        return EmissionMet(frame.environmentRadiance, count * frame.areaEnvironmentProbability / (4.0 * kPi));
    const TriangleRecord t = loadTriangle(hit.triangle);
    const uint material = triangleMaterials[t.place];
    const float cosLight = -dot(counterClockwiseNormal(t), direction);
    if (cosLight <= 0.0) return EmissionMet(vec3(0.0), 0.0);
    const float area = areaOf(t);
    const float probability = frame.areaPowerShare * kPi * area * materials[material].meanEmission + frame.areaEqualShare;
    return EmissionMet(emittedRadianceAt(t.place, hit.barycentrics, material),
                       count * probability / area * hit.t * hit.t / cosLight);
}

// Balance heuristic: what a sample of the lights counts where sampling the reflectance has the other density.
float shareOfLightSample(float lightDensity, float bsdfDensity) { return lightDensity / max(lightDensity + bsdfDensity, 1e-30); }

#endif
