// Path tracing with next-event estimation and multiple importance sampling (Kajiya 1986; Veach and Guibas 1995): one
// path per pixel and frame.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/path_light.glsl"
#include "shaders/lib/tile.glsl"
#include "shaders/shared/path_trace.h"

layout(constant_id = 10) const bool kResumes = false;   // paths go on from the states of an earlier dispatch
layout(constant_id = 11) const bool kSuspends = false;  // their states are left for a later one

layout(set = 0, binding = kBindingPathStates, scalar) buffer StateBlock { PathState states[]; };
layout(set = 0, binding = kBindingRadiance, rgba32f) writeonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { PathTracePush push; };

const uint kDimensionPixel = 0u;
const uint kDimensionsPerSurface = 4u;
const uint kDimensionsInCells = 0x80000000u;  // and above: places in cells of the environment's map
const uint kRouletteFrom = 3u;  // scatterings without it: the first ones make most of the picture
const float kFar = 8.0;         // no scene is larger than 2

PathState cameraPath(ivec2 pixel, uint seed) {
    const vec2 offset = push.jitter != 0u ? sample2d(frame.frame, seed, kDimensionPixel) : vec2(0.5);
    PathState path;
    path.origin = frame.cameraPosition;
    path.isAlive = 1u;
    path.direction = normalize(cameraDirectionAt(vec2(pixel) + offset));
    path.density = 0.0;
    path.throughput = vec3(1.0);
    path.scatterings = 0u;
    path.normal = vec3(0.0);
    path.unused = 0u;
    path.radiance = vec3(0.0);
    path.unused2 = 0u;
    return path;
}

bool counts(uint scatterings) { return scatterings >= push.minScatterings && scatterings <= push.maxScatterings; }

// What the path met shines by itself. The camera has no other way to find it; later on next-event estimation has.
vec3 emissionMet(PathState path, float lightDensity, vec3 radiance) {
    const float weight = path.scatterings == 0u ? 1.0 : misWeight(path.density, lightDensity);
    return counts(path.scatterings) ? path.throughput * radiance * weight : vec3(0.0);
}

vec3 emissionOfSurface(PathState path, Hit hit, TriangleRecord t, vec2 footprint) {
    const uint material = triangleMaterials[t.place];
    if (kEmissionTextured && materials[material].isUnlit != 0u)
        return path.scatterings == 0u && counts(0u) ? albedoAt(t.place, hit.barycentrics, material, footprint) : vec3(0.0);
    const float cosLight = -dot(counterClockwiseNormal(t), path.direction);
    const vec3 radiance = emittedRadianceAt(t.place, hit.barycentrics, material, footprint);
    if (cosLight <= 0.0 || radiance == vec3(0.0)) return vec3(0.0);
    const float density =
        densityOfEmitterPoint(materials[material].meanEmission, areaOf(t), hit.t * hit.t, cosLight);
    return emissionMet(path, density, radiance);
}

vec3 directLight(PathState path, Surface surface, uint seed, uint dimension) {
    if (frame.emitterCount == 0u || !counts(path.scatterings + 1u)) return vec3(0.0);
    vec2 inCell = vec2(0.0);
    if (kEnvironmentMapped) inCell = sample2d(frame.frame, seed, kDimensionsInCells + dimension);
    const LightSample light = sampleLight(surface.position, sampleBits(frame.frame, seed, dimension).x,
                                          sampleBits(frame.frame, seed, dimension + 1u), inCell);
    const float cosSurface = max(dot(surface.normal, light.direction), 0.0);
    const float density = bsdfDensity(surface.bsdf, surface.normal, light.direction, -path.direction);
    const float weight = light.density > 0.0 ? misWeight(light.density, density) : 1.0;
    const vec3 reflectance = evaluateBsdf(surface.bsdf, surface.normal, light.direction, -path.direction);
    const vec3 radiance = reflectance * cosSurface * weight * light.irradiance;
    const bool isBehind = dot(surface.geometricNormal, light.direction) <= 0.0;
    const bool matters = radiance.x + radiance.y + radiance.z > 0.0 && !isBehind;
    const vec3 start = offsetPoint(surface.position, surface.geometricNormal);
    const bool blocked = occluded(start, matters ? light.end - start : vec3(0.0), 1.0);
    return blocked || isBehind ? vec3(0.0) : path.throughput * radiance;
}

