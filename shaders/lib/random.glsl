// Hash-based Owen-scrambled Sobol points (Burley 2020), keyed by (seed, dimension, index): no state, restartable.
#ifndef MANYLIGHT_RANDOM_GLSL
#define MANYLIGHT_RANDOM_GLSL
#include "shaders/shared/sobol.h"

// A stratified point of [0,1)^2 for sample `index` of the sequence named by (seed, dimension).
vec2 sample2d(uint index, uint seed, uint dimension) { return owenScrambledSobol2d(index, hashCombine(seed, dimension)); }

// The same with all its bits, for choices among many.
uvec2 sampleBits(uint index, uint seed, uint dimension) {
    return owenScrambledSobolBits(index, hashCombine(seed, dimension));
}

// A seed for what each pixel draws by itself.
uint pixelSeed(uint seed, ivec2 pixel) { return hashCombine(hashCombine(seed, uint(pixel.x)), uint(pixel.y)); }

// A uniform integer in [0, count), count < 2^32.
uint sampleInteger(uint bits, uint count) {
    uint high, low;
    umulExtended(bits, count, high, low);
    return high;
}

#endif
