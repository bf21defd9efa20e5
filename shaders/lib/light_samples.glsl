// The real lights as shading sees them: point, spot and directional lights as they are, area lights and the environment
// by stratified samples of the receiver's own, so that neighbouring pixels err independently.
#ifndef MANYLIGHT_LIGHT_SAMPLES_GLSL
#define MANYLIGHT_LIGHT_SAMPLES_GLSL
#include "shaders/lib/emitter_radiance.glsl"

layout(constant_id = 22) const uint kAreaCandidates = 1u;  // for every ray to an area light

const uint kDimensionOfLight = 0x10000u;
const uint kDimensionOnLight = 0x10001u;
const uint kDimensionReflected = 0x10002u;
const uint kDimensionInCell = 0x10004u;
const uint kDimensionOfCandidate = 0x10005u;

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
    light.inverseRange = 0.0;
    return light;
}

LightData deltaLight(Emitter emitter) {
    LightData light = lightFrom(emitter.emission, emitter.kind);
    light.position = emitter.position;
    light.direction = emitter.edge1;
    light.cosCutoff = emitter.cosCutoff;
    light.cosBeam = emitter.cosBeam;
    light.inverseRange = emitter.inverseRange;
    return light;
}

// A point on an area light, or a direction of the environment, as a light, and the density of the choice: per area of a
// triangle, per solid angle of the environment.
struct AreaSample {
    LightData light;
    float density;
};

// Radiance over density arrives as if it were parallel. Without a map: uniform over the sphere, density 1 / 4 pi.
AreaSample sampleOfEnvironment(Emitter emitter, uvec2 bits, vec2 inCell, float probability) {
    if (!kEnvironmentMapped) {
        LightData light = lightFrom(emitter.emission * (1.0 / probability) * (4.0 * kPi), kLightDirectional);
        light.direction = squareToCone(unitFloats(bits), -1.0);
        return AreaSample(light, probability / (4.0 * kPi));
    }
    const EnvironmentSample drawn = sampleEnvironmentMap(bits, inCell);
    const float density = probability * drawn.density;
    LightData light = lightFrom(density > 0.0 ? drawn.radiance / density : vec3(0.0), kLightDirectional);
    light.direction = -drawn.direction;
    return AreaSample(light, density);
}

// `probability`: of the emitter, times the number of samples. `inCell` is for maps of environments only.
AreaSample sampleOfEmitter(Emitter emitter, uvec2 bits, vec2 inCell, float probability) {
    if (emitter.kind == kEmitterEnvironment) return sampleOfEnvironment(emitter, bits, inCell, probability);
    const vec2 u = unitFloats(bits);
    LightData light = lightFrom(radianceOfTriangle(emitter, u) * (1.0 / probability) * emitter.area, kLightSurface);
    light.position = pointOnTriangle(emitter, u);
    light.direction = normalOfTriangle(emitter);
    return AreaSample(light, probability / emitter.area);
}

// Two numbers for a place in a cell of the environment's map; costs nothing without one.
vec2 sampleInCell(uint index, uint seed, uint dimension) {
    return kEnvironmentMapped ? sample2d(index, seed, dimension) : vec2(0.0);
}

// Candidate c for sample s of this frame's lightSampleCount: the sum over candidates is an estimate of all area lights.
// `seed` tells receivers apart.
AreaSample candidateOfArea(uint s, uint c, uint seed) {
    const uint count = frame.lightSampleCount * kAreaCandidates;
    const uint index = frame.frame * count + s * kAreaCandidates + c;
    const Emitter emitter = loadEmitter(chooseEmitter(sampleBits(index, seed, kDimensionOfLight).x, true));
    return sampleOfEmitter(emitter, sampleBits(index, seed, kDimensionOnLight),
                           sampleInCell(index, seed, kDimensionInCell),
                           emitter.areaProbability * float(count));
}

// Per solid angle at `position`.
float densityOfSample(AreaSample area, vec3 position) {
    if (area.light.kind == kLightDirectional) return area.density;
    const vec3 toLight = area.light.position - position;
    const float squaredDistance = max(dot(toLight, toLight), 1e-30);
    const float cosLight = -dot(area.light.direction, toLight) * inversesqrt(squaredDistance);
    return area.density * squaredDistance / max(cosLight, 1e-20);
}

// What a ray meets that shines by itself, and the density that candidateOfArea() has for it.
struct EmissionMet {
    vec3 radiance;
    float density;  // 1/sr, of all candidates of a receiver
};

EmissionMet emissionMetBy(Hit hit, vec3 direction) {
    const float count = float(frame.lightSampleCount * kAreaCandidates);
    if (hit.triangle == kNoHit) {
        const float chosen = count * frame.areaEnvironmentProbability;
        const float density = kEnvironmentMapped ? chosen * densityOfEnvironmentMap(direction) : chosen / (4.0 * kPi);
        return EmissionMet(radianceOfEnvironment(direction), density);
    }
    const TriangleRecord t = loadTriangle(hit.triangle);
    const uint material = triangleMaterials[t.place];
    const float cosLight = -dot(counterClockwiseNormal(t), direction);
    if (cosLight <= 0.0) return EmissionMet(vec3(0.0), 0.0);
    const float area = areaOf(t);
    const float probability = frame.areaPowerShare * kPi * area * materials[material].meanEmission + frame.areaEqualShare;
    return EmissionMet(emittedRadianceAt(t.place, hit.barycentrics, material, kNoFootprint),
                       count * probability / area * hit.t * hit.t / cosLight);
}

// Balance heuristic: what a sample of the lights counts where sampling the reflectance has the other density.
float shareOfLightSample(float lightDensity, float bsdfDensity) { return lightDensity / max(lightDensity + bsdfDensity, 1e-30); }

#endif
