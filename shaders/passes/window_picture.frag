// The picture, and beyond the divider the other one, scaled to the window, with the panels over it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/window.h"

layout(set = 0, binding = kBindingDisplay, rgba8) readonly uniform image2D picture;
layout(set = 0, binding = kBindingOtherDisplay, rgba8) readonly uniform image2D otherPicture;
layout(set = 0, binding = kBindingCanvas, rgba8) readonly uniform image2D panels;  // premultiplied
layout(push_constant, scalar) uniform Push { WindowPicturePush push; };
layout(constant_id = 0) const bool kHasPanels = true;
layout(location = 0) out vec4 shown;

vec3 texelAt(bool isOther, ivec2 texel, ivec2 last) {
    const ivec2 inside = clamp(texel, ivec2(0), last);
    return (isOther ? imageLoad(otherPicture, inside) : imageLoad(picture, inside)).rgb;
}

vec3 pictureAt(vec2 position) {
    const bool isOther = position.x > push.divider;
    const uvec2 size = isOther ? push.otherSize : push.size;
    const ivec2 last = ivec2(size) - 1;
    if (size == push.canvas) return texelAt(isOther, ivec2(position), last);
    const vec2 place = position * vec2(size) / vec2(push.canvas) - 0.5;
    const ivec2 corner = ivec2(floor(place));
    const vec2 share = place - vec2(corner);
    const vec3 top = mix(texelAt(isOther, corner, last), texelAt(isOther, corner + ivec2(1, 0), last), share.x);
    const vec3 bottom =
        mix(texelAt(isOther, corner + ivec2(0, 1), last), texelAt(isOther, corner + ivec2(1, 1), last), share.x);
    return mix(top, bottom, share.y);
}

void main() {
    shown = vec4(pictureAt(gl_FragCoord.xy), 1.0);
    if (!kHasPanels) return;
    const vec4 panel = imageLoad(panels, ivec2(gl_FragCoord.xy));
    shown.rgb = panel.rgb + (1.0 - panel.a) * shown.rgb;
}
