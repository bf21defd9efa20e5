// A point on a surface, from a triangle and barycentrics. Rays and raster meet surfaces through this one file.
#ifndef MANYLIGHT_SURFACE_GLSL
#define MANYLIGHT_SURFACE_GLSL
#include "shaders/lib/bvh.glsl"
#include "shaders/lib/texture.glsl"
#include "shaders/lib/triangle_numbers.glsl"
#include "shaders/shared/bsdf.h"
#include "shaders/shared/packing.h"

// Left out by ScenePlan where the scene has no such thing; 0 is in texture.glsl.
layout(constant_id = 1) const bool kShadingNormals = true;
layout(constant_id = 2) const bool kGlossy = true;            // reflection that depends on directions
layout(constant_id = 4) const bool kNormalMapped = true;
layout(constant_id = 5) const bool kVertexColours = true;
layout(constant_id = 6) const bool kEmissionTextured = true;  // emission that varies over a triangle
layout(constant_id = 7) const uint kUvSets = 2u;              // in the buffer
layout(constant_id = 8) const bool kCulled = true;            // back faces that the camera looks through

layout(set = 0, binding = kBindingTriangleMaterials, scalar) readonly buffer TriangleMaterialBlock { uint triangleMaterials[]; };
layout(set = 0, binding = kBindingTriangleUvs, scalar) readonly buffer TriangleUvBlock { vec2 triangleUvs[]; };
layout(set = 0, binding = kBindingTriangleColours, scalar) readonly buffer TriangleColourBlock { uvec2 triangleColours[]; };
layout(set = 0, binding = kBindingMaterials, scalar) readonly buffer MaterialBlock { Material materials[]; };

// Corners of a triangle: xyz is the position, w the packed shading normal, which stays in the frame of its mesh. `place`
// is where the triangle's uvs, colours and material are.
struct TriangleRecord { uvec4 corner0, corner1, corner2; uint place; uint instance; };

uvec4 placedCorner(uint instance, uvec4 corner) {
    const vec3 placed = placedInScene(floatsOf(instanceTexel(instance, 4)), floatsOf(instanceTexel(instance, 5)),
                                      floatsOf(instanceTexel(instance, 6)), floatsOf(instanceTexel(instance, 3)),
                                      floatsOf(corner));
    return uvec4(floatBitsToUint(placed), corner.w);
}

uint placeOf(uint triangle) {
    if (kInstanced == 0u) return triangle;
    return triangle - numberOffsetOf(instanceOf(triangle));
}

TriangleRecord loadTriangle(uint triangle) {
    const uint place = placeOf(triangle);
    const int first = int(place) * 3;
    TriangleRecord t = TriangleRecord(imageLoad(bvhTriangles, first), imageLoad(bvhTriangles, first + 1),
                                      imageLoad(bvhTriangles, first + 2), place, 0u);
    if (kInstanced == 0u) return t;
    const uint instance = lastInstance;
    t.instance = instance;
    t.corner0 = placedCorner(instance, t.corner0);
    t.corner1 = placedCorner(instance, t.corner1);
    t.corner2 = placedCorner(instance, t.corner2);
    return t;
}

struct Surface {
    vec3 position;
    vec3 geometricNormal;  // unit, on the side that `viewer` is on
    vec3 normal;           // unit shading normal, on the same side
    Bsdf bsdf;
    uint material;
    bool isFrontFacing;    // the viewer is on the counter-clockwise side
    bool isOpposed;        // the interpolated normal says otherwise
};

vec3 positionAt(TriangleRecord t, vec2 barycentrics) {
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    return p0 + barycentrics.x * (uintBitsToFloat(t.corner1.xyz) - p0) + barycentrics.y * (uintBitsToFloat(t.corner2.xyz) - p0);
}

float areaOf(TriangleRecord t) {
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    return max(0.5 * length(cross(uintBitsToFloat(t.corner1.xyz) - p0, uintBitsToFloat(t.corner2.xyz) - p0)), 1e-30);
}

