// A point on a surface, from a triangle and barycentrics. Rays and raster meet surfaces through this one file.
#ifndef MANYLIGHT_SURFACE_GLSL
#define MANYLIGHT_SURFACE_GLSL
#include "shaders/lib/bvh.glsl"
#include "shaders/lib/texture.glsl"
#include "shaders/shared/packing.h"

// Left out by ScenePlan where the scene has no textures, no shading normals.
layout(constant_id = 0) const bool kTextured = true;
layout(constant_id = 1) const bool kShadingNormals = true;

layout(set = 0, binding = kBindingTriangleMaterials, scalar) readonly buffer TriangleMaterialBlock { uint triangleMaterials[]; };
layout(set = 0, binding = kBindingTriangleUvs, scalar) readonly buffer TriangleUvBlock { vec2 triangleUvs[]; };
layout(set = 0, binding = kBindingMaterials, scalar) readonly buffer MaterialBlock { Material materials[]; };

// Corners of a triangle: xyz is the position, w the packed shading normal.
struct TriangleRecord { uvec4 corner0, corner1, corner2; };

TriangleRecord loadTriangle(uint triangle) {
    const int first = int(triangle) * 3;
    return TriangleRecord(imageLoad(bvhTriangles, first), imageLoad(bvhTriangles, first + 1),
                          imageLoad(bvhTriangles, first + 2));
}

struct Surface {
    vec3 position;
    vec3 geometricNormal;  // unit, on the side that `viewer` is on
    vec3 normal;           // unit shading normal, on the same side
    vec3 albedo;
    uint material;
    bool isFrontFacing;    // the viewer is on the counter-clockwise side
};

vec3 positionAt(TriangleRecord t, vec2 barycentrics) {
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    return p0 + barycentrics.x * (uintBitsToFloat(t.corner1.xyz) - p0) + barycentrics.y * (uintBitsToFloat(t.corner2.xyz) - p0);
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

vec3 shadingNormalAt(TriangleRecord t, vec2 barycentrics, vec3 geometric) {
    if (!kShadingNormals || t.corner0.w == kNoNormal) return geometric;  // a flat triangle has none in any corner
    const vec3 n0 = unpackUnitVector(t.corner0.w);
    const vec3 n1 = unpackUnitVector(t.corner1.w);
    const vec3 n2 = unpackUnitVector(t.corner2.w);
    const vec3 n = (1.0 - barycentrics.x - barycentrics.y) * n0 + barycentrics.x * n1 + barycentrics.y * n2;
    const float squared = dot(n, n);
    return squared > 1e-12 ? n * inversesqrt(squared) : geometric;
}

vec3 albedoAt(uint triangle, vec2 barycentrics, Material material) {
    if (!kTextured || material.albedoTexture == kNoTexture) return material.albedo;
    const vec2 uv0 = triangleUvs[triangle * 3u];
    const vec2 uv = uv0 + barycentrics.x * (triangleUvs[triangle * 3u + 1u] - uv0) +
                    barycentrics.y * (triangleUvs[triangle * 3u + 2u] - uv0);
    return material.albedo * sampleTexture(material.albedoTexture, uv);
}

// `toViewer` points away from the surface, to where the ray came from; it need not be unit.
// Normals are turned to the viewer's side, a two-sided reflector: the geometric one, which cannot be wrong about sides,
// and the shading normal with it.
Surface surfaceAt(uint triangle, vec2 barycentrics, vec3 toViewer) {
    const TriangleRecord t = loadTriangle(triangle);
    const vec3 counterClockwise = counterClockwiseNormal(t);
    const vec3 shading = shadingNormalAt(t, barycentrics, counterClockwise);
    Surface surface;
    surface.position = positionAt(t, barycentrics);
    surface.isFrontFacing = dot(counterClockwise, toViewer) > 0.0;
    surface.geometricNormal = surface.isFrontFacing ? counterClockwise : -counterClockwise;
    surface.normal = dot(shading, surface.geometricNormal) < 0.0 ? -shading : shading;
    surface.material = triangleMaterials[triangle];
    surface.albedo = albedoAt(triangle, barycentrics, materials[surface.material]);
    return surface;
}

#endif
