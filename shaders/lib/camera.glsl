// The pinhole camera: rays through pixels, and where such a ray meets a known triangle.
#ifndef MANYLIGHT_CAMERA_GLSL
#define MANYLIGHT_CAMERA_GLSL
#include "shaders/lib/random.glsl"
#include "shaders/lib/surface.glsl"

// Direction (not unit; length 1 along the axis) of the ray through a point of the picture, in pixels.
vec3 cameraDirectionAt(vec2 point) {
    const vec2 ndc = 2.0 * point / vec2(frame.imageSize) - 1.0;
    return frame.cameraForward + ndc.x * frame.cameraRight + ndc.y * frame.cameraDown;
}

// The same through this frame's sample of a pixel.
vec3 cameraDirection(ivec2 pixel) { return cameraDirectionAt(vec2(pixel) + frame.pixelOffset); }

// Barycentrics (b1, b2) where the line hits the triangle's plane, moved onto the triangle: the rasteriser has said
// that the pixel is covered, rounding may say otherwise. An edge-on triangle gives its centroid.
vec2 barycentricsOfPixel(TriangleRecord t, vec3 origin, vec3 direction) {
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    const vec3 e1 = uintBitsToFloat(t.corner1.xyz) - p0;
    const vec3 e2 = uintBitsToFloat(t.corner2.xyz) - p0;
    const vec3 p = cross(direction, e2);
    const float det = dot(e1, p);
    const vec3 s = origin - p0;
    vec2 b = det == 0.0 ? vec2(1.0 / 3.0) : vec2(dot(s, p), dot(direction, cross(s, e1))) / det;
    b = clamp(b, 0.0, 1.0);
    return b / max(1.0, b.x + b.y);
}

// What a pixel covers of a triangle's uvs, where a ray from the camera in `direction` (of any length) meets it: its area
// on the triangle, by the area that a pixel has at that distance and the angle at which it is seen, as a share of the
// triangle's.
vec2 footprintOfPixel(TriangleRecord t, vec2 barycentrics, vec3 direction) {
    if (!kMipmapped) return kNoFootprint;
    const vec3 p0 = uintBitsToFloat(t.corner0.xyz);
    const vec3 twiceArea = cross(uintBitsToFloat(t.corner1.xyz) - p0, uintBitsToFloat(t.corner2.xyz) - p0);
    const vec3 along = direction / dot(direction, frame.cameraForward);  // to the image plane at distance 1
    const vec3 toSurface = positionAt(t, barycentrics) - frame.cameraPosition;
    const float distance2 = dot(toSurface, toSurface) / dot(along, along);
    const float pixelArea = 4.0 * length(cross(frame.cameraRight, frame.cameraDown)) / float(frame.imageSize.x * frame.imageSize.y);
    const float share = frame.pixelShare * pixelArea * distance2 / max(abs(dot(twiceArea, along)), 1e-30);
    return share * vec2(uvAreaOf(t.place, 0u), kUvSets > 1u ? uvAreaOf(t.place, 1u) : 0.0);
}

// Rasterisers ask this where rays ask letsThrough().
bool pixelSeesThrough(uint triangle, ivec2 pixel) {
    const TriangleRecord t = loadTriangle(triangle);
    const vec2 barycentrics = barycentricsOfPixel(t, frame.cameraPosition, cameraDirection(pixel));
    return letsThrough(t.place, barycentrics, pixelSeed(frame.seed, pixel) + (triangle - t.place));
}

Surface surfaceOfPixel(uint triangle, ivec2 pixel) {
    const vec3 direction = cameraDirection(pixel);
    const TriangleRecord t = loadTriangle(triangle);
    const vec2 barycentrics = barycentricsOfPixel(t, frame.cameraPosition, direction);
    return asSeenByCamera(surfaceAt(t, barycentrics, -direction, footprintOfPixel(t, barycentrics, direction)));
}

#endif
