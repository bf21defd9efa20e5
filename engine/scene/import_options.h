// What the user may say about how a scene file is read.
#pragma once

#include <cstdint>

namespace manylight {

enum class InstanceMode : uint8_t {
    Auto,     // share meshes where that saves much memory
    Flatten,  // every triangle in the scene's frame
    Share,    // share every mesh that is shown more than once
};

struct ImportOptions {
    InstanceMode instances = InstanceMode::Auto;
};

}  // namespace manylight
