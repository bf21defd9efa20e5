// The picture, and beyond the divider the other one, scaled to the window.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/window.h"

layout(set = 0, binding = kBindingDisplay, rgba8) readonly uniform image2D picture;
layout(set = 0, binding = kBindingOtherDisplay, rgba8) readonly uniform image2D otherPicture;
layout(push_constant, scalar) uniform Push { WindowPicturePush push; };
layout(location = 0) out vec4 shown;

vec3 texelAt(bool isOther, ivec2 texel, ivec2 last) {
    const ivec2 inside = clamp(texel, ivec2(0), last);
    return (isOther ? imageLoad(otherPicture, inside) : imageLoad(picture, inside)).rgb;
}

void main() {
    const bool isOther = gl_FragCoord.x > push.divider;
    const uvec2 size = isOther ? push.otherSize : push.size;
    const ivec2 last = ivec2(size) - 1;
    shown.a = 1.0;
    if (size == push.canvas) {
        shown.rgb = texelAt(isOther, ivec2(gl_FragCoord.xy), last);
        return;
    }
    const vec2 place = gl_FragCoord.xy * vec2(size) / vec2(push.canvas) - 0.5;
    const ivec2 corner = ivec2(floor(place));
    const vec2 share = place - vec2(corner);
    const vec3 top = mix(texelAt(isOther, corner, last), texelAt(isOther, corner + ivec2(1, 0), last), share.x);
    const vec3 bottom =
        mix(texelAt(isOther, corner + ivec2(0, 1), last), texelAt(isOther, corner + ivec2(1, 1), last), share.x);
    shown.rgb = mix(top, bottom, share.y);
}
