#include "engine/metrics/flip_colour.h"

#include <glm/glm.hpp>

namespace manylight::perception {
namespace {

Matrix matrixFrom(const glm::dmat3& matrix) {
    Matrix result{};
    for (glm::length_t row = 0; row < 3; ++row) {
        const glm::vec3 values(matrix[0][row], matrix[1][row], matrix[2][row]);
        result.rows[row] = {values.x, values.y, values.z};
    }
    return result;
}

}  // namespace

const ColourSpace& colourSpace() {
    static const ColourSpace kSpace = [] {
        // IEC 61966-2-1, row by row; GLM takes columns.
        glm::dmat3 xyzFromRgb = glm::transpose(glm::dmat3(0.412386563, 0.357591491, 0.180450491,  //
                                                          0.212636822, 0.715182982, 0.072180196,  //
                                                          0.019330620, 0.119197164, 0.950372587));
        const glm::dvec3 white = xyzFromRgb * glm::dvec3(1.0);
        for (glm::length_t column = 0; column < 3; ++column) xyzFromRgb[column] /= white;
        return ColourSpace{matrixFrom(xyzFromRgb), matrixFrom(glm::inverse(xyzFromRgb))};
    }();
    return kSpace;
}

}  // namespace manylight::perception
