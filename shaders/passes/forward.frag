// Forward shading, as the comparison wants it: every fragment that is nearest so far is shaded.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/forward_shading.glsl"

layout(location = 0) flat in uint triangle;
layout(location = 0) out vec4 radianceOut;

void main() { radianceOut = forwardRadiance(triangle); }
