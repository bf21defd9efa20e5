// The statements of an OBJ file as arrays, before faces become triangles.
#pragma once

#include "engine/core/report.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace manylight {

inline constexpr int32_t kNoIndex = -1;
inline constexpr int32_t kBadIndex = INT32_MAX;  // zero in the file, or relative to before the first element

/// Indices from zero into ObjStatements::positions, uvs and normals; kNoIndex where the file gives none.
struct ObjCorner {
    int32_t position = kNoIndex;
    int32_t uv = kNoIndex;
    int32_t normal = kNoIndex;
};

struct ObjFace {
    uint32_t firstCorner = 0;
    uint32_t cornerCount = 0;
    uint32_t material = 0;  // index into materialNames
    uint32_t line = 0;
};

struct ObjStatements {
    std::vector<glm::dvec3> positions;  // a malformed one is NaN, so that only its faces are lost
    std::vector<glm::dvec3> colours;    // of the positions, sRGB encoded as written; empty if none has one
    std::vector<glm::dvec3> normals;
    std::vector<glm::dvec2> uvs;  // v up
    std::vector<ObjCorner> corners;
    std::vector<ObjFace> faces;
    std::vector<std::string> materialNames;      // as usemtl names them; empty for faces before any usemtl
    std::vector<std::string> materialLibraries;  // arguments of mtllib, whole lines
};

/// Parses OBJ text. What cannot be used is counted with its line. Throws Error if no line is an OBJ statement.
ObjStatements parseObj(std::string_view text, const std::string& file, Warnings& warnings);

}  // namespace manylight
