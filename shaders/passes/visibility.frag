// Which triangle a pixel sees.
#version 460

layout(location = 0) flat in uint triangle;
layout(location = 0) out uint visibility;

void main() { visibility = triangle + 1u; }
