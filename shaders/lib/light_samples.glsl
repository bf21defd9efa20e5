// The real lights as shading sees them: point, spot and directional lights as they are, area lights and the environment
// by stratified samples of the receiver's own, so that neighbouring pixels err independently.
#ifndef MANYLIGHT_LIGHT_SAMPLES_GLSL
#define MANYLIGHT_LIGHT_SAMPLES_GLSL
#include "shaders/lib/emitters.glsl"

const uint kDimensionOfLight = 0x10000u;
const uint kDimensionOnLight = 0x10001u;

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
    const vec3 emission = emitter.emission * weight;
    if (emitter.kind == kEmitterConstant) {
        // Uniform over the sphere: radiance / (1 / 4 pi) arrives as if it were parallel.
        LightData light = lightFrom(emission * (4.0 * kPi), kLightDirectional);
        light.direction = squareToCone(u, -1.0);
        return light;
    }
    LightData light = lightFrom(emission * emitter.area, kLightSurface);
    light.position = pointOnTriangle(emitter, u);
    light.direction = normalOfTriangle(emitter);
    return light;
}

// Sample s of this frame's lightSampleCount. `seed` tells receivers apart.
LightData sampleOfArea(uint s, uint seed) {
    const uint index = frame.frame * frame.lightSampleCount + s;
    const vec2 uEmitter = sample2d(index, seed, kDimensionOfLight);
    const vec2 uPoint = sample2d(index, seed, kDimensionOnLight);
    const Emitter emitter = emitters[chooseEmitter(uEmitter.x, true)];
    return sampleOfEmitter(emitter, uPoint, 1.0 / (emitter.areaProbability * float(frame.lightSampleCount)));
}

#endif
