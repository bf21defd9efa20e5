// Forward shading, as the comparison wants it: every fragment that is nearest so far is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/traces.glsl"
#include "shaders/lib/forward_shading.glsl"

// Depth first: without this, the status counter or the discard would have hidden fragments shaded too.
layout(early_fragment_tests) in;
layout(location = 0) flat in uint triangle;
layout(location = 0) out vec4 radianceOut;

void main() { radianceOut = forwardRadiance(triangle); }
