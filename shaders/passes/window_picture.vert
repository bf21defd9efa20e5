// A rectangle of the window.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/window.h"

layout(push_constant, scalar) uniform Push { WindowPicturePush push; };

void main() {
    const int corner = gl_VertexIndex < 3 ? gl_VertexIndex : gl_VertexIndex - 2;  // 0 1 2, 1 2 3
    const vec2 pixel = mix(push.tile.xy, push.tile.zw, bvec2((corner & 1) != 0, (corner & 2) != 0));
    gl_Position = vec4(2.0 * pixel / vec2(push.canvas) - 1.0, 0.0, 1.0);
}
