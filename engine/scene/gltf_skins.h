// glTF skins: meshes that follow joints.
#pragma once

#include "engine/scene/gltf_accessor.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace manylight {

/// A node in the scene, at the time that is shown.
struct NodePlace {
    glm::dmat4 sceneFromNode{1.0};
    bool isKnown = false;  // a node in a loop has no place
    bool moves = false;    // by the animation, like its descendants
};

/// Reads skins, whose matrices a file may share.
class GltfSkins {
  public:
    GltfSkins(const GltfFile& gltf, const std::vector<NodePlace>& places, Warnings& warnings)
        : gltf_(gltf), places_(places), warnings_(warnings) {}

    /// Where a joint takes what is bound to it: its place times its inverse bind matrix. By joint. Throws Error.
    std::vector<glm::dmat4> sceneFromBound(size_t skin);
    bool moves(size_t skin) const;

  private:
    std::vector<glm::dmat4> boundFromMesh(size_t skin, size_t jointCount);

    const GltfFile& gltf_;
    const std::vector<NodePlace>& places_;  // by node
    Warnings& warnings_;
    size_t numbersRead_ = 0;
};

/// Whether a primitive says which joints it follows.
bool hasGltfJoints(const tinygltf::Primitive& primitive);

/// How the vertices of a primitive follow joints: linear blending of up to eight of them, as the file asks.
class GltfSkinning {
  public:
    /// The weights of a vertex are made to sum to one; those that did not, or that are no weights, are counted. Throws
    /// Error for a joint that the skin does not have. `sceneFromBound` must outlive it.
    GltfSkinning(const GltfFile& gltf, const tinygltf::Primitive& primitive,
                 const std::vector<glm::dmat4>& sceneFromBound, const std::string& place, Warnings& warnings);

    glm::dmat4 sceneFromVertex(size_t vertex) const;

  private:
    void readSet(const GltfFile& gltf, const tinygltf::Primitive& primitive, int set, const std::string& place,
                 Warnings& warnings);
    void normaliseWeights(const std::string& place, Warnings& warnings);

    struct Influence {
        size_t joint = 0;
        double weight = 0.0;
    };
    const std::vector<glm::dmat4>& sceneFromBound_;
    size_t perVertex_ = 0;
    std::vector<Influence> influences_;  // perVertex_ for each vertex
};

}  // namespace manylight
