// Which triangle a pixel sees, by a ray through it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/ray.glsl"
#include "shaders/lib/tile.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/visibility_rays.h"

layout(set = 0, binding = kBindingVisibility, r32ui) writeonly uniform uimage2D visibility;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { VisibilityRaysPush push; };

const float kFar = 8.0;  // no scene is larger than 2, and no direction shorter than 1

// The first triangle that does not turn to the camera a back that it looks through.
Hit firstSeen(vec3 origin, vec3 direction) {
    Hit hit = closestHit(origin, direction, kFar);
    if (!kCulled) return hit;
    for (uint i = 0u; i < kMostBacksSeenThrough; ++i) {
        if (hit.triangle == kNoHit || !isCulledFrom(hit.triangle, -direction)) return hit;
        const TriangleRecord t = loadTriangle(hit.triangle);
        const vec3 start = offsetRayOrigin(positionAt(t, hit.barycentrics), counterClockwiseNormal(t), direction);
        hit = closestHit(start, direction, kFar);
    }
    atomicOr(status.loopBudgetExceeded, 1u);
    return hit;
}

void main() {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy * tileSize());
    const ivec2 pixel = tile + pixelInTile(gl_LocalInvocationIndex) + ivec2(0, push.firstRow);
    if (pixel.x >= int(frame.imageSize.x) || pixel.y >= int(push.endRow)) return;
    const Hit hit = firstSeen(frame.cameraPosition, cameraDirection(pixel));
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);
    imageStore(visibility, pixel, uvec4(hit.triangle == kNoHit ? 0u : hit.triangle + 1u));
}
