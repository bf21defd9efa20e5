// What the passes of the reconstruction share: which pixels show the same surface, and what of a surface's reflection is
// not filtered.
#ifndef MANYLIGHT_RECONSTRUCT_GLSL
#define MANYLIGHT_RECONSTRUCT_GLSL
#include "shaders/lib/reflected.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/shared/reconstruct.h"

const float kRoughestLeftAlone = 0.3;   // GGX's alpha: sharper reflections are detail that no G-buffer knows of

// What lighting is divided by before it is filtered and multiplied by afterwards, so that textures stay sharp. A
// Lambertian's albedo cancels exactly: its gather sums irradiance and was never multiplied.
vec3 demodulator(Receiver receiver) {
    if (!isGlossy(receiver.bsdf.f90)) return receiver.bsdf.diffuse;
    const float cosViewer = max(dot(receiver.normal, receiver.toViewer), 0.0);
    const vec3 fresnel = receiver.bsdf.f0 + (vec3(receiver.bsdf.f90) - receiver.bsdf.f0) * oneMinusToTheFifth(cosViewer);
    return max(receiver.bsdf.diffuse * (1.0 - largestChannel(fresnel)) + fresnel, vec3(1e-3));
}

// A sum over VPLs as the filter takes it: radiance over demodulator().
vec3 demodulated(Receiver receiver, vec3 sum) {
    return isGlossy(receiver.bsdf.f90) ? sum / demodulator(receiver) : kInvPi * sum;
}

// What of a pixel tells whether light may be shared with it.
struct Guide {
    vec3 position;
    vec3 normal;
    bool takesPart;
};

Guide guideAt(ivec2 pixel) {
    const uvec4 position = imageLoad(gbufferPosition, pixel);
    const bool isRough = !kGlossy || uintBitsToFloat(imageLoad(gbufferGloss, pixel).w) >= kRoughestLeftAlone;
    return Guide(uintBitsToFloat(position.xyz),
                 unitFromOctahedral(uintBitsToFloat(imageLoad(gbufferShading, pixel).xy)), position.w != 0u && isRough);
}

bool isInPicture(ivec2 pixel) {
    return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, ivec2(frame.imageSize)));
}

// Length that a pixel covers across the line of sight, at a point.
float footprintAt(vec3 position) {
    const float along = dot(position - frame.cameraPosition, frame.cameraForward);
    return max(along, 0.0) * 2.0 * length(frame.cameraDown) / float(frame.imageSize.y);
}

// As likeness() of guide.glsl, straight from the G-buffer.
float sameSurface(Guide center, Guide tap, float footprint, ivec2 offset) {
    if (!tap.takesPart) return 0.0;
    const vec3 between = tap.position - center.position;
    const float offPlane = max(abs(dot(between, center.normal)), abs(dot(between, tap.normal)));
    const float allowed = kPlaneTolerance * footprint * max(float(max(abs(offset.x), abs(offset.y))), 1.0);
    const float turned = kNormalSharpness * (1.0 - dot(center.normal, tap.normal));
    return exp(-min((offPlane > 0.0 ? offPlane / allowed : 0.0) + turned, 80.0));
}

#endif
