// Small scene files written by the tests themselves.
#pragma once

#include "engine/core/error.h"
#include "engine/scene/import.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace manylight::testing {

/// A folder of its own for each test, gone afterwards.
class SceneFiles : public ::testing::Test {
  protected:
    SceneFiles() {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("manylight_") + info->test_suite_name() + "_" + info->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~SceneFiles() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, std::string_view content) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name, std::ios::binary) << content;
        return folder_ / name;
    }
    Scene import(const std::string& name, std::string_view content) const { return importScene(write(name, content)); }

    /// The message of the Error that importing this content ends in; empty if it does not.
    std::string errorOf(const std::string& name, std::string_view content) const {
        try {
            import(name, content);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }

    std::filesystem::path folder_;
};

/// A corner's position in the file's own units.
inline glm::dvec3 filePosition(const Scene& scene, size_t triangle, size_t corner) {
    const Vertex& vertex = scene.vertices.at(scene.triangles.at(triangle).vertex.at(corner));
    return scene.frame.center + glm::dvec3(vertex.position) * std::ldexp(1.0, scene.frame.exponent);
}

inline const Vertex& cornerOf(const Scene& scene, size_t triangle, size_t corner) {
    return scene.vertices.at(scene.triangles.at(triangle).vertex.at(corner));
}

/// Cross product of two edges in file units: twice the area, towards the front.
inline glm::dvec3 frontOf(const Scene& scene, size_t triangle) {
    const glm::dvec3 a = filePosition(scene, triangle, 0);
    return glm::cross(filePosition(scene, triangle, 1) - a, filePosition(scene, triangle, 2) - a);
}

inline double totalArea(const Scene& scene) {
    double area = 0.0;
    for (size_t t = 0; t < scene.triangles.size(); ++t) area += 0.5 * glm::length(frontOf(scene, t));
    return area;
}

inline bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance = 1e-6) {
    return glm::length(a - b) <= tolerance;
}

template <typename T>
void append(std::string& bytes, std::initializer_list<T> values) {
    for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

inline std::string base64(std::string_view bytes) {
    constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t j = 0; j < 3; ++j)
            group = group << 8 | (i + j < bytes.size() ? static_cast<uint8_t>(bytes[i + j]) : 0u);
        for (size_t j = 0; j < 4; ++j) text += i + j <= bytes.size() ? kDigits[(group >> (18 - 6 * j)) & 63] : '=';
    }
    return text;
}

inline std::string dataUri(std::string_view bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

/// A GLB of a JSON text and binary data.
inline std::string glb(std::string json, std::string binary) {
    while (json.size() % 4 != 0) json += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    std::string bytes = "glTF";
    append<uint32_t>(bytes, {2u, static_cast<uint32_t>(12 + 8 + json.size() + 8 + binary.size())});
    append<uint32_t>(bytes, {static_cast<uint32_t>(json.size()), 0x4e4f534au});
    bytes += json;
    append<uint32_t>(bytes, {static_cast<uint32_t>(binary.size()), 0x004e4942u});
    return bytes + binary;
}

/// An image as uncompressed TGA, four bytes per texel, rows from the top.
inline std::string rgbaTga(uint8_t width, uint8_t height, const std::vector<uint8_t>& rgba) {
    std::string bytes(18, '\0');
    bytes[2] = 2;
    bytes[12] = static_cast<char>(width);
    bytes[14] = static_cast<char>(height);
    bytes[16] = 32;
    bytes[17] = 40;
    for (size_t i = 0; i + 3 < rgba.size(); i += 4)
        append<uint8_t>(bytes, {rgba[i + 2], rgba[i + 1], rgba[i], rgba[i + 3]});
    return bytes;
}

/// A 2 x 1 image (red, green) as uncompressed TGA, rows from the top.
inline std::string redGreenTga() {
    std::string bytes{0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 1, 0, 24, 32};
    append<uint8_t>(bytes, {0, 0, 255, 0, 255, 0});
    return bytes;
}

}  // namespace manylight::testing
