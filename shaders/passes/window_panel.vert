// Dear ImGui's triangles: vertices are looked up, so that any index may start a draw.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/window.h"

layout(set = 0, binding = kBindingPanelVertices, scalar) readonly buffer VertexBlock { PanelVertex vertices[]; };
layout(set = 0, binding = kBindingPanelIndices, scalar) readonly buffer IndexBlock { uint indices[]; };
layout(push_constant, scalar) uniform Push { WindowPanelPush push; };
layout(location = 0) out vec2 uv;
layout(location = 1) out vec4 colour;

void main() {
    const PanelVertex vertex = vertices[indices[push.firstIndex + gl_VertexIndex]];
    uv = vertex.uv;
    colour = unpackUnorm4x8(vertex.rgba);
    const vec2 pixel = (vertex.position - push.origin) * push.scale;
    gl_Position = vec4(2.0 * pixel / vec2(push.canvas) - 1.0, 0.0, 1.0);
}
