// What flip-evaluator 1.7 (PyPI, the authors' own) says about the pictures of
// flip_pictures.h. Written by tests/crosscheck/flip_figures.py, which says how to run it.
#pragma once

#include <cstdint>

namespace manylight::test {

struct FlipFigures {
    const char* picture;
    bool isHdr;
    double pixelsPerDegree;
    double mean;
    double startExposure, stopExposure;
    uint32_t exposureCount;
    double values[4];  // at kFlipPlaces
};

constexpr uint32_t kFlipPlaces[][2] = {{0, 0}, {63, 47}, {16, 20}, {40, 9}};

constexpr FlipFigures kFlipFigures[] = {
    {"noise", true, 67.0206432766, 0.1663941, -1.868121, 2.766294, 5, {0.2853468, 0.4777442, 0.2010208, 0.1676198}},
    {"noise", true, 30.0000000000, 0.2934329, -1.868121, 2.766294, 5, {0.2908768, 0.5192430, 0.4419337, 0.3354296}},
    {"noise", false, 67.0206432766, 0.1114648, 0.000000, 0.000000, 1, {0.0438195, 0.2115298, 0.1516289, 0.1503793}},
    {"noise", false, 30.0000000000, 0.1869252, 0.000000, 0.000000, 1, {0.0506436, 0.2461901, 0.3435183, 0.1921969}},
    {"gradient", true, 67.0206432766, 0.5865917, -0.562240, 0.428289, 2, {0.1616727, 0.9641138, 0.1974127, 0.1761469}},
    {"gradient", true, 30.0000000000, 0.5696254, -0.562240, 0.428289, 2, {0.1271965, 0.9638429, 0.1940834, 0.1695351}},
    {"gradient", false, 67.0206432766, 0.6175160, 0.000000, 0.000000, 1, {0.0776066, 0.9663745, 0.2019893, 0.2409830}},
    {"gradient", false, 30.0000000000, 0.6006533, 0.000000, 0.000000, 1, {0.0570217, 0.9661996, 0.1948191, 0.2406378}},
    {"steps", true, 67.0206432766, 0.2369347, 0.428289, 24.083298, 24, {0.0000000, 0.4102525, 0.0573837, 0.0524660}},
    {"steps", true, 30.0000000000, 0.1707196, 0.428289, 24.083298, 24, {0.0000000, 0.9509531, 0.0009943, 0.0000000}},
    {"steps", false, 67.0206432766, 0.1952675, 0.000000, 0.000000, 1, {0.0000000, 0.3342276, 0.0349047, 0.0323064}},
    {"steps", false, 30.0000000000, 0.1441972, 0.000000, 0.000000, 1, {0.0000000, 0.8658664, 0.0006899, 0.0000000}},
};

}  // namespace manylight::test
