// The files a capture leaves.
#pragma once

#include "apps/capture/capture.h"
#include "engine/graph/execute.h"
#include "engine/image/image_io.h"

namespace manylight {

/// sRGB-encoded RGBA bytes, as displayed.
struct DisplayImage {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
};

DisplayImage besideEachOther(const std::vector<DisplayImage>& pictures);

/// Throws Error (usage) for no output, or one that is neither .exr nor .png, or does not fit the other options.
void checkOutputs(const CaptureOptions& options);

void writeOutputs(const std::vector<std::filesystem::path>& outputs, const Image& radiance,
                  const std::vector<ExrLayer>& aovs, const DisplayImage& display, const Json& report);
void writeSideBySide(const std::vector<std::filesystem::path>& outputs, const DisplayImage& display);

/// One EXR per image of --dump-pass: <output stem>.<pass>.<resource>.exr, integers as floats.
void writeDumps(const CaptureOptions& options, const std::vector<DumpedImage>& dumped);

}  // namespace manylight
