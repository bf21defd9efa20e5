#include "engine/scene/texture_file.h"

#include "engine/core/error.h"

namespace manylight {

std::optional<EncodedImage> TextureLoader::decode(const Decode& decode) {
    try {
        return decode();
    } catch (const Error& error) {
        // A scene without one of its pictures is still worth showing.
        warnings_->add("textures left out: image not readable", error.what());
        return std::nullopt;
    }
}

int32_t TextureLoader::load(const Texture& sampling, const Decode& decodeImage) {
    const std::string key =
        fmt::format("{}|{}|{}|{}|{}", sampling.name, static_cast<int>(sampling.wrapU), static_cast<int>(sampling.wrapV),
                    static_cast<int>(sampling.filter), sampling.isMipmapped);
    if (const auto found = loaded_.find(key); found != loaded_.end()) return found->second;
    int32_t index = kNoTexture;
    if (std::optional<EncodedImage> image = decode(decodeImage)) {
        Texture texture = sampling;
        texture.width = image->width;
        texture.height = image->height;
        texture.rgba = std::move(image->rgba);
        index = static_cast<int32_t>(textures_->size());
        textures_->push_back(std::move(texture));
    }
    loaded_.emplace(key, index);
    return index;
}

}  // namespace manylight
