// For every point that is seen now, what was shown of it before the camera or the scene moved: looked up where the
// camera of then saw it (Nehab et al. 2007), unless it saw something else there, and not farther from the light of now
// than chance explains (Karis 2014, by the scatter over frames as well, as Schied et al. 2017 keep it).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/history.glsl"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) readonly uniform image2D radianceImage;
layout(set = 0, binding = kBindingShown, rgba32f) readonly uniform image2D shownBefore;
layout(set = 0, binding = kBindingHistoryGuide, rgba32ui) readonly uniform uimage2D guideBefore;
layout(set = 0, binding = kBindingHistory, rgba32ui) writeonly uniform uimage2D history;
layout(push_constant, scalar) uniform Push { ReprojectionPush push; };

const float kPlaneFootprints = 1.5;  // off the plane
const float kLeastCosine = 0.9;      // between normals
const float kMostContrast = 4.0;     // of textures that stay sharp
const float kMostDeviations = 3.0;   // from the mean of 3 x 3 pixels
const float kFramesThatTell = 4.0;   // how far they scatter

const History kNoHistory = History(vec3(0.0), 0.0, 0.0);

// In the picture of then: in pixels, whole numbers at their centres; and the depth.
vec3 placeBefore(vec3 position) {
    const vec3 between = position - push.origin;
    const float depth = dot(between, push.forward);
    const vec2 across = vec2(dot(between, push.right) / dot(push.right, push.right),
                             dot(between, push.down) / dot(push.down, push.down));
    if (!(depth > 0.0) || any(greaterThan(abs(across), vec2(2.0 * depth)))) return vec3(0.0);
    return vec3((0.5 * across / depth + 0.5) * vec2(push.size) - 0.5, depth);
}

vec3 positionBefore(ivec2 pixel, float depth) {
    const vec2 ndc = (2.0 * vec2(pixel) + 1.0) / vec2(push.size) - 1.0;
    return push.origin + depth * (push.forward + ndc.x * push.right + ndc.y * push.down);
}

bool showsSame(Receiver receiver, uvec4 guide, uvec4 then, ivec2 pixelThen, float footprint) {
    if (!hasSurface(then) || !isSameMaterial(guide.w, then.w)) return false;
    const vec3 normal = unpackUnitVector(then.y);
    const vec3 between = positionBefore(pixelThen, uintBitsToFloat(then.x)) - receiver.position;
    const float offPlane = max(abs(dot(between, receiver.normal)), abs(dot(between, normal)));
    return offPlane <= kPlaneFootprints * footprint && dot(normal, receiver.normal) >= kLeastCosine;
}

History historyOf(Receiver receiver, uvec4 guide) {
    const vec3 place = placeBefore(receiver.position);
    if (!hasSurface(guide) || place.z == 0.0) return kNoHistory;
    const float footprint =
        max(footprintAt(receiver.position), place.z * 2.0 * length(push.down) / float(push.size.y));
    const ivec2 corner = ivec2(floor(place.xy));
    const vec2 part = place.xy - vec2(corner);
    History sum = kNoHistory;
    float weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 offset = ivec2(i & 1, i >> 1);
        const ivec2 pixel = corner + offset;
        if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(push.size)))) continue;
        const uvec4 then = imageLoad(guideBefore, pixel);
        if (!showsSame(receiver, guide, then, pixel, footprint)) continue;
        const vec2 sides = mix(1.0 - part, part, vec2(offset));
        const float w = sides.x * sides.y;
        const vec4 shown = imageLoad(shownBefore, pixel);
        const vec3 contrast = unpackDemodulator(guide.z) / unpackDemodulator(then.z);
        sum.radiance += w * clamp(contrast, 1.0 / kMostContrast, kMostContrast) * shown.rgb;
        sum.frames += w * min(shown.a, kLongestHistory);
        sum.scatter += w * unpackScatter(then.w);
        weights += w;
    }
    if (weights < 1e-3) return kNoHistory;
    return History(sum.radiance / (weights * push.frames), push.areaShare * sum.frames / weights,
                   sum.scatter / weights);
}

// When the camera alone moves, the light of a Lambertian does not change: a VPL that is near it for one frame would pass
// for a change. Of what is glossy, earlier frames tell what scatter to expect. Objects that move bring shadows with them,
// whose edges would pass for scatter.
bool isTrusted(History found, Receiver receiver) {
    return push.sceneMoved == 0u && (found.frames < kFramesThatTell || !isGlossy(receiver.bsdf.f90));
}

// Light that has changed is pulled towards that of now, and counts as fewer frames the farther off it was.
History withinReach(History found, ivec2 pixel) {
    vec3 around[9];
    vec3 mean = vec3(0.0);
    int count = 0;
    for (int i = 0; i < 9; ++i) {
        const ivec2 neighbour = pixel + ivec2(i % 3, i / 3) - 1;
        if (!isInPicture(neighbour)) continue;
        around[count] = imageLoad(radianceImage, neighbour).rgb;
        mean += around[count++];
    }
    mean /= float(count);
    const float level = max(brightness(mean), 1e-30);  // squares of very faint light would underflow
    vec3 squares = vec3(0.0);
    for (int i = 0; i < count; ++i) squares += (around[i] - mean) / level * ((around[i] - mean) / level);
    const vec3 overTime = push.sceneMoved == 0u ? found.scatter * mean / level : vec3(0.0);
    const vec3 reach = kMostDeviations * sqrt(squares / float(count) + overTime * overTime) + 1e-3;  // or rounding tells
    const vec3 away = (found.radiance - mean) / level;
    const vec3 kept = min(reach / max(abs(away), vec3(1e-30)), vec3(1.0));
    found.radiance = mean + level * kept * away;
    found.frames *= min(kept.x, min(kept.y, kept.z));
    return found;
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, false);
    History found = historyOf(seen.receiver, historyGuide(seen, 0.0));
    if (found.frames > 0.0 && !isTrusted(found, seen.receiver)) found = withinReach(found, pixel);
    imageStore(history, pixel, packHistory(found));
}
