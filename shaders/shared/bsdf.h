// Reflection of a surface: GGX microfacets (Walter et al. 2007) with height-correlated masking (Heitz 2014) and Schlick's
// Fresnel term, over a Lambertian base that gets what they let through (Kelemen and Szirmay-Kalos 2001). A Lambertian
// is the case f90 = 0. Directions are unit and point away from the surface.
#ifndef MANYLIGHT_SHARED_BSDF_H
#define MANYLIGHT_SHARED_BSDF_H
#include "shaders/shared/warps.h"

MANYLIGHT_SHARED_BEGIN
#ifdef __cplusplus
using glm::cross;
using glm::dot;
using glm::inversesqrt;
using glm::normalize;
#endif

struct Bsdf {
    vec3 diffuse;  // reflectance of the base
    float alpha;   // GGX's roughness, at least kSmallestAlpha
    vec3 f0;       // reflectance of the microfacets at normal incidence
    float f90;     // at grazing incidence; 0: there are none
};

// A mirror is this rough: the lobe's peak stays far inside single precision.
MANYLIGHT_CONSTANT(float, kSmallestAlpha, 1e-3f);

MANYLIGHT_FUNCTION float largestChannel(vec3 v) { return max(v.x, max(v.y, v.z)); }

MANYLIGHT_FUNCTION Bsdf lambertian(vec3 albedo) {
    Bsdf bsdf;
    bsdf.diffuse = albedo;
    bsdf.alpha = 1.0f;
    bsdf.f0 = vec3(0.0f);
    bsdf.f90 = 0.0f;
    return bsdf;
}

// Real surfaces reflect 2 % or more at normal incidence: what reflects less was made so by hand, and its reflection at
// grazing angles fades with it.
MANYLIGHT_FUNCTION float grazingReflectance(vec3 f0) { return min(50.0f * largestChannel(f0), 1.0f); }

// `specular`: reflectance at normal incidence of what is not metal.
MANYLIGHT_FUNCTION Bsdf metallicRoughness(vec3 albedo, float metallic, float roughness, vec3 specular) {
    Bsdf bsdf;
    bsdf.diffuse = albedo * (1.0f - metallic);
    bsdf.alpha = max(roughness * roughness, kSmallestAlpha);
    bsdf.f0 = specular + metallic * (albedo - specular);
    bsdf.f90 = grazingReflectance(bsdf.f0);
    return bsdf;
}

MANYLIGHT_FUNCTION float oneMinusToTheFifth(float cosine) {
    const float x = 1.0f - min(cosine, 1.0f);
    const float squared = x * x;
    return squared * squared * x;
}

// Of the channel that reflects most.
MANYLIGHT_FUNCTION float strongestFresnel(Bsdf bsdf, float cosine) {
    const float f0 = largestChannel(bsdf.f0);
    return f0 + (bsdf.f90 - f0) * oneMinusToTheFifth(cosine);
}

// Density of microfacet normals at h, over projected area.
MANYLIGHT_FUNCTION float microfacetDensity(float alpha, vec3 n, vec3 h) {
    const vec3 across = cross(n, h);  // as long as the sine, which 1 - cos^2 would lose
    const float cosine = dot(n, h);
    const float alphaSquared = alpha * alpha;
    const float stretched = dot(across, across) / alphaSquared + cosine * cosine;
    return kInvPi / (alphaSquared * stretched * stretched);
}

MANYLIGHT_FUNCTION float stretchedCosine(float alpha, float cosine) {
    const float alphaSquared = alpha * alpha;
    return sqrt(alphaSquared + (1.0f - alphaSquared) * cosine * cosine);
}

