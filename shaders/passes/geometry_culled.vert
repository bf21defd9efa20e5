// geometry.vert for scenes with single-sided materials: a triangle whose back the camera sees is moved out of sight. Here
// and not in the fragment shader, so that depth is tested before shading.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/surface.glsl"

layout(location = 0) in vec3 vertexPosition;
layout(location = 0) flat out uint triangle;

invariant gl_Position;

void main() {
    triangle = uint(gl_VertexIndex) / 3u;
    gl_Position = frame.clipFromWorld * vec4(vertexPosition, 1.0);
    const vec3 toCamera = frame.cameraPosition - uintBitsToFloat(loadTriangle(triangle).corner0.xyz);
    if (isCulledFrom(triangle, toCamera)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
