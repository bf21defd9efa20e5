// The loop over the real lights, for deferred and forward shading alike.
#ifndef MANYLIGHT_SHADE_LIGHTS_GLSL
#define MANYLIGHT_SHADE_LIGHTS_GLSL
#include "shaders/lib/arriving.glsl"
#include "shaders/lib/light_samples.glsl"

// Irradiance of entries [first, first + count) of: point, spot and directional lights, then samples of area lights.
vec3 irradianceOfLights(Receiver receiver, uint seed, uint first, uint count) {
    const uint deltaLightCount = frame.deltaLightCount;
    vec3 irradiance = vec3(0.0);
    for (uint i = first; i < min(first + count, deltaLightCount); ++i) {
        const LightData light = deltaLight(emitters[i]);
        irradiance += arriving(irradianceOfLight(receiver, light), receiver, light);
    }
    for (uint i = max(first, deltaLightCount); i < first + count; ++i) {
        const LightData light = sampleOfArea(i - deltaLightCount, seed);
        irradiance += arriving(irradianceOfLight(receiver, light), receiver, light);
    }
    return irradiance;
}

#endif
