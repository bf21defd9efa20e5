#include "engine/metrics/false_colour.h"

#include <algorithm>
#include <array>

namespace manylight {
namespace {

using Scale = std::array<glm::vec3, 17>;

// Every sixteenth colour of matplotlib's tables "magma" and "coolwarm" (public domain, CC0); between them, a straight
// line is within 0.03 of the table.
const Scale kMagma = {{{0.001f, 0.000f, 0.014f},
                       {0.040f, 0.031f, 0.134f},
                       {0.113f, 0.065f, 0.277f},
                       {0.212f, 0.062f, 0.419f},
                       {0.317f, 0.072f, 0.485f},
                       {0.415f, 0.110f, 0.505f},
                       {0.513f, 0.148f, 0.508f},
                       {0.614f, 0.182f, 0.499f},
                       {0.716f, 0.215f, 0.475f},
                       {0.811f, 0.253f, 0.439f},
                       {0.900f, 0.315f, 0.391f},
                       {0.958f, 0.411f, 0.360f},
                       {0.986f, 0.528f, 0.379f},
                       {0.996f, 0.646f, 0.441f},
                       {0.997f, 0.762f, 0.529f},
                       {0.993f, 0.877f, 0.633f},
                       {0.987f, 0.991f, 0.750f}}};
const Scale kBlueGreyRed = {{{0.230f, 0.299f, 0.754f},
                             {0.304f, 0.407f, 0.845f},
                             {0.384f, 0.510f, 0.918f},
                             {0.468f, 0.606f, 0.969f},
                             {0.554f, 0.690f, 0.996f},
                             {0.641f, 0.761f, 0.998f},
                             {0.724f, 0.815f, 0.976f},
                             {0.801f, 0.850f, 0.930f},
                             {0.867f, 0.864f, 0.863f},
                             {0.923f, 0.829f, 0.777f},
                             {0.958f, 0.771f, 0.680f},
                             {0.970f, 0.696f, 0.581f},
                             {0.958f, 0.604f, 0.483f},
                             {0.924f, 0.499f, 0.389f},
                             {0.870f, 0.379f, 0.301f},
                             {0.796f, 0.242f, 0.221f},
                             {0.706f, 0.016f, 0.150f}}};

glm::vec3 colourAt(const Scale& scale, float place) {
    const float last = static_cast<float>(scale.size() - 1);
    const float position = std::clamp(place, 0.0f, 1.0f) * last;
    const auto below = std::min(static_cast<size_t>(position), scale.size() - 2);
    return glm::mix(scale[below], scale[below + 1], position - static_cast<float>(below));
}

}  // namespace

glm::vec3 magma(float value) { return colourAt(kMagma, value); }

glm::vec3 blueGreyRed(float value) { return colourAt(kBlueGreyRed, 0.5f + 0.5f * value); }

}  // namespace manylight