// f_r, per steradian. The microfacets show nothing where a direction is below the horizon of n.
MANYLIGHT_FUNCTION vec3 evaluateBsdf(Bsdf bsdf, vec3 n, vec3 incoming, vec3 outgoing) {
    if (bsdf.f90 == 0.0f) return kInvPi * bsdf.diffuse;
    const float cosIn = dot(n, incoming);
    const float cosOut = dot(n, outgoing);
    if (cosIn <= 0.0f || cosOut <= 0.0f) return vec3(0.0f);
    const float f0 = largestChannel(bsdf.f0);
    const float meanFresnel = f0 + (bsdf.f90 - f0) / 21.0f;  // over the hemisphere, by the cosine
    const float transmitted = (1.0f - strongestFresnel(bsdf, cosIn)) * (1.0f - strongestFresnel(bsdf, cosOut)) /
                              max(1.0f - meanFresnel, 1e-6f);
    const vec3 h = normalize(incoming + outgoing);
    const vec3 fresnel = bsdf.f0 + (vec3(bsdf.f90) - bsdf.f0) * oneMinusToTheFifth(max(dot(h, outgoing), 0.0f));
    const float visibility = 0.5f / (cosOut * stretchedCosine(bsdf.alpha, cosIn) +
                                     cosIn * stretchedCosine(bsdf.alpha, cosOut));
    return (kInvPi * transmitted) * bsdf.diffuse + (microfacetDensity(bsdf.alpha, n, h) * visibility) * fresnel;
}

// Probability that sampleBsdf() asks the microfacets.
MANYLIGHT_FUNCTION float specularShare(Bsdf bsdf, vec3 n, vec3 outgoing) {
    if (bsdf.f90 == 0.0f) return 0.0f;
    const float fresnel = strongestFresnel(bsdf, max(dot(n, outgoing), 0.0f));
    const float base = largestChannel(bsdf.diffuse) * (1.0f - fresnel);
    return fresnel / max(fresnel + base, 1e-6f);
}

// 1/sr, of the directions that sampleBsdf() returns.
MANYLIGHT_FUNCTION float bsdfDensity(Bsdf bsdf, vec3 n, vec3 incoming, vec3 outgoing) {
    const float cosIn = max(dot(n, incoming), 0.0f);
    const float cosOut = dot(n, outgoing);
    const float share = cosOut > 0.0f ? specularShare(bsdf, n, outgoing) : 0.0f;
    float density = (1.0f - share) * cosIn * kInvPi;
    if (share > 0.0f) {
        const vec3 h = normalize(incoming + outgoing);
        density += share * microfacetDensity(bsdf.alpha, n, h) /
                   (2.0f * (cosOut + stretchedCosine(bsdf.alpha, cosOut)));
    }
    return density;
}

// A microfacet normal among those that are seen from `outgoing` (Heitz 2018); both in the frame whose z is n.
// The disk is squeezed along the axis that leans most to z.
MANYLIGHT_FUNCTION vec3 visibleMicrofacet(float alpha, vec3 outgoing, vec2 u) {
    const vec3 stretched = normalize(vec3(alpha * outgoing.x, alpha * outgoing.y, outgoing.z));
    const vec2 disk = squareToDisk(u);
    const float s = 0.5f * (1.0f + stretched.z);
    const float x = disk.x;
    const float y = (1.0f - s) * sqrt(max(0.0f, 1.0f - x * x)) + s * disk.y;
    const float across = stretched.x * stretched.x + stretched.y * stretched.y;
    const vec3 level = across > 0.0f ? vec3(-stretched.y, stretched.x, 0.0f) * inversesqrt(across) : vec3(1.0f, 0.0f, 0.0f);
    const vec3 normal = x * level + y * cross(stretched, level) + sqrt(max(0.0f, 1.0f - x * x - y * y)) * stretched;
    return normalize(vec3(alpha * normal.x, alpha * normal.y, max(normal.z, 1e-6f)));
}

// An incoming direction for `outgoing`, by bsdfDensity(). It may lie below the horizon, where nothing is reflected.
MANYLIGHT_FUNCTION vec3 sampleBsdf(Bsdf bsdf, vec3 n, vec3 outgoing, float uLobe, vec2 u) {
    const bool isAbove = dot(n, outgoing) > 0.0f;
    if (isAbove && uLobe < specularShare(bsdf, n, outgoing)) {
        const vec3 tangent = basisTangent(n);
        const vec3 bitangent = basisBitangent(n);
        const vec3 local = vec3(dot(tangent, outgoing), dot(bitangent, outgoing), dot(n, outgoing));
        const vec3 h = normalize(toWorld(visibleMicrofacet(bsdf.alpha, local, u), n));
        return normalize(2.0f * dot(h, outgoing) * h - outgoing);
    }
    return normalize(toWorld(squareToCosineHemisphere(u), n));
}

MANYLIGHT_SHARED_END
#endif
