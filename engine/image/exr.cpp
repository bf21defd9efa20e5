#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "engine/core/check.h"
#include "engine/core/file.h"
#include "engine/image/image_io.h"

namespace manylight {

namespace {

constexpr int64_t kMaxPixels = int64_t{1} << 26;  // a damaged header must not make us reserve the whole memory

std::string channelName(const std::string& layer, const std::string& suffix) {
    return layer.empty() ? suffix : layer + "." + suffix;
}

Imf::Slice sliceOf(const Image& image, uint32_t channel, const Imath::Box2i& window) {
    const size_t texelBytes = sizeof(float) * image.channels;
    return Imf::Slice::Make(Imf::FLOAT, image.texels.data() + channel, window, texelBytes, texelBytes * image.width);
}

std::vector<std::string> channelNames(const Imf::ChannelList& channels) {
    std::vector<std::string> names;
    for (auto it = channels.begin(); it != channels.end(); ++it) names.emplace_back(it.name());
    return names;
}

/// Reads the named channels into one image; all of them must exist at full resolution.
Image readChannels(Imf::InputFile& file, const std::string& path, const std::vector<std::string>& names) {
    const Imath::Box2i window = file.header().dataWindow();
    const int64_t width = int64_t{window.max.x} - window.min.x + 1;
    const int64_t height = int64_t{window.max.y} - window.min.y + 1;
    if (width * height > kMaxPixels) fail("{}: {} x {} pixels are more than are read", path, width, height);

    const Imf::ChannelList& available = file.header().channels();
    Image image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), static_cast<uint32_t>(names.size()));
    Imf::FrameBuffer frame;
    for (uint32_t c = 0; c < image.channels; ++c) {
        const Imf::Channel* channel = available.findChannel(names[c]);
        if (!channel)
            fail("{}: no channel \"{}\"; the file has {}", path, names[c], fmt::join(channelNames(available), ", "));
        if (channel->xSampling != 1 || channel->ySampling != 1)
            fail("{}: channel \"{}\" is subsampled, expected full resolution", path, names[c]);
        frame.insert(names[c], sliceOf(image, c, window));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return image;
}

/// Opens `path` and calls `read(file)`; whatever the library throws becomes one line that names the file.
template <typename Read>
auto withExrFile(const std::filesystem::path& path, const Read& read) {
    Imf::StdISStream stream;
    stream.str(readTextFile(path));
    try {
        Imf::InputFile file(stream);
        return read(file);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        std::string reason = error.what();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        fail("{}: not a readable EXR file: {}", path.string(), reason);
    }
}

Imf::Header headerOf(const std::vector<ExrLayer>& layers, const std::map<std::string, std::string>& attributes) {
    const Image& first = layers.front().image;
    Imf::Header header(static_cast<int>(first.width), static_cast<int>(first.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, value] : attributes) {
        MANYLIGHT_CHECK(header.find(name) == header.end(), "attribute \"{}\" is one that EXR itself defines", name);
        header.insert(name, Imf::StringAttribute(value));
    }
    for (const ExrLayer& layer : layers)
        for (const std::string& suffix : layer.suffixes)
            header.channels().insert(channelName(layer.name, suffix), Imf::Channel(Imf::FLOAT));
    return header;
}

}  // namespace

void writeExr(const std::filesystem::path& path, const std::vector<ExrLayer>& layers,
              const std::map<std::string, std::string>& attributes) {
    MANYLIGHT_CHECK(layers.size() > 0u, "{}", path.string());
    const Imf::Header header = headerOf(layers, attributes);

    Imf::FrameBuffer frame;
    for (const ExrLayer& layer : layers) {
        const Image& image = layer.image;
        MANYLIGHT_CHECK(image.texels.size() > 0u, "layer \"{}\"", layer.name);
        MANYLIGHT_CHECK(image.width == layers.front().image.width, "layer \"{}\"", layer.name);
        MANYLIGHT_CHECK(image.height == layers.front().image.height, "layer \"{}\"", layer.name);
        MANYLIGHT_CHECK(layer.suffixes.size() == image.channels, "layer \"{}\"", layer.name);
        for (uint32_t c = 0; c < image.channels; ++c)
            frame.insert(channelName(layer.name, layer.suffixes[c]), sliceOf(image, c, header.dataWindow()));
    }

    // Encoded in memory: the library's file writer does not report a disk that fills up while it closes.
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(layers.front().image.height));
    }
    writeTextFile(path, stream.str());
}

Image readExr(const std::filesystem::path& path) {
    return withExrFile(path, [&](Imf::InputFile& file) {
        const Imf::ChannelList& channels = file.header().channels();
        if (channels.findChannel("R") || !channels.findChannel("Y"))
            return readChannels(file, path.string(), {"R", "G", "B"});

        const Image luminance = readChannels(file, path.string(), {"Y"});
        Image image(luminance.width, luminance.height, 3);
        for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = luminance.texels[i / 3];
        return image;
    });
}

Image readExrLayer(const std::filesystem::path& path, const std::string& name,
                   const std::vector<std::string>& suffixes) {
    return withExrFile(path, [&](Imf::InputFile& file) {
        std::vector<std::string> names;
        for (const std::string& suffix : suffixes) names.push_back(channelName(name, suffix));
        return readChannels(file, path.string(), names);
    });
}

std::vector<std::string> exrChannelNames(const std::filesystem::path& path) {
    return withExrFile(path, [](Imf::InputFile& file) { return channelNames(file.header().channels()); });
}

std::map<std::string, std::string> readExrAttributes(const std::filesystem::path& path) {
    return withExrFile(path, [](Imf::InputFile& file) {
        std::map<std::string, std::string> attributes;
        for (auto it = file.header().begin(); it != file.header().end(); ++it)
            if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute()))
                attributes.emplace(it.name(), text->value());
        return attributes;
    });
}

}  // namespace manylight
