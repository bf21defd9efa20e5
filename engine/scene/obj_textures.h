// The textures of MTL files.
#pragma once

#include "engine/scene/mtl.h"
#include "engine/scene/raw_scene.h"
#include "engine/scene/texture_file.h"

#include <filesystem>
#include <map>
#include <string>

namespace manylight {

/// A path as a file written on any system spells it.
std::filesystem::path portablePath(std::string_view text);

/// Loads textures into a scene, each once. One that cannot be read is counted and left out.
class ObjTextures {
  public:
    explicit ObjTextures(RawScene& scene) : warnings_(scene.warnings), textures_(scene.textures, scene.warnings) {}

    TextureUse colour(const std::filesystem::path& folder, const MtlMap& map);

    struct Coverage {
        TextureUse use;
        bool isCutout = false;  // (nearly) all or nothing everywhere
    };
    /// The image's own alpha channel if it has one, else the channel that the map names, as alpha.
    Coverage coverage(const std::filesystem::path& folder, const MtlMap& map);

    struct Normals {
        TextureUse use;
        double scale = 1.0;  // Material::normalScale
    };
    /// A height field becomes normals; white stands a hundredth of the image's larger side times -bm above black. An
    /// image that evidently holds normals already is taken as it is, counted.
    Normals bump(const std::filesystem::path& folder, const MtlMap& map);

  private:
    struct Image {
        int32_t texture = kNoTexture;
        bool isAsStored = false;
        bool isCutout = false;
    };
    Image loadCoverage(const std::filesystem::path& folder, const MtlMap& map);
    Image loadBump(const std::filesystem::path& folder, const MtlMap& map);
    std::optional<EncodedImage> decode(const std::filesystem::path& folder, const MtlMap& map);

    Warnings& warnings_;
    TextureLoader textures_;
    std::map<std::string, Image> images_;  // by what they were made of and how
};

}  // namespace manylight
