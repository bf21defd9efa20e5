// The gather with fewer pairs and fewer rays. Interleaved sampling (Keller and Heidrich 2001): neighbouring pixels gather
// from different subsets of the VPLs. Resampled shadow rays: all VPLs of the subset are weighed without visibility, and
// rays go to some of them, drawn in proportion to what they would give (Talbot et al. 2005, with the whole set as
// candidates): the expectation is that of a ray for each. For a filter, pixels may be left out that neighbours speak for.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_vote : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/lib/vpl_list_shuffle.glsl"
#include "shaders/lib/tile.glsl"
#include "shaders/lib/random.glsl"
#include "shaders/shared/vpl_resample.h"

const uint kReceivers = 1u;
#include "shaders/lib/shade_vpls.glsl"
#include "shaders/lib/reconstruct.glsl"
#include "shaders/lib/gather_grid.glsl"

layout(constant_id = 12) const bool kAddToRadiance = false;
layout(constant_id = 13) const uint kRays = 4u;  // per pixel; 0: one for each VPL
layout(constant_id = 40) const bool kForReconstruction = false;
layout(constant_id = 41) const int kGatherStep = 1;
layout(constant_id = 42) const bool kVisibilityApart = false;

layout(set = 0, binding = kBindingRadiance, rgba32f) uniform image2D radianceImage;
layout(set = 0, binding = kBindingStatus, scalar) buffer StatusBlock { FrameStatus status; };
layout(push_constant, scalar) uniform Push { ResamplePush push; };

const uint kDimensionResampling = 0x30000u;

// Every subsetStep-th VPL of the stretch, from firstOfSubset on.
uint firstOfSubset;
uint subsetStep;
uint subsetSize;

// The same class for all threads of a tile. Its pictures take turns along both axes.
uvec2 classOfTile(uvec2 tile) { return uvec2(tile.x / push.tilesAcross, tile.y / push.tilesDown); }

void chooseSubset(uvec2 pixelClass) {
    const uint period = push.interleave / uint(kGatherStep);  // in pixels that gather
    const uvec2 inPeriod = pixelClass / uint(kGatherStep);
    subsetStep = period * period;
    firstOfSubset = push.firstVpl + (inPeriod.y * period + inPeriod.x + push.phase) % subsetStep;
    subsetSize = firstOfSubset < push.endVpl ? (push.endVpl - firstOfSubset + subsetStep - 1u) / subsetStep : 0u;
}

void loadBlockOfSubset(uint base) {
    const uint number = base + gl_SubgroupInvocationID;
    const bool exists = number < subsetSize;
    holdVpl(exists ? firstOfSubset + number * subsetStep : push.firstVpl);
    if (exists) return;
    heldPosition.w = 0.0;
    if (kGlossy) heldGloss[0].xyz = vec3(0.0);
}

vec3 sumOfAll(Receiver receiver) {
    vec3 sum = vec3(0.0);
    for (uint base = 0u; base < subsetSize; base += kVplBlock) {
        loadBlockOfSubset(base);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const LightData vpl = vplOfBlock(i);
            sum += arriving(shareOfVpl(receiver, vpl, i, frame.geometryBound), receiver, vpl);
        }
    }
    return sum;
}

// What a summand is worth in the picture; to a filter, whatever the albedo, as neighbours use it too.
float weight(Receiver receiver, vec3 share) {
    const bool isAlike = kForReconstruction || isGlossy(receiver.bsdf.f90);
    return dot(share, isAlike ? vec3(1.0) : receiver.bsdf.diffuse);
}

float sumOfWeights(Receiver receiver, out vec3 unshadowed) {
    float sum = 0.0;
    unshadowed = vec3(0.0);
    for (uint base = 0u; base < subsetSize; base += kVplBlock) {
        loadBlockOfSubset(base);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const vec3 share = shareOfVpl(receiver, vplOfBlock(i), i, frame.geometryBound);
            unshadowed += share;
            sum += weight(receiver, share);
        }
    }
    return sum;
}

// Where the running sum of weights passes (j + u) / kRays of the whole: a stratified draw in the order of the list. Every
// draw goes along with the list until then; no branch depends on which.
void drawVpls(Receiver receiver, float total, float u, out uint drawn[kMostShadowRays]) {
    const float stride = total / float(kRays);
    float sum = 0.0;
    uint last = 0u;
    for (uint j = 0u; j < kRays; ++j) drawn[j] = 0u;
    for (uint base = 0u; base < subsetSize; base += kVplBlock) {
        loadBlockOfSubset(base);
        for (uint i = 0u; i < kVplBlock; ++i) {
            const float w = max(weight(receiver, shareOfVpl(receiver, vplOfBlock(i), i, frame.geometryBound)), 0.0);
            last = w > 0.0 ? base + i : last;
            for (uint j = 0u; j < kRays; ++j) drawn[j] = sum <= (float(j) + u) * stride ? last : drawn[j];
            sum += w;
        }
    }
}

