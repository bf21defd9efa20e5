// Which triangle a pixel sees, where some are not opaque: what is not there lets the next one show.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/camera.glsl"

layout(location = 0) flat in uint triangle;
layout(location = 0) out uint visibility;

void main() {
    if (pixelSeesThrough(triangle, ivec2(gl_FragCoord.xy))) discard;
    visibility = triangle + 1u;
}
