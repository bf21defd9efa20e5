// The canvas as it is, into whatever format the window has.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/prelude.glsl"

layout(constant_id = 0) const bool kEncodesItself = false;  // the target is an sRGB format

layout(set = 0, binding = kBindingCanvas, rgba8) readonly uniform image2D canvas;
layout(location = 0) out vec4 shown;

vec3 linearFromSrgb(vec3 encoded) {
    const vec3 high = pow((encoded + 0.055) / 1.055, vec3(2.4));
    return mix(high, encoded / 12.92, lessThanEqual(encoded, vec3(0.04045)));
}

void main() {
    const vec3 encoded = imageLoad(canvas, ivec2(gl_FragCoord.xy)).rgb;
    shown = vec4(kEncodesItself ? linearFromSrgb(encoded) : encoded, 1.0);
}