// Unit normal of the counter-clockwise side. The edges are scaled first: the cross product of two short ones would
// underflow.
vec3 counterClockwiseNormal(TriangleRecord t) {
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    vec3 e1 = uintBitsToFloat(t.corner1.xyz) - p0;
    vec3 e2 = uintBitsToFloat(t.corner2.xyz) - p0;
    e1 /= max(max(abs(e1.x), abs(e1.y)), max(abs(e1.z), 1e-30));
    e2 /= max(max(abs(e2.x), abs(e2.y)), max(abs(e2.z), 1e-30));
    const vec3 n = cross(e1, e2);
    const float squared = dot(n, n);
    return squared > 0.0 ? n * inversesqrt(squared) : vec3(0.0, 0.0, 1.0);
}

// From a mesh to the scene, to be normalised: by the cofactors where instances stretch, else as any direction. On which
// side it comes out does not matter, see surfaceAt().
vec3 normalInScene(uint instance, vec3 normal) {
    const vec3 row0 = floatsOf(instanceTexel(instance, 4));
    const vec3 row1 = floatsOf(instanceTexel(instance, 5));
    const vec3 row2 = floatsOf(instanceTexel(instance, 6));
    if (kInstanced == 1u) return placedInScene(row0, row1, row2, vec3(0.0), normal);
    const vec3 n = placedInScene(cross(row1, row2), cross(row2, row0), cross(row0, row1), vec3(0.0), normal);
    return n / max(max(abs(n.x), abs(n.y)), max(abs(n.z), 1e-30));
}

vec3 shadingNormalAt(TriangleRecord t, vec2 barycentrics, vec3 geometric) {
    if (!kShadingNormals || t.corner0.w == kNoNormal) return geometric;  // a flat triangle has none in any corner
    vec3 n0 = unpackUnitVector(t.corner0.w);
    vec3 n1 = unpackUnitVector(t.corner1.w);
    vec3 n2 = unpackUnitVector(t.corner2.w);
    if (kInstanced == 2u) {
        n0 = normalize(normalInScene(t.instance, n0));
        n1 = normalize(normalInScene(t.instance, n1));
        n2 = normalize(normalInScene(t.instance, n2));
    }
    vec3 n = (1.0 - barycentrics.x - barycentrics.y) * n0 + barycentrics.x * n1 + barycentrics.y * n2;
    const float squared = dot(n, n);
    if (kInstanced == 1u) n = normalInScene(t.instance, n);
    return squared > 1e-12 ? n * inversesqrt(kInstanced == 1u ? dot(n, n) : squared) : geometric;
}

vec2 cornerUv(uint place, uint corner, uint set) {
    return triangleUvs[(place * 3u + corner) * kUvSets + set];
}

vec2 uvAt(uint place, vec2 barycentrics, uint set) {
    const vec2 uv0 = cornerUv(place, 0u, set);
    return uv0 + barycentrics.x * (cornerUv(place, 1u, set) - uv0) + barycentrics.y * (cornerUv(place, 2u, set) - uv0);
}

// Twice a triangle's area in a set of uvs.
float uvAreaOf(uint place, uint set) {
    const vec2 uv0 = cornerUv(place, 0u, set);
    const mat2 edges = mat2(cornerUv(place, 1u, set) - uv0, cornerUv(place, 2u, set) - uv0);
    return abs(determinant(edges));
}

vec4 uvsAt(uint place, vec2 barycentrics) {
    if (!kTextured) return vec4(0.0);
    return vec4(uvAt(place, barycentrics, 0u), kUvSets > 1u ? uvAt(place, barycentrics, 1u) : vec2(0.0));
}

vec4 cornerColour(uint place, uint corner) {
    const uvec2 bits = triangleColours[place * 3u + corner];
    return vec4(unpackUnorm2x16(bits.x), unpackUnorm2x16(bits.y));
}

