// geometry.vert and geometry_culled.vert for scenes of instances.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/surface.glsl"

layout(location = 0) in vec3 cornerInMesh;
layout(location = 0) flat out uint triangle;

invariant gl_Position;

void main() {
    const uint instance = uint(gl_InstanceIndex);
    triangle = uint(gl_VertexIndex) / 3u + numberOffsetOf(instance);
    const uvec4 placed = placedCorner(instance, uvec4(floatBitsToUint(cornerInMesh), 0u));
    gl_Position = frame.clipFromWorld * vec4(floatsOf(placed), 1.0);
    if (!kCulled) return;
    rememberInstance(instance);
    const vec3 toCamera = frame.cameraPosition - floatsOf(loadTriangle(triangle).corner0);
    if (isCulledFrom(triangle, toCamera)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
