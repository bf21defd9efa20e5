// Textures without bindless: one texel buffer, filtered here. sRGB is decoded before filtering, as it should be.
#ifndef MANYLIGHT_TEXTURE_GLSL
#define MANYLIGHT_TEXTURE_GLSL
#include "shaders/shared/material.h"

layout(constant_id = 0) const uint kTextures = 2u;  // 0: there are none; 2: some are mipmapped
const bool kTextured = kTextures != 0u;
const bool kMipmapped = kTextures == 2u;

// Areas, in the first and the second uvs, over which a texture is averaged. None: for all but the camera.
const vec2 kNoFootprint = vec2(0.0);

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

// One of the versions of a texture, and where the next smaller one begins.
struct TextureLevel { uint firstTexel; ivec2 size; uint next; };

TextureLevel smaller(TextureLevel level) {
    const ivec2 size = max(level.size / 2, ivec2(1));
    return TextureLevel(level.next, size, level.next + uint(size.x * size.y));
}

vec4 texelAt(TextureInfo info, TextureLevel level, ivec2 texel) {
    const int x = wrapTexel(texel.x, level.size.x, kTextureClampU, kTextureMirrorU, info.mode);
    const int y = wrapTexel(texel.y, level.size.y, kTextureClampV, kTextureMirrorV, info.mode);
    const vec4 stored = imageLoad(texels, int(level.firstTexel) + y * level.size.x + x);
    return (info.mode & kTextureLinear) != 0u ? stored : vec4(linearFromSrgb(stored.rgb), stored.a);
}

// Between four texels, whose centres are at half-integers.
vec4 interpolatedAt(TextureInfo info, TextureLevel level, vec2 inTile) {
    const vec2 position = inTile * vec2(level.size) - 0.5;
    const ivec2 corner = ivec2(floor(position));
    const vec2 weight = position - floor(position);
    const vec4 top = mix(texelAt(info, level, corner), texelAt(info, level, corner + ivec2(1, 0)), weight.x);
    const vec4 bottom = mix(texelAt(info, level, corner + ivec2(0, 1)), texelAt(info, level, corner + ivec2(1, 1)), weight.x);
    return mix(top, bottom, weight.y);
}

// How many times the texture is to be halved until a texel is as large as the footprint (AkenineMoller2021); not
// above zero where it is seen from near.
float levelOfDetail(TextureInfo info, vec2 footprint) {
    const float uvArea = (info.mode & kTextureUv1) != 0u ? footprint.y : footprint.x;
    const float scale = abs(info.uvMatrix.x * info.uvMatrix.w - info.uvMatrix.y * info.uvMatrix.z);
    return 0.5 * log2(max(uvArea * scale * float(info.width) * float(info.height), 1e-30));
}

// Between two levels (Williams1983).
vec4 reducedAt(TextureInfo info, TextureLevel level, vec2 inTile, float detail) {
    const float clamped = min(detail, float(info.levelCount - 1u));
    for (uint i = 1u; i <= uint(clamped); ++i) level = smaller(level);
    const vec4 fine = interpolatedAt(info, level, inTile);
    if (fract(clamped) == 0.0) return fine;  // there is none that is smaller than the last
    return mix(fine, interpolatedAt(info, smaller(level), inTile), fract(clamped));
}

// Linear value at a surface's uvs (xy: the first set, zw: the second).
vec4 sampleTexture(uint index, vec4 uvs, vec2 footprint) {
    const TextureInfo info = textureInfos[index];
    const vec2 set = (info.mode & kTextureUv1) != 0u ? uvs.zw : uvs.xy;
    const vec2 uv = mat2(info.uvMatrix.xy, info.uvMatrix.zw) * set + info.uvOffset;
    // fract() first: a uv of thousands would leave no bits for the position inside a texel.
    const vec2 inTile = (info.mode & (kTextureClampU | kTextureMirrorU | kTextureClampV | kTextureMirrorV)) == 0u
                            ? fract(uv) : clamp(uv, vec2(-1e4), vec2(1e4));
    const TextureLevel level = TextureLevel(info.firstTexel, ivec2(info.width, info.height), info.firstReduced);
    if (kMipmapped && footprint != kNoFootprint && info.levelCount > 1u) {
        const float detail = levelOfDetail(info, footprint);
        if (detail > 0.0) return reducedAt(info, level, inTile, detail);
    }
    if ((info.mode & kTextureNearest) != 0u) return texelAt(info, level, ivec2(floor(inTile * vec2(level.size))));
    return interpolatedAt(info, level, inTile);
}

#endif
