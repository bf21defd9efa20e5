// One channel of the G-buffer as a picture.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"
#include "shaders/lib/gbuffer_read.glsl"
#include "shaders/shared/show.h"
#include "shaders/shared/sobol.h"
#include "shaders/shared/workgroups.h"

layout(local_size_x_id = kConstantGroupWidth, local_size_y_id = kConstantGroupHeight) in;
layout(set = 0, binding = kBindingRadiance, rgba32f) writeonly uniform image2D radianceImage;
layout(push_constant, scalar) uniform Push { ShowPush push; };

// Neighbouring numbers get unlike colours.
vec3 colourOfNumber(uint number) {
    const uint bits = hashInteger(number + 1u);
    return vec3(bits & 255u, (bits >> 8) & 255u, (bits >> 16) & 255u) / 255.0;
}

vec3 channelOf(GBufferPixel seen) {
    const vec3 fromCamera = seen.receiver.position - frame.cameraPosition;
    switch (push.channel) {
        case kShowNormal: return 0.5 + 0.5 * seen.receiver.normal;
        case kShowAlbedo: return seen.receiver.bsdf.diffuse + seen.receiver.bsdf.f0;
        case kShowDepth: return vec3(dot(fromCamera, frame.cameraForward) * push.depthScale);
        case kShowPosition: return 0.5 + 0.5 * (seen.receiver.position - frame.sceneCenter) / frame.sceneRadius;
        default: return colourOfNumber(triangleMaterials[placeOf(seen.triangle)]);
    }
}

void main() {
    const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, ivec2(frame.imageSize)))) return;
    const GBufferPixel seen = readGBuffer(pixel, false);
    imageStore(radianceImage, pixel, vec4(seen.isSurface ? channelOf(seen) : vec3(0.0), 1.0));
}
