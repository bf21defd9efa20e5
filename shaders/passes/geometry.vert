// Triangle corners to clip space; the fragment shaders rebuild everything else from the triangle's number.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"

layout(location = 0) in vec3 cornerPosition;
layout(location = 0) flat out uint triangle;

invariant gl_Position;

void main() {
    triangle = uint(gl_VertexIndex) / 3u;
    gl_Position = frame.clipFromWorld * vec4(cornerPosition, 1.0);
}
