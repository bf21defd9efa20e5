// Light paths leave the emitters: beta = Le cos / (P_l p_A p_w)   (Keller 1997, sec. 3).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/emitter_radiance.glsl"
#include "shaders/shared/vpl_emission.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth) in;
layout(set = 0, binding = kBindingRays, scalar) writeonly buffer RayBlock { Ray rays[]; };
layout(set = 0, binding = kBindingPathOffsets, scalar) writeonly buffer PathBlock { uint pathVertexCount[]; };
layout(push_constant, scalar) uniform Push { EmissionPush push; };

const uint kDimensionEmitter = 0u;
const uint kDimensionPosition = 1u;
const uint kDimensionDirection = 2u;
const uint kDimensionInCell = 3u;

// Through the disk across the direction that covers the scene: p_A = 1 / (pi R^2).
Ray emitFromMap(Ray ray, Emitter emitter, vec2 uPosition, uvec2 bits, vec2 inCell) {
    const EnvironmentSample drawn = sampleEnvironmentMap(bits, inCell);
    const float density = emitter.probability * drawn.density;
    ray.direction = -drawn.direction;
    ray.origin = pointOnSceneDisk(ray.direction, uPosition);
    const float disk = kPi * frame.sceneRadius * frame.sceneRadius;
    ray.intensity = density > 0.0 ? drawn.radiance / density * disk : vec3(0.0);
    ray.isAlive = largestChannel(ray.intensity) > 0.0 ? 1u : 0u;
    return ray;
}

// `inCell` is for maps of environments only.
Ray emitFrom(Emitter emitter, vec2 uPosition, uvec2 bits, vec2 inCell) {
    const vec2 uDirection = unitFloats(bits);
    Ray ray;
    ray.isAlive = 1u;
    ray.depth = 0u;
    ray.normal = vec3(0.0);
    ray.inverseRange = 0.0;
    const vec3 weight = emitter.emission / emitter.probability;
    if (emitter.kind == kEmitterTriangle) {
        ray.normal = normalOfTriangle(emitter);
        ray.origin = pointOnTriangle(emitter, uPosition);
        ray.direction = normalize(toWorld(squareToCosineHemisphere(uDirection), ray.normal));
        const vec3 radiance = radianceOfTriangle(emitter, uPosition);
        ray.intensity = radiance / emitter.probability * (kPi * emitter.area);  // cos cancels: p_A = 1/A, p_w = cos/pi
    } else if (emitter.kind == kEmitterPoint || emitter.kind == kEmitterSpot) {
        const float cosCone = emitter.kind == kEmitterSpot ? emitter.cosCutoff : -1.0;
        const vec3 axis = emitter.kind == kEmitterSpot ? emitter.edge1 : vec3(0.0, 0.0, 1.0);
        const vec3 local = squareToCone(uDirection, cosCone);
        const float falloff = emitter.kind == kEmitterSpot ? spotFalloff(local.z, emitter.cosBeam, emitter.cosCutoff) : 1.0;
        ray.origin = emitter.position;
        ray.inverseRange = emitter.inverseRange;
        ray.direction = normalize(toWorld(local, axis));
        ray.intensity = weight * (falloff * 2.0 * kPi * (1.0 - cosCone));
    } else if (kEnvironmentMapped && emitter.kind == kEmitterEnvironment) {
        ray = emitFromMap(ray, emitter, uPosition, bits, inCell);
    } else {
        const bool isConstant = emitter.kind == kEmitterEnvironment;
        ray.direction = isConstant ? squareToCone(uDirection, -1.0) : emitter.edge1;
        ray.origin = pointOnSceneDisk(ray.direction, uPosition);
        const float solidAngle = isConstant ? 4.0 * kPi : 1.0;
        ray.intensity = weight * (solidAngle * kPi * frame.sceneRadius * frame.sceneRadius);
    }
    return ray;
}

void main() {
    const uint slot = gl_GlobalInvocationID.x;
    if (slot >= push.pathCount) return;
    const uint path = push.firstPath + slot;
    const uint index = frame.frame * frame.pathCount + path;  // frames continue the sequence
    const Emitter emitter = loadEmitter(chooseEmitter(sampleBits(index, frame.seed, kDimensionEmitter).x, false));
    vec2 inCell = vec2(0.0);
    if (kEnvironmentMapped) inCell = sample2d(index, frame.seed, kDimensionInCell);
    rays[slot] = emitFrom(emitter, sample2d(index, frame.seed, kDimensionPosition),
                          sampleBits(index, frame.seed, kDimensionDirection), inCell);
    pathVertexCount[slot] = 0u;
}
