// Forward shading where some triangles are not opaque. A fragment that is discarded must leave no depth behind, so that
// hidden fragments are shaded too.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/forward_shading.glsl"

layout(location = 0) flat in uint triangle;
layout(location = 0) out vec4 radianceOut;

void main() {
    if (pixelSeesThrough(triangle, ivec2(gl_FragCoord.xy))) discard;
    radianceOut = forwardRadiance(triangle);
}