vec4 vertexColourAt(uint place, vec2 barycentrics) {
    if (!kVertexColours) return vec4(1.0);
    const vec4 c0 = cornerColour(place, 0u);
    return c0 + barycentrics.x * (cornerColour(place, 1u) - c0) + barycentrics.y * (cornerColour(place, 2u) - c0);
}

// Does the camera look through that side of the triangle?
bool isCulledFrom(uint triangle, vec3 toViewer) {
    if (!kCulled) return false;
    const TriangleRecord t = loadTriangle(triangle);
    return materials[triangleMaterials[t.place]].isCulled != 0u && dot(counterClockwiseNormal(t), toViewer) < 0.0;
}

// The texture's value there, 1 where there is none.
vec4 texturedBy(uint texture, vec4 uvs, vec2 footprint) {
    return kTextured && texture != kNoTexture ? sampleTexture(texture, uvs, footprint) : vec4(1.0);
}

vec3 albedoAt(uint place, vec2 barycentrics, uint material, vec2 footprint) {
    return materials[material].albedo *
           texturedBy(materials[material].albedoTexture, uvsAt(place, barycentrics), footprint).rgb *
           vertexColourAt(place, barycentrics).rgb;
}

// Radiance that the front side emits.
vec3 emittedRadianceAt(uint place, vec2 barycentrics, uint material, vec2 footprint) {
    const vec3 radiance = materials[material].emittedRadiance;
    if (!kEmissionTextured || radiance == vec3(0.0)) return radiance;
    return radiance * texturedBy(materials[material].emissionTexture, uvsAt(place, barycentrics), footprint).rgb;
}

// What of a material that is not opaque is there, in [0, 1].
float coverageAt(uint place, vec2 barycentrics, uint material) {
    const float opacity = materials[material].opacity *
                          texturedBy(materials[material].opacityTexture, uvsAt(place, barycentrics), kNoFootprint).a *
                          vertexColourAt(place, barycentrics).a;
    if (materials[material].alphaMode == kAlphaMask) return opacity >= materials[material].alphaCutoff ? 1.0 : 0.0;
    return opacity;
}

// In bvh.glsl's terms: does a ray, or the camera, go through the triangle here? `u` is uniform in [0, 1).
bool isTransparentAt(uint place, vec2 barycentrics, float u) {
    const uint material = triangleMaterials[place];
    return materials[material].alphaMode != kAlphaOpaque && u >= coverageAt(place, barycentrics, material);
}

bool letsThrough(uint place, vec2 barycentrics, uint ray) {
    const uint key = hashCombine(hashCombine(hashCombine(ray, frame.seed), frame.frame), place);
    return isTransparentAt(place, barycentrics, float(key >> 8) * (1.0 / 16777216.0));
}