// The next direction by the reflectance; of a Lambertian, by the cosine, so that albedo is all that is left of
// reflectance * cosine / density.
PathState scatter(PathState path, Surface surface, uint seed, uint dimension) {
    const float uSurvival = sample2d(frame.frame, seed, dimension).y;
    const vec2 u = sample2d(frame.frame, seed, dimension + 2u);
    const vec3 outgoing = -path.direction;
    const float uLobe = kGlossy ? sample2d(frame.frame, seed, dimension + 3u).x : 1.0;
    path.origin = surface.position;
    path.normal = surface.geometricNormal;
    path.direction = sampleBsdf(surface.bsdf, surface.normal, outgoing, uLobe, u);
    path.density = bsdfDensity(surface.bsdf, surface.normal, path.direction, outgoing);
    vec3 weight = surface.bsdf.diffuse;
    if (kGlossy && surface.bsdf.f90 > 0.0)
        weight = evaluateBsdf(surface.bsdf, surface.normal, path.direction, outgoing) *
                 (max(dot(path.direction, surface.normal), 0.0) / max(path.density, 1e-30));
    const float largest = largestChannel(weight);
    const bool roulette = push.russianRoulette != 0u && path.scatterings >= kRouletteFrom;
    const float survival = roulette ? min(largest, 1.0) : 1.0;
    path.throughput *= weight / max(survival, 1e-6);
    path.scatterings += 1u;
    // Nothing is scattered to the other side of the surface, whatever the shading normal says.
    const bool leaves = path.density > 0.0 && dot(surface.geometricNormal, path.direction) > 0.0;
    path.isAlive = uSurvival < survival && largest > 0.0 && leaves ? 1u : 0u;
    return path;
}

PathState meetSurface(PathState path, uint seed) {
    const vec3 origin = path.normal == vec3(0.0) ? path.origin : offsetRayOrigin(path.origin, path.normal, path.direction);
    const Hit hit = closestHit(origin, path.direction, kFar);
    if (hit.triangle == kNoHit) {
        path.radiance += emissionMet(path, densityOfEnvironment(path.direction), radianceOfEnvironment(path.direction));
        path.isAlive = 0u;
        return path;
    }
    // Camera rays go through the backs of single-sided surfaces.
    if (path.scatterings == 0u && isCulledFrom(hit.triangle, -path.direction)) {
        const TriangleRecord t = loadTriangle(hit.triangle);
        path.origin = positionAt(t, hit.barycentrics);
        path.normal = counterClockwiseNormal(t);
        return path;
    }
    const TriangleRecord t = loadTriangle(hit.triangle);
    // Only what the camera sees is averaged over a pixel: light that surfaces exchange, VPLs carry too.
    vec2 footprint = kNoFootprint;
    if (path.scatterings == 0u) footprint = footprintOfPixel(t, hit.barycentrics, path.direction);
    path.radiance += emissionOfSurface(path, hit, t, footprint);
    if (path.scatterings == push.maxScatterings) {
        path.isAlive = 0u;
        return path;
    }
    Surface surface = surfaceAt(t, hit.barycentrics, -path.direction, footprint);
    if (path.scatterings == 0u) surface = asSeenByCamera(surface);
    const uint dimension = 1u + path.scatterings * kDimensionsPerSurface;
    path.radiance += directLight(path, surface, seed, dimension);
    return scatter(path, surface, seed, dimension);
}

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    if (pixel.x >= int(frame.imageSize.x) || pixel.y >= int(push.endRow)) return;
    const uint slot = (uint(pixel.y) - push.firstRow) * frame.imageSize.x + uint(pixel.x);
    const uint seed = pixelSeed(frame.seed, pixel);

    PathState path;
    if (kResumes) path = states[slot];
    else path = cameraPath(pixel, seed);
    for (uint i = 0u; i < kSurfacesPerDispatch; ++i) {
        if (path.isAlive == 0u) break;
        path = meetSurface(path, seed);
    }
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    if (kSuspends) states[slot] = path;
    else imageStore(radianceImage, pixel, vec4(path.radiance, 1.0));
}
