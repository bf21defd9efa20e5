// The G-buffer as the lighting passes read it.
#ifndef MANYLIGHT_GBUFFER_READ_GLSL
#define MANYLIGHT_GBUFFER_READ_GLSL
#include "shaders/lib/gbuffer.glsl"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/vpl_shading.glsl"

layout(set = 0, binding = kBindingGBufferPosition, rgba32ui) readonly uniform uimage2D gbufferPosition;
layout(set = 0, binding = kBindingGBufferShading, rgba32ui) readonly uniform uimage2D gbufferShading;
layout(set = 0, binding = kBindingGBufferGloss, rgba32ui) readonly uniform uimage2D gbufferGloss;

struct GBufferPixel {
    bool isSurface;
    uint triangle;
    Receiver receiver;  // zero normal where no surface is
};

// `withGeometricNormal`: costs the triangle's corners; needed by rays only.
GBufferPixel readGBuffer(ivec2 pixel, bool withGeometricNormal) {
    const ivec2 inside = min(pixel, ivec2(frame.imageSize) - 1);
    const uvec4 position = imageLoad(gbufferPosition, inside);
    const uvec4 shading = imageLoad(gbufferShading, inside);
    GBufferPixel result;
    result.isSurface = position.w != 0u;
    result.triangle = max(position.w, 1u) - 1u;
    result.receiver.position = uintBitsToFloat(position.xyz);
    result.receiver.normal = result.isSurface ? unitFromOctahedral(uintBitsToFloat(shading.xy)) : vec3(0.0);
    result.receiver.geometricNormal = result.receiver.normal;
    if (withGeometricNormal) {
        const vec3 counterClockwise = counterClockwiseNormal(loadTriangle(result.triangle));
        const bool isFront = dot(counterClockwise, cameraDirection(inside)) < 0.0;
        result.receiver.geometricNormal = isFront ? counterClockwise : -counterClockwise;
    }
    result.receiver.toViewer = -normalize(cameraDirection(inside));
    result.receiver.bsdf = lambertian(result.isSurface ? unpackAlbedo(shading.zw) : vec3(0.0));
    if (kGlossy) {
        const vec4 gloss = uintBitsToFloat(imageLoad(gbufferGloss, inside));
        result.receiver.bsdf.f0 = gloss.xyz;
        result.receiver.bsdf.f90 = grazingReflectance(gloss.xyz);
        result.receiver.bsdf.alpha = gloss.w;
    }
    return result;
}

#endif