// `error`: of the mean of the channels of the sum, from how the draws scatter; as a standard deviation.
vec3 sumOfDrawn(Receiver receiver, float total, uint drawn[kMostShadowRays], out float error) {
    vec3 sum = vec3(0.0);
    vec2 moments = vec2(0.0);
    // A loop of no turns is skipped, where all of an `if` might be gone through.
    const uint rays = total > 0.0 ? kRays : 0u;
    for (uint j = 0u; j < rays; ++j) {
        const uint index = firstOfSubset + drawn[j] * subsetStep;
        const LightData vpl = loadVpl(index);
        const vec3 share = kGlossy ? summandOfGlossyVpl(receiver, vpl, loadGloss(index), frame.geometryBound, false)
                                   : irradianceOfVpl(receiver, vpl, frame.geometryBound);
        const float w = weight(receiver, share);
        const float perDraw = w > 0.0 ? total / (w * float(kRays)) : 0.0;
        const vec3 drawnShare = arriving(share * perDraw, receiver, vpl);
        sum += drawnShare;
        const float part = 3.0 * brightness(drawnShare) / total;
        moments += vec2(part, part * part);
    }
    // The parts of `total`: k of them, of 1 / k or nothing where there is one spectrum. One alone tells nothing.
    const float k = float(kRays);
    const float variance = kRays == 1u ? 0.25 : max(moments.y - moments.x * moments.x / k, 0.0) * k / (k - 1.0);
    error = (total / 3.0) * sqrt(variance);
    return sum;
}

// Light for the filter, and its standard error.
vec4 together(Receiver receiver, vec3 sum, float error) {
    return float(subsetStep) * vec4(demodulated(receiver, sum), brightness(demodulated(receiver, vec3(error))));
}

// Light without visibility, and the share of it that arrives.
vec4 apart(Receiver receiver, vec3 unshadowed, vec3 sum) {
    const float whole = brightness(unshadowed);
    return vec4(float(subsetStep) * demodulated(receiver, unshadowed), whole > 0.0 ? min(brightness(sum) / whole, 1.0) : 0.0);
}

// The same of two stretches of the list.
vec4 apartWith(vec4 before, vec4 light) {
    const float whole = brightness(before.rgb) + brightness(light.rgb);
    const float first = whole > 0.0 ? brightness(before.rgb) / whole : 0.0;
    return vec4(before.rgb + light.rgb, mix(light.a, before.a, first));
}

void main() {
    // No early return: every lane holds a VPL for the others.
    const uvec2 tile = gl_WorkGroupID.xy + uvec2(0u, push.firstTileRow);
    const uvec2 pixelClass = classOfTile(tile);
    const uvec2 tileOfClass = tile - pixelClass * uvec2(push.tilesAcross, push.tilesDown);
    const ivec2 inClass = ivec2(tileOfClass * tileSize()) + pixelInTile(gl_LocalInvocationIndex);
    const ivec2 pixel = inClass * int(push.interleave) + ivec2(pixelClass);
    chooseSubset(pixelClass);
    Receiver receiver = readGBuffer(pixel, true).receiver;
    const bool gathers = kGatherStep == 1 || gathersItself(pixel, kGatherStep, ivec2(push.gridStart));
    if (!gathers) receiver.normal = vec3(0.0);  // nothing shines on it
    if (!subgroupAny(gathers)) subsetSize = 0u;

    vec3 sum;
    vec3 unshadowed = vec3(0.0);
    float error = 0.0;
    if (kRays == 0u) {
        sum = sumOfAll(receiver);
    } else {
        const float total = sumOfWeights(receiver, unshadowed);
        const uint seed = pixelSeed(frame.seed, pixel);
        uint drawn[kMostShadowRays];
        drawVpls(receiver, total, sample2d(frame.frame, seed, kDimensionResampling + push.firstVpl).x, drawn);
        sum = total > 0.0 ? sumOfDrawn(receiver, total, drawn, error) : vec3(0.0);
    }
    if (bvhLoopBudgetExceeded) atomicOr(status.loopBudgetExceeded, 1u);

    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    if (kForReconstruction) {
        vec4 light = kVisibilityApart ? apart(receiver, unshadowed, sum) : together(receiver, sum, error);
        if (!gathers) {
            light = vec4(0.0, 0.0, 0.0, -1.0);
        } else if (kAddToRadiance) {
            const vec4 before = imageLoad(radianceImage, pixel);
            light = kVisibilityApart ? apartWith(before, light) : vec4(before.rgb + light.rgb, length(vec2(before.a, light.a)));
        }
        imageStore(radianceImage, pixel, light);
        return;
    }
    vec3 radiance = float(subsetStep) * radianceFromSum(receiver, sum);
    if (kAddToRadiance) radiance += imageLoad(radianceImage, pixel).rgb;
    imageStore(radianceImage, pixel, vec4(radiance, 1.0));
}
