// A texel of the font for every pixel: text is set at whole pixels, in the size that it was drawn in.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/window.h"

layout(set = 0, binding = kBindingPanelAtlas, scalar) readonly buffer AtlasBlock { uint atlas[]; };
layout(push_constant, scalar) uniform Push { WindowPanelPush push; };
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 colour;
layout(location = 0) out vec4 shown;

void main() {
    if (any(lessThan(gl_FragCoord.xy, push.clip.xy)) || any(greaterThan(gl_FragCoord.xy, push.clip.zw))) discard;
    const uvec2 texel = min(uvec2(uv * vec2(push.atlas)), push.atlas - 1u);
    const uint place = texel.y * push.atlas.x + texel.x;
    const float coverage = float(atlas[place / 4u] >> (8u * (place % 4u)) & 255u) / 255.0;
    shown = vec4(colour.rgb, colour.a * coverage);
}
