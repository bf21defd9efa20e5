// Owen-scrambled Sobol' points in two dimensions, as pure integer functions: the same bits in both languages.
#ifndef MANYLIGHT_SHARED_SOBOL_H
#define MANYLIGHT_SHARED_SOBOL_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

MANYLIGHT_FUNCTION uint reverseBits(uint x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return (x >> 16) | (x << 16);
}

// PCG-RXS-M-XS permutation of 32 bits (O'Neill 2014; Jarzynski & Olano 2020).
MANYLIGHT_FUNCTION uint hashInteger(uint x) {
    const uint state = x * 747796405u + 2891336453u;
    const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
    return (word >> 22) ^ word;
}

MANYLIGHT_FUNCTION uint hashCombine(uint seed, uint x) { return hashInteger(seed ^ (x * 0x9e3779b9u + (seed << 6) + (seed >> 2))); }

// Owen scrambling of the reversed bits by a Laine-Karras style hash, constants by Vegdahl (Burley 2020, sec. 2).
MANYLIGHT_FUNCTION uint laineKarrasPermutation(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

MANYLIGHT_FUNCTION uint nestedUniformScramble(uint x, uint seed) {
    return reverseBits(laineKarrasPermutation(reverseBits(x), seed));
}

// The second Sobol' dimension: its generator matrix is Pascal's triangle mod 2, a Kronecker power of ((1,1),(0,1)),
// hence five shift-and-xor steps (Sobol' 1967; Ahmed 2024).
MANYLIGHT_FUNCTION uint sobolSecondDimension(uint index) {
    uint x = index;
    x ^= (x & 0xaaaaaaaau) >> 1;
    x ^= (x & 0xccccccccu) >> 2;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xff00ff00u) >> 8;
    x ^= (x & 0xffff0000u) >> 16;
    return reverseBits(x);
}

// 24 leading bits as a float in [0, 1).
MANYLIGHT_FUNCTION float unitFloat(uint bits) { return float(bits >> 8) * 5.9604644775390625e-8f; }

// Both coordinates as fractions of 2^32.
MANYLIGHT_FUNCTION uvec2 owenScrambledSobolBits(uint index, uint seed) {
    const uint shuffled = nestedUniformScramble(index, seed);
    return uvec2(nestedUniformScramble(reverseBits(shuffled), hashInteger(seed ^ 0x51633e2du)),
                 nestedUniformScramble(sobolSecondDimension(shuffled), hashInteger(seed ^ 0x68bc21ebu)));
}

MANYLIGHT_FUNCTION vec2 unitFloats(uvec2 bits) { return vec2(unitFloat(bits.x), unitFloat(bits.y)); }

MANYLIGHT_FUNCTION vec2 owenScrambledSobol2d(uint index, uint seed) {
    return unitFloats(owenScrambledSobolBits(index, seed));
}

MANYLIGHT_SHARED_END
#endif
