// The real lights as the shading loops read them: point, spot and directional lights as they are, area lights and the
// environment by stratified samples, each with the weight 1 / (count * pdf).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/emitters.glsl"
#include "shaders/shared/vpl_emission.h"

layout(local_size_x = kEmissionGroupSize) in;
layout(set = 0, binding = kBindingLights, scalar) writeonly buffer LightBlock { LightData lights[]; };

const uint kDimensionEmitter = 0x10000u;
const uint kDimensionPoint = 0x10001u;

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

LightData sampleOfArea(uint i) {
    const uint index = frame.frame * frame.lightSampleCount + i;
    const vec2 uEmitter = sample2d(index, frame.seed, kDimensionEmitter);
    const vec2 uPoint = sample2d(index, frame.seed, kDimensionPoint);
    const Emitter emitter = emitters[chooseEmitter(uEmitter.x, true)];
    const vec3 weight = emitter.emission / (emitter.areaProbability * float(frame.lightSampleCount));
    if (emitter.kind == kEmitterConstant) {
        // Uniform over the sphere: radiance / (1 / 4 pi) arrives as if it were parallel.
        LightData light = lightFrom(weight * (4.0 * kPi), kLightDirectional);
        light.direction = squareToCone(uPoint, -1.0);
        return light;
    }
    LightData light = lightFrom(weight * emitter.area, kLightSurface);
    light.position = pointOnTriangle(emitter, uPoint);
    light.direction = normalOfTriangle(emitter);
    return light;
}

void main() {
    const uint i = gl_GlobalInvocationID.x;
    if (i >= frame.deltaLightCount + frame.lightSampleCount) return;
    if (i < frame.deltaLightCount) lights[i] = deltaLight(emitters[i]);
    else lights[i] = sampleOfArea(i - frame.deltaLightCount);
}
