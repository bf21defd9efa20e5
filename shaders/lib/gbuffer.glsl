// The G-buffer's layout, 32 bytes a pixel: position as it is, normal as an octahedral pair of floats, albedo in 21 bits
// a channel. Fine enough that forward shading, which stores nothing, agrees to rounding. 16 bytes more where the scene
// has glossy surfaces.
#ifndef MANYLIGHT_GBUFFER_GLSL
#define MANYLIGHT_GBUFFER_GLSL
#include "shaders/lib/surface.glsl"

const float kAlbedoSteps = 2097151.0;  // 2^21 - 1

struct GBufferTexels { uvec4 position; uvec4 shading; uvec4 gloss; };

uvec2 packAlbedo(vec3 albedo) {
    const uvec3 steps = uvec3(clamp(albedo, 0.0, 1.0) * kAlbedoSteps + 0.5);
    return uvec2(steps.x | (steps.y << 21), (steps.y >> 11) | (steps.z << 10));
}

vec3 unpackAlbedo(uvec2 bits) {
    const uvec3 steps = uvec3(bits.x & 0x1fffffu, (bits.x >> 21) | ((bits.y & 0x3ffu) << 11), bits.y >> 10);
    return vec3(steps & 0x1fffffu) / kAlbedoSteps;
}

// The octahedral map (Cigolle et al. 2014) with nothing quantised.
vec2 octahedralFromUnit(vec3 n) {
    const vec2 square = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    const vec2 folded = (1.0 - abs(square.yx)) * vec2(signNotZero(square.x), signNotZero(square.y));
    return n.z < 0.0 ? folded : square;
}

vec3 unitFromOctahedral(vec2 square) {
    const float z = 1.0 - abs(square.x) - abs(square.y);
    const float fold = max(-z, 0.0);
    return normalize(vec3(square.x - signNotZero(square.x) * fold, square.y - signNotZero(square.y) * fold, z));
}

GBufferTexels packGBuffer(Surface surface, uint triangle) {
    GBufferTexels texels;
    texels.position = uvec4(floatBitsToUint(surface.position), triangle + 1u);
    texels.shading = uvec4(floatBitsToUint(octahedralFromUnit(surface.normal)), packAlbedo(surface.bsdf.diffuse));
    texels.gloss = uvec4(floatBitsToUint(surface.bsdf.f0), floatBitsToUint(surface.bsdf.alpha));
    return texels;
}

#endif