// Tilts `n` by the material's normal map. Tangent and bitangent go along the texture's u and v; they need not be
// perpendicular, and mirrored uvs mirror them.
vec3 mappedNormal(TriangleRecord t, vec2 barycentrics, uint material, vec3 n, vec2 footprint) {
    const uint texture = materials[material].normalTexture;
    if (!kNormalMapped || texture == kNoTexture) return n;
    const uint set = (textureInfos[texture].mode & kTextureUv1) != 0u ? 1u : 0u;
    const mat2 uvMatrix = mat2(textureInfos[texture].uvMatrix.xy, textureInfos[texture].uvMatrix.zw);
    const vec2 uv0 = cornerUv(t.place, 0u, set);
    const vec2 duv1 = uvMatrix * (cornerUv(t.place, 1u, set) - uv0);
    const vec2 duv2 = uvMatrix * (cornerUv(t.place, 2u, set) - uv0);
    const float det = duv1.x * duv2.y - duv1.y * duv2.x;
    if (det == 0.0) return n;
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    const vec3 e1 = uintBitsToFloat(t.corner1.xyz) - p0;
    const vec3 e2 = uintBitsToFloat(t.corner2.xyz) - p0;
    const float side = det < 0.0 ? -1.0 : 1.0;
    vec3 alongU = side * (duv2.y * e1 - duv1.y * e2);
    alongU -= dot(alongU, n) * n;
    const float squared = dot(alongU, alongU);
    if (squared == 0.0) return n;
    const vec3 tangent = alongU * inversesqrt(squared);
    const vec3 towardsV = side * (duv1.x * e2 - duv2.x * e1);
    const vec3 across = cross(n, tangent);
    // Green points up in the picture: against v, which grows with its rows.
    const vec3 bitangent = dot(across, towardsV) > 0.0 ? -across : across;
    const vec3 texel = 2.0 * texturedBy(texture, uvsAt(t.place, barycentrics), footprint).rgb - 1.0;
    const vec3 tilted = materials[material].normalScale * (texel.x * tangent + texel.y * bitangent) + texel.z * n;
    const float length2 = dot(tilted, tilted);
    return length2 > 1e-12 ? tilted * inversesqrt(length2) : n;
}

Bsdf bsdfAt(uint place, vec2 barycentrics, uint material, vec2 footprint) {
    const vec3 albedo = albedoAt(place, barycentrics, material, footprint);
    if (!kGlossy) return lambertian(albedo);
    const vec4 roughMetal =
        texturedBy(materials[material].metallicRoughnessTexture, uvsAt(place, barycentrics), footprint);
    return metallicRoughness(albedo, materials[material].metallic * roughMetal.b,
                             materials[material].roughness * roughMetal.g, materials[material].specular);
}

// `toViewer` points away from the surface, to where the ray came from; it need not be unit.
// Normals are turned to the viewer's side, a two-sided reflector: the geometric one, which cannot be wrong about sides,
// and the shading normal with it. That is how light paths meet surfaces; see also asSeenByCamera().
Surface surfaceAt(TriangleRecord t, vec2 barycentrics, vec3 toViewer, vec2 footprint) {
    const vec3 counterClockwise = counterClockwiseNormal(t);
    const uint material = triangleMaterials[t.place];
    vec3 shading = shadingNormalAt(t, barycentrics, counterClockwise);
    // The map belongs to the front of the surface.
    shading = dot(shading, counterClockwise) < 0.0 ? -shading : shading;
    const bool isFrontByShading = dot(shading, toViewer) > 0.0;
    shading = mappedNormal(t, barycentrics, material, shading, footprint);
    Surface surface;
    surface.position = positionAt(t, barycentrics);
    surface.isFrontFacing = dot(counterClockwise, toViewer) > 0.0;
    surface.geometricNormal = surface.isFrontFacing ? counterClockwise : -counterClockwise;
    surface.normal = dot(shading, surface.geometricNormal) < 0.0 ? -shading : shading;
    surface.isOpposed = isFrontByShading != surface.isFrontFacing;
    surface.material = material;
    surface.bsdf = bsdfAt(t.place, barycentrics, material, footprint);
    if (materials[material].isUnlit != 0u) surface.bsdf = lambertian(vec3(0.0));
    return surface;
}

Surface surfaceAt(uint triangle, vec2 barycentrics, vec3 toViewer) {
    return surfaceAt(loadTriangle(triangle), barycentrics, toViewer, kNoFootprint);
}

// Where the camera meets a surface, the side it sees is told by the interpolated normal. At the rim of a coarse round
// body, which shows faces whose normals look away, a renderer that evaluates reflectances in the shading frame alone
// does the same. Light paths keep the geometric side: to ask a VPL for both would cost every pair of pixel and VPL.
Surface asSeenByCamera(Surface surface) {
    if (kShadingNormals && surface.isOpposed) surface.normal = -surface.normal;
    return surface;
}

#endif
