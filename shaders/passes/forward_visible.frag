// Forward shading of what a pre-pass has seen. Depth alone cannot tell coplanar triangles apart, their numbers can.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/forward_shading.glsl"

// Depth first: without this, the status counter or the discard would have hidden fragments shaded too.
layout(early_fragment_tests) in;
layout(location = 0) flat in uint triangle;
layout(location = 0) out vec4 radianceOut;
layout(set = 0, binding = kBindingVisibility, r32ui) readonly uniform uimage2D visibility;

void main() {
    if (imageLoad(visibility, ivec2(gl_FragCoord.xy)).x != triangle + 1u) discard;
    radianceOut = forwardRadiance(triangle);
}
