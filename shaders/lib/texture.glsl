// Textures without bindless: one texel buffer, filtered here. sRGB is decoded before filtering, as it should be.
#ifndef MANYLIGHT_TEXTURE_GLSL
#define MANYLIGHT_TEXTURE_GLSL
#include "shaders/shared/material.h"

layout(set = 0, binding = kBindingTextureInfos, scalar) readonly buffer TextureInfoBlock { TextureInfo textureInfos[]; };
layout(set = 0, binding = kBindingTexels, rgba8) readonly uniform imageBuffer texels;

vec3 linearFromSrgb(vec3 encoded) {
    const vec3 low = encoded / 12.92;
    const vec3 high = pow((encoded + 0.055) / 1.055, vec3(2.4));
    return mix(high, low, lessThanEqual(encoded, vec3(0.04045)));
}

// Maps an integer texel coordinate into [0, size) by the wrap mode.
int wrapTexel(int i, int size, uint clampBit, uint mirrorBit, uint mode) {
    if ((mode & clampBit) != 0u) return clamp(i, 0, size - 1);
    const int period = (mode & mirrorBit) != 0u ? 2 * size : size;
    int wrapped = i % period;
    wrapped += wrapped < 0 ? period : 0;
    return wrapped < size ? wrapped : period - 1 - wrapped;
}

vec4 texelAt(TextureInfo info, ivec2 texel) {
    const int x = wrapTexel(texel.x, int(info.width), kTextureClampU, kTextureMirrorU, info.mode);
    const int y = wrapTexel(texel.y, int(info.height), kTextureClampV, kTextureMirrorV, info.mode);
    const vec4 stored = imageLoad(texels, int(info.firstTexel) + y * int(info.width) + x);
    return (info.mode & kTextureLinear) != 0u ? stored : vec4(linearFromSrgb(stored.rgb), stored.a);
}

// Linear value at a surface's uvs (xy: the first set, zw: the second); texel centres at half-integers.
vec4 sampleTexture(uint index, vec4 uvs) {
    const TextureInfo info = textureInfos[index];
    const vec2 size = vec2(info.width, info.height);
    const vec2 set = (info.mode & kTextureUv1) != 0u ? uvs.zw : uvs.xy;
    const vec2 uv = mat2(info.uvMatrix.xy, info.uvMatrix.zw) * set + info.uvOffset;
    // fract() first: a uv of thousands would leave no bits for the position inside a texel.
    const vec2 inTile = (info.mode & (kTextureClampU | kTextureMirrorU | kTextureClampV | kTextureMirrorV)) == 0u
                            ? fract(uv) : clamp(uv, vec2(-1e4), vec2(1e4));
    if ((info.mode & kTextureNearest) != 0u) return texelAt(info, ivec2(floor(inTile * size)));
    const vec2 position = inTile * size - 0.5;
    const ivec2 corner = ivec2(floor(position));
    const vec2 weight = position - floor(position);
    const vec4 top = mix(texelAt(info, corner), texelAt(info, corner + ivec2(1, 0)), weight.x);
    const vec4 bottom = mix(texelAt(info, corner + ivec2(0, 1)), texelAt(info, corner + ivec2(1, 1)), weight.x);
    return mix(top, bottom, weight.y);
}

#endif
