#include "engine/scene/gltf_skins.h"

#include "engine/core/error.h"

#include <algorithm>
#include <cmath>

namespace manylight {
namespace {

constexpr int kMostSets = 2;  // of four joints each
// Eight weights that sum to one are off by less than this if each is rounded to 16 bits.
constexpr double kSumTolerance = 1e-4;

std::string setName(const char* semantic, int set) { return fmt::format("{}_{}", semantic, set); }

bool hasSet(const tinygltf::Primitive& primitive, int set) {
    return primitive.attributes.contains(setName("JOINTS", set)) &&
           primitive.attributes.contains(setName("WEIGHTS", set));
}

}  // namespace

std::vector<glm::dmat4> GltfSkins::boundFromMesh(size_t skin, size_t jointCount) {
    const Json& json = gltf_.container.json["skins"][skin];
    std::vector<glm::dmat4> matrices(jointCount, glm::dmat4(1.0));
    if (!json.contains("inverseBindMatrices")) return matrices;
    const std::string place = fmt::format("skins[{}].inverseBindMatrices", skin);
    const int accessor = json["inverseBindMatrices"].get<int>();
    numbersRead_ += 16 * gltf_.model.accessors.at(static_cast<size_t>(accessor)).count;
    checkGltfAmount(gltf_, numbersRead_, place, "numbers of inverse bind matrices");
    const std::vector<double> numbers = readGltfNumbers(gltf_, accessor);
    for (size_t joint = 0; joint < jointCount; ++joint) {
        glm::dmat4& matrix = matrices[joint];
        for (int i = 0; i < 16; ++i) {
            matrix[i / 4][i % 4] = numbers[16 * joint + static_cast<size_t>(i)];
            if (!std::isfinite(matrix[i / 4][i % 4]))
                fail("{}: {}: matrix {} is not finite, expected finite numbers", gltf_.container.file, place, joint);
        }
        const glm::dvec4 lastRow(matrix[0][3], matrix[1][3], matrix[2][3], matrix[3][3]);
        if (lastRow != glm::dvec4(0.0, 0.0, 0.0, 1.0))
            warnings_.add("inverse bind matrices taken as affine: last row is not 0 0 0 1", place);
        for (int column = 0; column < 4; ++column) matrix[column][3] = column == 3 ? 1.0 : 0.0;
    }
    return matrices;
}

std::vector<glm::dmat4> GltfSkins::sceneFromBound(size_t skin) {
    const Json& joints = gltf_.container.json["skins"][skin]["joints"];
    std::vector<glm::dmat4> matrices = boundFromMesh(skin, joints.size());
    for (size_t i = 0; i < joints.size(); ++i) {
        const NodePlace& place = places_.at(joints[i].get<size_t>());
        if (!place.isKnown)
            fail("{}: skins[{}].joints[{}]: nodes[{}] is in a loop of nodes or below one, expected a tree",
                 gltf_.container.file, skin, i, joints[i].get<size_t>());
        matrices[i] = place.sceneFromNode * matrices[i];
    }
    return matrices;
}

bool GltfSkins::moves(size_t skin) const {
    return std::ranges::any_of(gltf_.container.json["skins"][skin]["joints"],
                               [&](const Json& joint) { return places_.at(joint.get<size_t>()).moves; });
}

bool hasGltfJoints(const tinygltf::Primitive& primitive) { return hasSet(primitive, 0); }

GltfSkinning::GltfSkinning(const GltfFile& gltf, const tinygltf::Primitive& primitive,
                           const std::vector<glm::dmat4>& sceneFromBound, const std::string& place, Warnings& warnings)
    : sceneFromBound_(sceneFromBound) {
    int sets = 0;
    while (sets < kMostSets && hasSet(primitive, sets)) ++sets;
    if (hasSet(primitive, kMostSets)) warnings.add("joints beyond the eighth of a vertex ignored", place);
    perVertex_ = 4 * static_cast<size_t>(sets);
    const auto positions = static_cast<size_t>(primitive.attributes.at("POSITION"));
    influences_.resize(perVertex_ * gltf.model.accessors.at(positions).count);
    for (int set = 0; set < sets; ++set) readSet(gltf, primitive, set, place, warnings);
    normaliseWeights(place, warnings);
}

void GltfSkinning::readSet(const GltfFile& gltf, const tinygltf::Primitive& primitive, int set,
                           const std::string& place, Warnings& warnings) {
    const std::vector<double> joints = readGltfNumbers(gltf, primitive.attributes.at(setName("JOINTS", set)));
    const std::vector<double> weights = readGltfNumbers(gltf, primitive.attributes.at(setName("WEIGHTS", set)));
    uint64_t wrong = 0;
    for (size_t i = 0; i < joints.size(); ++i) {
        const bool isRight = std::isfinite(weights[i]) && weights[i] >= 0.0;
        if (!isRight) ++wrong;
        if (!isRight || weights[i] == 0.0) continue;
        const auto joint = static_cast<size_t>(joints[i]);
        if (joint >= sceneFromBound_.size())
            fail("{}: {}.attributes.{}: vertex {} follows joint {}, expected one of the skin's {}", gltf.container.file,
                 place, setName("JOINTS", set), i / 4, joint, sceneFromBound_.size());
        influences_[perVertex_ * (i / 4) + 4 * static_cast<size_t>(set) + i % 4] = {joint, weights[i]};
    }
    warnings.add("joint weights set to zero: negative or not finite", place, wrong);
}

void GltfSkinning::normaliseWeights(const std::string& place, Warnings& warnings) {
    uint64_t loose = 0;
    uint64_t unequal = 0;
    for (size_t first = 0; first < influences_.size(); first += perVertex_) {
        double sum = 0.0;
        for (size_t i = 0; i < perVertex_; ++i) sum += influences_[first + i].weight;
        const bool isLoose = !(sum > 0.0);
        if (isLoose) {
            ++loose;
            for (size_t i = 0; i < perVertex_; ++i) influences_[first + i].weight = i == 0 ? 1.0 : 0.0;
            continue;
        }
        if (std::abs(sum - 1.0) > kSumTolerance) ++unequal;
        for (size_t i = 0; i < perVertex_; ++i) influences_[first + i].weight /= sum;
    }
    warnings.add("vertices that follow no joint: they follow the skin's first", place, loose);
    warnings.add("joint weights normalised: their sum is not one", place, unequal);
}

glm::dmat4 GltfSkinning::sceneFromVertex(size_t vertex) const {
    glm::dmat4 blended(0.0);
    for (size_t i = 0; i < perVertex_; ++i) {
        const Influence& influence = influences_[perVertex_ * vertex + i];
        if (influence.weight != 0.0) blended += influence.weight * sceneFromBound_[influence.joint];
    }
    return blended;
}

}  // namespace manylight
