// Light paths go from surface to surface: meet one, leave a vertex there, go on by Russian roulette.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/random.glsl"
#include "shaders/lib/range.glsl"
#include "shaders/lib/ray.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/warps.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth) in;
layout(set = 0, binding = kBindingRays, scalar) buffer RayBlock { Ray rays[]; };
layout(set = 0, binding = kBindingPathOffsets, scalar) buffer PathBlock { uint pathVertexCount[]; };
layout(set = 0, binding = kBindingPathVertices, scalar) writeonly buffer VertexBlock { LightData pathVertices[]; };
layout(set = 0, binding = kBindingPathGloss, scalar) writeonly buffer GlossBlock { VplGloss pathGloss[]; };
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { EmissionPush push; };

const uint kDimensionsBeforeBounces = 4u;
const uint kDimensionsPerBounce = 2u;
const float kFar = 8.0;  // no scene is larger than 2

// Light transport is not symmetric in shading normals (Veach 1997, sec. 5.3). A particle that meets a Lambertian
// surface is weighted by |wi.Ns| / |wi.Ng|; what it sends on goes by the cosine to the geometric normal.
float shadingNormalCorrection(Surface surface, vec3 wi) {
    if ((!kShadingNormals && !kNormalMapped) || surface.normal == surface.geometricNormal) return 1.0;
    const float ratio = dot(surface.normal, wi) / max(dot(surface.geometricNormal, wi), 1e-6);
    if (dot(surface.normal, surface.geometricNormal) <= 0.0) return 0.0;
    if (ratio > kMaxShadingNormalCorrection) atomicAdd(status.shadingNormalsCapped, 1u);
    return clamp(ratio, 0.0, kMaxShadingNormalCorrection);
}

// Radiant intensity along the normal of a vertex that reflects `flux`: flux * albedo / pi, over all paths. On a glossy
// surface it is what the base alone would give, and metals count as one; shading then asks for the VplGloss.
LightData vertexOfPath(Surface surface, vec3 flux, uint path, uint depth) {
    const vec3 spectrum = flux * (surface.bsdf.diffuse + surface.bsdf.f0) * (kInvPi / float(frame.pathCount));
    LightData vertex;
    vertex.position = surface.position;
    vertex.direction = surface.geometricNormal;
    vertex.intensity = largestChannel(spectrum);
    vertex.colour = vertex.intensity > 0.0 ? spectrum / vertex.intensity : vec3(0.0);
    vertex.kind = kLightSurface;
    vertex.cosCutoff = 0.0;
    vertex.cosBeam = 1.0;
    vertex.depth = depth;
    vertex.pathIndex = path;
    vertex.inverseRange = 0.0;
    return vertex;
}

VplGloss glossOfPath(Surface surface, vec3 flux, vec3 incoming) {
    return VplGloss(flux / float(frame.pathCount), surface.bsdf.alpha, incoming, surface.bsdf.f90, surface.normal, 0.0,
                    surface.bsdf.diffuse, 0.0, surface.bsdf.f0, 0.0);
}

// Where the path goes on, and what it keeps of its flux: reflectance * cosine / density.
struct Continuation {
    vec3 direction;
    vec3 weight;
};

Continuation continueFrom(Surface surface, vec3 incoming, vec2 u, float uLobe) {
    Continuation next;
    if (!kGlossy || surface.bsdf.f90 == 0.0) {
        next.direction = normalize(toWorld(squareToCosineHemisphere(u), surface.geometricNormal));
        next.weight = surface.bsdf.diffuse;
        return next;
    }
    next.direction = sampleBsdf(surface.bsdf, surface.normal, incoming, uLobe, u);
    const float density = bsdfDensity(surface.bsdf, surface.normal, next.direction, incoming);
    next.weight = evaluateBsdf(surface.bsdf, surface.normal, incoming, next.direction) *
                  (max(dot(surface.geometricNormal, next.direction), 0.0) / max(density, 1e-30));
    return next;
}

// q = the largest share that is kept: a ratio, so that brighter lights change no path. Where all channels are equal the
// weight stays exactly what it was.
Ray continuePath(Ray ray, Surface surface, uint index) {
    const uint dimension = kDimensionsBeforeBounces + ray.depth * kDimensionsPerBounce;
    const vec2 u = sample2d(index, frame.seed, dimension);
    const Continuation next = continueFrom(surface, -ray.direction, sample2d(index, frame.seed, dimension + 1u), u.y);
    const float survival = push.russianRoulette != 0u ? min(largestChannel(next.weight), 1.0) : 1.0;
    ray.intensity *= next.weight / max(survival, 1e-6);
    ray.isAlive = u.x < survival && largestChannel(ray.intensity) > 0.0 ? 1u : 0u;
    ray.direction = next.direction;
    ray.origin = surface.position;
    ray.normal = surface.geometricNormal;
    ray.depth += 1u;
    return ray;
}

// The next surface on the way. A path that leaves the scene, or whose flux comes to nothing, leaves no vertex.
Ray bounce(Ray ray, uint slot) {
    const vec3 origin = ray.normal == vec3(0.0) ? ray.origin : offsetRayOrigin(ray.origin, ray.normal, ray.direction);
    const Hit hit = closestHit(origin, ray.direction, kFar);
    if (hit.triangle == kNoHit) {
        ray.isAlive = 0u;
        return ray;
    }
    const Surface surface = surfaceAt(hit.triangle, hit.barycentrics, -ray.direction);
    const uint path = push.firstPath + slot;
    // A limited range takes from the light on its first way only: what arrives there is light like any other.
    if (ray.depth == 0u) ray.intensity *= rangeWindow(hit.t, ray.inverseRange);
    ray.intensity *= shadingNormalCorrection(surface, -ray.direction);
    const LightData vertex = vertexOfPath(surface, ray.intensity, path, ray.depth + 1u);
    if (vertex.intensity > 0.0) {
        const uint place = ray.depth * push.pathCount + slot;
        pathVertices[place] = vertex;
        if (kGlossy) pathGloss[place] = glossOfPath(surface, ray.intensity, -ray.direction);
        pathVertexCount[slot] = ray.depth + 1u;
        atomicAdd(status.vplsTraced, 1u);
    }
    return continuePath(ray, surface, frame.frame * frame.pathCount + path);
}

void main() {
    const uint slot = gl_GlobalInvocationID.x;
    if (slot >= push.pathCount) return;
    Ray ray = rays[slot];
    for (uint i = 0u; i < kBouncesPerDispatch; ++i) {
        if (ray.isAlive == 0u || ray.depth >= push.maxDepth) break;
        ray = bounce(ray, slot);
    }
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    if (ray.isAlive != 0u && ray.depth == push.maxDepth) {
        atomicAdd(status.pathsTruncated, 1u);
        ray.isAlive = 0u;
    }
    rays[slot] = ray;
}
