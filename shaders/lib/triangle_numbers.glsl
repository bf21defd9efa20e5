// From the number of a triangle to where it is, with two levels: numbers run through all instances.
#ifndef MANYLIGHT_TRIANGLE_NUMBERS_GLSL
#define MANYLIGHT_TRIANGLE_NUMBERS_GLSL
#include "shaders/lib/bvh.glsl"

uint instanceCount() { return instanceTexel(0u, 4).w; }

// Which instance the triangle of that number is in.
uint instanceOf(uint triangle) {
    const bool isLast = triangle - lastFirstNumber < lastNumberCount;
    uint low = isLast ? lastInstance : 0u;
    uint high = isLast ? lastInstance : instanceCount() - 1u;
    while (low < high) {
        const uint middle = (low + high + 1u) / 2u;
        const bool isAbove = firstNumberOf(middle) > triangle;
        low = isAbove ? low : middle;
        high = isAbove ? middle - 1u : high;
    }
    rememberInstance(low);
    return low;
}

#endif
