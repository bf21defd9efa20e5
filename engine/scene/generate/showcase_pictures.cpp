// What repeats over a surface: wood, wallpaper, cloth, brushed metal.
#include "engine/scene/generate/showcase_parts.h"
#include "shaders/shared/constants.h"

#include <algorithm>
#include <cmath>

namespace manylight::showcase {
namespace {

constexpr double kPi = double{shared::kPi};
constexpr uint32_t kPlanks = 8;

double hashed(int64_t x, int64_t y, uint64_t seed) {
    return SceneRandom(seed * 0x9e3779b1u + static_cast<uint64_t>(x) * 7919 + static_cast<uint64_t>(y) * 104729).unit();
}

/// Where on a plank of the floor a place is.
struct Plank {
    double across;    // in [0, 1)
    double fromEdge;  // of the plank, in texels
    double tint;
    double grain;
};

Plank plankAt(double u, double v, uint64_t seed) {
    constexpr double kTexels = 256.0;
    const double column = std::floor(u * kPlanks);
    const double across = u * kPlanks - column;
    const double shift = hashed(static_cast<int64_t>(column), 0, seed);
    const double along = v + shift - std::floor(v + shift);
    const double fromSide = std::min(across, 1.0 - across) * kTexels / kPlanks;
    const double fromEnd = std::min(along, 1.0 - along) * kTexels;
    const double grain = 0.6 * noise(u * 96, v * 4 + 0.35 * std::sin(2 * kPi * v), 96, 4, seed + 1) +
                         0.4 * noise(u * 32, v * 8, 32, 8, seed + 2);
    return {across, std::min(fromSide, fromEnd), hashed(static_cast<int64_t>(column), v + shift >= 1.0 ? 1 : 2, seed),
            grain};
}

glm::dvec4 opaque(const glm::dvec3& colour) { return {colour, 1.0}; }

glm::dvec4 floorColour(double u, double v, uint64_t seed) {
    const Plank plank = plankAt(u, v, seed);
    const glm::dvec3 wood = glm::mix(glm::dvec3(0.52, 0.36, 0.23), glm::dvec3(0.74, 0.56, 0.39), plank.grain);
    return opaque(wood * (0.86 + 0.22 * plank.tint) * (plank.fromEdge < 1.0 ? 0.55 : 1.0));
}

glm::dvec4 wallpaper(double u, double v) {
    // Broad stripes with a lozenge on every second one.
    const bool isStripe = u < 0.5;
    const double x = std::abs(u * 4.0 - 1.0);
    const double y = std::abs(v * 4.0 - 2.0) * 0.7;
    const bool isLozenge = x + y < 0.5 && x + y > 0.26;
    const glm::dvec3 ground = isStripe ? glm::dvec3(0.8, 0.79, 0.71) : glm::dvec3(0.84, 0.83, 0.76);
    return opaque(isLozenge ? glm::dvec3(0.72, 0.7, 0.56) : ground);
}

/// Threads that go over and under each other.
double weaveHeight(double u, double v) {
    const double warp = std::abs(std::sin(4 * kPi * u));
    const double weft = std::abs(std::sin(4 * kPi * v));
    const bool isWarp = (static_cast<int>(std::floor(u * 4)) + static_cast<int>(std::floor(v * 4))) % 2 == 0;
    return isWarp ? warp : weft;
}

/// A normal map of heights that repeat; green points up in the picture.
Picture normalsOf(const char* name, uint32_t size, double strength,
                  const std::function<double(double u, double v)>& height) {
    const double texel = 1.0 / size;
    const auto wrapped = [&](double u, double v) { return height(u - std::floor(u), v - std::floor(v)); };
    return painted(name, size, size, [&](double u, double v) {
        const double right = wrapped(u + texel, v) - wrapped(u - texel, v);
        const double down = wrapped(u, v + texel) - wrapped(u, v - texel);
        return opaque(0.5 + 0.5 * glm::normalize(glm::dvec3(-strength * right, strength * down, 1.0)));
    });
}

void addFloor(std::vector<Picture>& pictures, uint64_t seed) {
    pictures.push_back(painted("floor", 256, 256, [&](double u, double v) { return floorColour(u, v, seed); }));
    pictures.push_back(painted("floor_roughness", 128, 128, [&](double u, double v) {
        const Plank plank = plankAt(u, v, seed);
        return glm::dvec4(1.0, plank.fromEdge < 1.5 ? 0.9 : 0.38 + 0.2 * plank.grain + 0.08 * plank.tint, 0.0, 1.0);
    }));
    pictures.push_back(normalsOf("floor_normal", 256, 0.5, [&](double u, double v) {
        const Plank plank = plankAt(u, v, seed);
        return 0.25 * plank.grain + std::min(plank.fromEdge, 2.0) * 0.5;
    }));
}

}  // namespace

double noise(double x, double y, uint32_t periodX, uint32_t periodY, uint64_t seed) {
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const auto at = [&](int dx, int dy) {
        const auto wrapped = [](double value, uint32_t period) {
            const auto rest = static_cast<int64_t>(value) % period;
            return rest < 0 ? rest + period : rest;
        };
        return hashed(wrapped(left + dx, periodX), wrapped(top + dy, periodY), seed);
    };
    const double across = smooth(x - left);
    return glm::mix(glm::mix(at(0, 0), at(1, 0), across), glm::mix(at(0, 1), at(1, 1), across), smooth(y - top));
}

Picture painted(const char* name, uint32_t width, uint32_t height,
                const std::function<glm::dvec4(double u, double v)>& colour) {
    Picture picture{.name = name, .width = width, .height = height, .rgba = {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec4 texel = glm::clamp(colour((x + 0.5) / width, (y + 0.5) / height), 0.0, 1.0);
            for (int c = 0; c < 4; ++c) picture.rgba.push_back(static_cast<uint8_t>(std::lround(255.0 * texel[c])));
        }
    return picture;
}

void addTiledPictures(std::vector<Picture>& pictures, uint64_t seed) {
    addFloor(pictures, seed);
    pictures.push_back(painted("wallpaper", 128, 128, wallpaper));
    pictures.push_back(painted("grain", 128, 128, [&](double u, double v) {
        const double grain = 0.65 * noise(u * 6 + 0.4 * std::sin(2 * kPi * v), v * 48, 6, 48, seed + 3) +
                             0.35 * noise(u * 4, v * 16, 4, 16, seed + 4);
        return opaque(glm::mix(glm::dvec3(0.3, 0.18, 0.11), glm::dvec3(0.5, 0.33, 0.21), grain));
    }));
    pictures.push_back(painted("weave", 64, 64, [&](double u, double v) {
        return opaque(glm::dvec3(0.82 + 0.12 * weaveHeight(u, v) + 0.06 * noise(u * 32, v * 32, 32, 32, seed + 5)));
    }));
    pictures.push_back(normalsOf("weave_normal", 64, 1.6, weaveHeight));
    pictures.push_back(painted("brushed", 64, 64, [&](double u, double v) {
        return glm::dvec4(1.0, 0.28 + 0.16 * noise(u * 4, v * 64, 4, 64, seed + 6), 1.0, 1.0);
    }));
    pictures.push_back(painted("gauze", 64, 64, [](double u, double v) {
        const double thread = 0.5 + 0.25 * std::sin(16 * kPi * u) + 0.25 * std::sin(16 * kPi * v);
        return glm::dvec4(0.97, 0.95, 0.9, 0.5 + 0.3 * thread);
    }));
}

}  // namespace manylight::showcase
