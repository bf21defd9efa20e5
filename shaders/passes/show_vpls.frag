#version 460

layout(location = 0) in vec2 onDisk;
layout(location = 1) flat in vec3 colour;
layout(location = 0) out vec4 radianceOut;

void main() {
    const float r = dot(onDisk, onDisk);
    if (r > 1.0) discard;
    radianceOut = vec4(r > 0.6 ? vec3(0.0) : colour, 1.0);  // a dark rim sets the dots off
}
