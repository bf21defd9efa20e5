#ifndef MANYLIGHT_SHARED_MATERIAL_H
#define MANYLIGHT_SHARED_MATERIAL_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kNoTexture, 0xFFFFFFFFu);

struct Material {
    vec3 albedo;
    uint albedoTexture;  // index of a TextureInfo, or kNoTexture
    vec3 emittedRadiance;
    uint unused;
};

// Texture::mode, bit by bit.
MANYLIGHT_CONSTANT(uint, kTextureNearest, 1u);
MANYLIGHT_CONSTANT(uint, kTextureClampU, 2u);
MANYLIGHT_CONSTANT(uint, kTextureMirrorU, 4u);
MANYLIGHT_CONSTANT(uint, kTextureClampV, 8u);
MANYLIGHT_CONSTANT(uint, kTextureMirrorV, 16u);

// All textures live one behind the other in one texel buffer.
struct TextureInfo {
    uint firstTexel;
    uint width;
    uint height;
    uint mode;
};

MANYLIGHT_SHARED_END
#endif
