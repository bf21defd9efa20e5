// Textures for the importers: each image is decoded once, one that cannot be read is counted and left out.
#pragma once

#include "engine/image/image_io.h"
#include "engine/scene/scene.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace manylight {

/// Adds textures to a scene's list. The same name with the same wrap and filter is decoded and stored once.
class TextureLoader {
  public:
    using Decode = std::function<EncodedImage()>;

    TextureLoader(std::vector<Texture>& textures, Warnings& warnings) : textures_(&textures), warnings_(&warnings) {}

    /// `sampling` gives name, wrap and filter; `decode` may throw Error. Returns an index into the scene's textures or
    /// kNoTexture, counted in the warnings.
    int32_t load(const Texture& sampling, const Decode& decode);

    /// Decodes without storing; empty, counted, if it throws Error.
    std::optional<EncodedImage> decode(const Decode& decode);

  private:
    std::vector<Texture>* textures_;
    Warnings* warnings_;
    std::map<std::string, int32_t> loaded_;
};

}  // namespace manylight
