// What the user may say about how a scene file is read.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

namespace manylight {

enum class InstanceMode : uint8_t {
    Auto,     // share meshes where that saves much memory
    Flatten,  // every triangle in the scene's frame
    Share,    // share every mesh that is shown more than once
};

struct GltfFile;

struct ImportOptions {
    InstanceMode instances = InstanceMode::Auto;
    std::optional<double> time = std::nullopt;  // seconds into the file's animation; none: the rest pose
    bool keepsMoving = false;                   // meshes that the animation moves become instances
    // For another look at the same file: where it is kept open, and whether its meshes are not wanted again.
    std::shared_ptr<const GltfFile>* opened = nullptr;
    bool placesOnly = false;
};

}  // namespace manylight
