// What is shown once over a surface: a leaf, a rug, needlework, a paper lantern, a painting, a sunset on a screen.
#include "engine/scene/generate/showcase_parts.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr double kPi = double{shared::kPi};
constexpr glm::dvec3 kCream{0.9, 0.85, 0.72};
constexpr glm::dvec3 kMadder{0.62, 0.2, 0.15};
constexpr glm::dvec3 kIndigo{0.16, 0.22, 0.4};
constexpr glm::dvec3 kOchre{0.83, 0.6, 0.25};

glm::dvec4 opaque(const glm::dvec3& colour) { return {colour, 1.0}; }

/// Its stem is at the bottom; transparent around the blade.
glm::dvec4 leaf(double u, double v) {
    const double x = std::abs(2.0 * u - 1.0);
    const double halfWidth = 0.95 * std::sin(kPi * std::pow(v, 0.8));
    const bool isStem = v > 0.9 && x < 0.06;
    const double vein = std::abs(std::fmod(v * 9.0 + x * 3.0, 1.0) - 0.5);
    const bool isVein = x < 0.05 || vein < 0.06;
    const glm::dvec3 green = glm::mix(glm::dvec3(0.22, 0.42, 0.16), glm::dvec3(0.4, 0.6, 0.24), v);
    return {isVein ? green * 1.3 : green, x < halfWidth || isStem ? 1.0 : 0.0};
}

/// A field of medallions in two borders.
glm::dvec4 rug(double u, double v) {
    const double fromEdge = std::min(std::min(u, 1.0 - u) * 1.35, std::min(v, 1.0 - v));
    if (fromEdge < 0.02) return opaque(kCream);
    const double step = std::abs(std::fmod((u + v) * 24.0, 1.0) - 0.5);
    if (fromEdge < 0.1) return opaque(step < 0.22 ? kOchre : kIndigo);
    if (fromEdge < 0.12) return opaque(kCream);
    const double x = std::abs(u - 0.5) * 1.35;
    const double y = std::abs(v - 0.5);
    const double lozenge = x + y;
    if (lozenge < 0.07) return opaque(kOchre);
    if (lozenge < 0.12) return opaque(kIndigo);
    if (lozenge < 0.22) return opaque(std::fmod(lozenge * 60.0, 2.0) < 1.0 ? kCream : kMadder * 0.8);
    if (lozenge < 0.25) return opaque(kIndigo);
    const double flowerX = std::fmod(u * 16.0, 1.0) - 0.5;
    const double flowerY = std::fmod(v * 12.0, 1.0) - 0.5;
    return opaque(flowerX * flowerX + flowerY * flowerY < 0.04 ? kOchre : kMadder);
}

/// Rings of petals.
glm::dvec4 embroidery(double u, double v) {
    const double x = 2.0 * u - 1.0;
    const double y = 2.0 * v - 1.0;
    const double radius = std::sqrt(x * x + y * y);
    const double petals = 0.5 + 0.5 * std::cos(8.0 * std::atan2(y, x));
    if (radius < 0.12) return opaque(kMadder);
    if (radius < 0.2 + 0.3 * petals) return opaque(kOchre);
    if (radius > 0.66 && radius < 0.74) return opaque(kIndigo);
    return opaque(kCream);
}

/// What the paper of a lantern or a shade lets through: less at its ribs and towards its ends.
glm::dvec4 paperRibs(double, double v) {
    const double rib = std::abs(std::fmod(v * 12.0, 1.0) - 0.5);
    const double glow = 0.55 + 0.45 * std::sin(kPi * v);
    return opaque(glm::dvec3(1.0, 0.93, 0.82) * glow * (rib < 0.08 ? 0.62 : 1.0));
}

/// Hills behind each other under a pale sky.
glm::dvec4 canvas(double u, double v, uint64_t seed) {
    glm::dvec3 colour = glm::mix(glm::dvec3(0.45, 0.62, 0.78), glm::dvec3(0.95, 0.85, 0.68), v * 1.6);
    if (glm::length(glm::dvec2((u - 0.68) * 1.45, v - 0.3)) < 0.09) colour = {0.98, 0.9, 0.62};
    constexpr std::array<glm::dvec3, 3> kHills{{{0.5, 0.55, 0.6}, {0.36, 0.47, 0.38}, {0.24, 0.34, 0.2}}};
    for (uint32_t i = 0; i < kHills.size(); ++i) {
        const double crest = 0.42 + 0.16 * i - 0.16 * noise(u * (3.0 + i), 0.5, 64, 64, seed + i);
        if (v > crest) colour = kHills[i] * (1.0 + 0.5 * (v - crest));
    }
    return opaque(colour * (0.94 + 0.12 * noise(u * 40, v * 40, 64, 64, seed + 9)));
}

glm::dvec4 sunset(double u, double v) {
    const double sun = glm::length(glm::dvec2((u - 0.5) * 1.33, v - 0.58));
    if (v > 0.66) {
        const double ripple = std::abs(u - 0.5) < 0.16 * (1.2 - v) + 0.04 * std::sin(70.0 * v) ? 0.6 : 0.0;
        return opaque(glm::dvec3(0.2, 0.16, 0.35) + ripple * glm::dvec3(1.0, 0.6, 0.3));
    }
    if (sun < 0.13) return opaque({1.0, 0.9, 0.55});
    return opaque(glm::mix(glm::dvec3(0.25, 0.2, 0.5), glm::dvec3(0.98, 0.5, 0.25), v * 1.4));
}

}  // namespace

void addSinglePictures(std::vector<Picture>& pictures, uint64_t seed) {
    const auto add = [&](Picture picture) {
        picture.isTiled = false;
        pictures.push_back(std::move(picture));
    };
    add(painted("leaf", 64, 128, leaf));
    add(painted("rug", 256, 192, rug));
    add(painted("embroidery", 128, 128, embroidery));
    add(painted("paper", 16, 128, paperRibs));
    add(painted("canvas", 160, 112, [&](double u, double v) { return canvas(u, v, seed); }));
    add(painted("sunset", 128, 96, sunset));
}

}  // namespace manylight::showcase
