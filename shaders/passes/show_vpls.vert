// Every VPL as a disk that faces the camera: six corners of a square each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/shared/lights.h"
#include "shaders/shared/show.h"

layout(set = 0, binding = kBindingVpls, scalar) readonly buffer VplBlock { LightData vpls[]; };
layout(push_constant, scalar) uniform Push { ShowVplsPush push; };

layout(location = 0) out vec2 onDisk;
layout(location = 1) flat out vec3 colour;

const vec2 kCorners[6] = {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1)};

void main() {
    const LightData vpl = vpls[gl_VertexIndex / 6];
    onDisk = kCorners[gl_VertexIndex % 6];
    colour = vpl.intensity > 0.0 ? vpl.colour * push.brightness : vec3(0.0);
    // Lifted off its surface a little, or the surface would hide half of it.
    gl_Position = frame.clipFromWorld * vec4(vpl.position + 2e-3 * vpl.direction, 1.0);
    gl_Position.xy += onDisk * (2.0 * push.radius * gl_Position.w) / vec2(frame.imageSize);
    if (vpl.intensity == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
