// Which pixels of a filter show the same surface: of every pixel its normal and depth, packed to be read many times.
#ifndef MANYLIGHT_GUIDE_GLSL
#define MANYLIGHT_GUIDE_GLSL
#include "shaders/shared/reconstruct.h"

layout(set = 0, binding = kBindingGuide, rgba32f) readonly uniform image2D guide;

// The pixel in the middle, and the plane that it sees.
struct GuideCenter {
    vec3 normal;
    float depth;    // along the camera's axis; 0: shares light with nobody
    vec3 facing;    // cosine, times a length, between normal and the ray of a pixel; what x and y add to it per pixel
    float perPixel; // a length over depth, in tolerances of the distance from the plane
};

// `own`: normal, and depth along the camera's axis.
GuideCenter guideCenterOf(vec4 own, ivec2 pixel) {
    const vec2 size = vec2(frame.imageSize);
    const vec2 ndc = 2.0 * (vec2(pixel) + frame.pixelOffset) / size - 1.0;
    const vec3 perNdc = vec3(dot(own.xyz, frame.cameraForward), dot(own.xyz, frame.cameraRight), dot(own.xyz, frame.cameraDown));
    const vec3 facing = vec3(perNdc.x + ndc.x * perNdc.y + ndc.y * perNdc.z, 2.0 * perNdc.yz / size);
    const float footprint = 2.0 * length(frame.cameraDown) / size.y;
    return GuideCenter(own.xyz, own.w, facing, 1.0 / (kPlaneTolerance * footprint));
}

GuideCenter guideCenterAt(ivec2 pixel) { return guideCenterOf(imageLoad(guide, pixel), pixel); }

bool takesPart(GuideCenter center) { return center.depth > 0.0; }

// exp(-x), as (1 - x / 8)^8: it comes to an end, and needs no more than multiplications.
float decay(float x) {
    const float base = max(1.0 - 0.125 * x, 0.0);
    const float base2 = base * base;
    const float base4 = base2 * base2;
    return base4 * base4;
}

// 1 on one plane, 0 on others. The distance from the plane is told in footprints per pixel: no lengths are involved, and
// slopes count as little as distance. `difference`: a reason beside, as an exponent.
float likeness(GuideCenter center, vec4 tap, vec2 offset, float difference, float sharpness) {
    const float along = center.facing.x + offset.x * center.facing.y + offset.y * center.facing.z;
    const float offPlane = abs(tap.w / center.depth * along - center.facing.x);
    const float pixels = max(max(abs(offset.x), abs(offset.y)), 1.0);
    const float turned = 1.0 - dot(center.normal, tap.xyz);
    const float alike = decay(center.perPixel * offPlane / pixels + sharpness * turned + difference);
    return tap.w > 0.0 ? alike : 0.0;
}


// A neighbour's guide; of pixels outside the picture, one that is like nobody.
vec4 guideOfTap(ivec2 pixel) {
    const ivec2 inside = clamp(pixel, ivec2(0), ivec2(frame.imageSize) - 1);
    const vec4 tap = imageLoad(guide, inside);
    return inside == pixel ? tap : vec4(0.0);
}

#endif
