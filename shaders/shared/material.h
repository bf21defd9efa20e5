#ifndef MANYLIGHT_SHARED_MATERIAL_H
#define MANYLIGHT_SHARED_MATERIAL_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_CONSTANT(uint, kNoTexture, 0xFFFFFFFFu);

// Material::alphaMode
MANYLIGHT_CONSTANT(uint, kAlphaOpaque, 0u);
MANYLIGHT_CONSTANT(uint, kAlphaMask, 1u);
MANYLIGHT_CONSTANT(uint, kAlphaBlend, 2u);

// Scene's Material, textures by their number in the list of TextureInfo.
struct Material {
    vec3 albedo;
    uint albedoTexture;
    vec3 emittedRadiance;
    uint emissionTexture;
    vec3 specular;
    float metallic;
    float roughness;
    uint metallicRoughnessTexture;
    uint normalTexture;
    float normalScale;
    uint alphaMode;
    float opacity;
    float alphaCutoff;
    uint opacityTexture;
    float meanEmission;  // mean channel of the emitted radiance, over its texture: what an emitter is chosen by
    uint isUnlit;
    uint isCulled;
    uint unused1;
};

// TextureInfo::mode, bit by bit.
MANYLIGHT_CONSTANT(uint, kTextureNearest, 1u);
MANYLIGHT_CONSTANT(uint, kTextureClampU, 2u);
MANYLIGHT_CONSTANT(uint, kTextureMirrorU, 4u);
MANYLIGHT_CONSTANT(uint, kTextureClampV, 8u);
MANYLIGHT_CONSTANT(uint, kTextureMirrorV, 16u);
MANYLIGHT_CONSTANT(uint, kTextureLinear, 32u);  // rgb is not sRGB encoded
MANYLIGHT_CONSTANT(uint, kTextureUv1, 64u);     // looked up by the second set of uvs

// A texture as one use of it sees it. The texels of all textures lie one behind the other in one buffer.
struct TextureInfo {
    uint firstTexel;
    uint width;
    uint height;
    uint mode;
    vec4 uvMatrix;  // columns
    vec2 uvOffset;
    uint firstReduced;  // texel: half as wide and high, rounded down, then half of that, and so on to a single texel
    uint levelCount;    // with the texture itself; 1: it is not mipmapped
};

MANYLIGHT_SHARED_END
#endif
