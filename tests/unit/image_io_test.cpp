#include "engine/image/image_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <limits>

#include "engine/core/check.h"
#include "engine/core/file.h"
#include "engine/image/srgb.h"

namespace manylight {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A folder of this test's own, removed at the end.
class ImageIoTest : public testing::Test {
  protected:
    ImageIoTest() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~ImageIoTest() override { fs::remove_all(folder_); }

    size_t fileCount() const {
        return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    void truncate(const fs::path& path, double fraction) const {
        fs::resize_file(path, static_cast<uintmax_t>(static_cast<double>(fs::file_size(path)) * fraction));
    }

    const fs::path folder_ =
        fs::path(testing::TempDir()) /
        fmt::format("manylight_image_io_{}", testing::UnitTest::GetInstance()->current_test_info()->name());
};

template <typename Function>
std::string errorOf(const Function& function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "(no Error thrown)";
}

std::vector<uint32_t> bitsOf(const Image& image) {
    std::vector<uint32_t> bits;
    for (const float texel : image.texels) bits.push_back(std::bit_cast<uint32_t>(texel));
    return bits;
}

/// `channels` planes of a slanted gradient with some extreme floats in front.
Image extremeImage(uint32_t width, uint32_t height, uint32_t channels) {
    using Limits = std::numeric_limits<float>;
    Image image(width, height, channels);
    for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = 0.1f * static_cast<float>(i) - 1.0f;
    const float extremes[] = {Limits::infinity(),
                              -Limits::infinity(),
                              Limits::quiet_NaN(),
                              Limits::denorm_min(),
                              Limits::max(),
                              Limits::denorm_min() * 77,
                              -0.0f,
                              Limits::min()};
    std::copy(std::begin(extremes), std::end(extremes), image.texels.begin());
    return image;
}

TEST_F(ImageIoTest, ExrKeepsEveryBit) {
    const Image image = extremeImage(7, 5, 3);
    writeExr(folder_ / "a.exr", {{"", {"R", "G", "B"}, image}}, {});
    const Image back = readExr(folder_ / "a.exr");
    EXPECT_EQ(back.width, 7u);
    EXPECT_EQ(back.height, 5u);
    EXPECT_EQ(back.channels, 3u);
    EXPECT_EQ(bitsOf(back), bitsOf(image));
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageIoTest, ExrLayersAndAttributesComeBack) {
    const Image color = extremeImage(4, 3, 4);
    const Image normal = extremeImage(4, 3, 3);
    const Image depth = extremeImage(4, 3, 1);
    const std::map<std::string, std::string> attributes{{"manylight.seed", "42"}, {"comments", "two words"}};
    writeExr(folder_ / "layers.exr",
             {{"", {"R", "G", "B", "A"}, color}, {"normal", {"X", "Y", "Z"}, normal}, {"depth", {"Z"}, depth}},
             attributes);

    EXPECT_EQ(bitsOf(readExrLayer(folder_ / "layers.exr", "normal", {"X", "Y", "Z"})), bitsOf(normal));
    EXPECT_EQ(bitsOf(readExrLayer(folder_ / "layers.exr", "depth", {"Z"})), bitsOf(depth));
    EXPECT_EQ(bitsOf(readExrLayer(folder_ / "layers.exr", "", {"R", "G", "B", "A"})), bitsOf(color));
    EXPECT_EQ(readExrAttributes(folder_ / "layers.exr"), attributes);
    EXPECT_THAT(errorOf([&] { readExrLayer(folder_ / "layers.exr", "albedo", {"R"}); }),
                AllOf(HasSubstr("layers.exr"), HasSubstr("albedo.R"), HasSubstr("normal.X, normal.Y, normal.Z")));
}

TEST_F(ImageIoTest, ExrLuminanceIsReplicated) {
    Image luminance(2, 1, 1);
    luminance.texels = {0.25f, 4.0f};
    writeExr(folder_ / "y.exr", {{"", {"Y"}, luminance}}, {});
    EXPECT_EQ(readExr(folder_ / "y.exr").texels, (std::vector<float>{0.25f, 0.25f, 0.25f, 4, 4, 4}));
}

TEST_F(ImageIoTest, BrokenExrIsAnErrorThatNamesTheFile) {
    EXPECT_THAT(errorOf([&] { readExr(folder_ / "none.exr"); }), HasSubstr("none.exr"));

    writeTextFile(folder_ / "text.exr", "this is no picture");
    EXPECT_THAT(errorOf([&] { readExr(folder_ / "text.exr"); }), HasSubstr("text.exr"));

    writeExr(folder_ / "cut.exr", {{"", {"R", "G", "B"}, extremeImage(64, 64, 3)}}, {});
    for (const double fraction : {0.9, 0.5, 0.02}) {
        truncate(folder_ / "cut.exr", fraction);
        EXPECT_THAT(errorOf([&] { readExr(folder_ / "cut.exr"); }), AllOf(HasSubstr("cut.exr"), Not(HasSubstr("\n"))));
    }
}

TEST_F(ImageIoTest, OurOwnMistakesAreBugs) {
    const Image image(4, 4, 3);
    EXPECT_THROW(writeExr(folder_ / "a.exr", {{"", {"R"}, image}}, {}), BugError);
    EXPECT_THROW(writeExr(folder_ / "a.exr", {{"", {"R", "G", "B"}, image}, {"z", {"Z"}, Image(4, 5, 1)}}, {}),
                 BugError);
    EXPECT_THROW(writeExr(folder_ / "a.exr", {{"", {"R", "G", "B"}, image}}, {{"compression", "x"}}), BugError);
    EXPECT_THROW(writePng(folder_ / "a.png", Image(4, 4, 2)), BugError);
    EXPECT_EQ(fileCount(), 0u);
}

TEST_F(ImageIoTest, AFailingWriterLeavesTheOldFileAndNothingElse) {
    writeTextFile(folder_ / "a.txt", "old");
    EXPECT_THROW(writeAtomically(folder_ / "a.txt",
                                 [](const fs::path& temporary) {
                                     std::ofstream(temporary) << "half of the new";
                                     fail("disk full");
                                 }),
                 Error);
    EXPECT_EQ(readTextFile(folder_ / "a.txt"), "old");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageIoTest, UnwritableTargetsAreErrors) {
    const Image image(4, 4, 3);
    writeTextFile(folder_ / "file", "");
    for (const fs::path& target : {folder_ / "missing" / "a", folder_ / "file" / "a", folder_}) {
        EXPECT_THROW(writePng(target, image), Error) << target;
        EXPECT_THROW(writeExr(target, {{"", {"R", "G", "B"}, image}}, {}), Error) << target;
    }
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(ImageIoTest, PngHoldsTheSrgbCurve) {
    // Code values by the formula of IEC 61966-2-1: both ends, where the curve changes its branch, mid grey, a half.
    Image image(7, 1, 1);
    image.texels = {0.0f, 0.0031308f, 0.18f, 0.5f, 1.0f, -3.0f, 70.0f};
    writePng(folder_ / "srgb.png", image);
    const EncodedImage back = readImage8(folder_ / "srgb.png");
    ASSERT_EQ(back.width, 7u);
    ASSERT_EQ(back.height, 1u);
    const uint8_t expected[] = {0, 10, 118, 188, 255, 0, 255};
    for (size_t x = 0; x < 7; ++x) {
        for (size_t c = 0; c < 3; ++c) EXPECT_EQ(back.rgba[x * 4 + c], expected[x]) << x;
        EXPECT_EQ(back.rgba[x * 4 + 3], 255) << x;
    }
}

TEST_F(ImageIoTest, NonFiniteTexelsAreMagenta) {
    Image image(3, 1, 3);
    image.texels[1] = std::numeric_limits<float>::quiet_NaN();
    image.texels[5] = std::numeric_limits<float>::infinity();
    writePng(folder_ / "nan.png", image);
    EXPECT_EQ(readImage8(folder_ / "nan.png").rgba,
              (std::vector<uint8_t>{255, 0, 255, 255, 255, 0, 255, 255, 0, 0, 0, 255}));
}

TEST_F(ImageIoTest, SrgbCurveIsItsOwnInverse) {
    for (int code = 0; code < 256; ++code) {
        const float encoded = static_cast<float>(code) / 255.0f;
        EXPECT_NEAR(encodeSrgb(decodeSrgb(encoded)), encoded, 1e-6f);
    }
}

/// An uncompressed 24-bit TGA, 4 x 4, as its specification lays it out.
std::string smallTga() {
    std::string bytes("\0\0\2\0\0\0\0\0\0\0\0\0\4\0\4\0\30\40", 18);
    for (char i = 0; i < 48; ++i) bytes += i;
    return bytes;
}

TEST_F(ImageIoTest, TruncatedTexturesAreErrors) {
    Image noise(40, 40, 3);
    for (size_t i = 0; i < noise.texels.size(); ++i) noise.texels[i] = static_cast<float>((i * 7919) % 97) / 96.0f;
    writePng(folder_ / "cut.png", noise);
    for (const double fraction : {0.95, 0.5, 0.01}) {
        truncate(folder_ / "cut.png", fraction);
        EXPECT_THAT(errorOf([&] { readImage8(folder_ / "cut.png"); }), HasSubstr("cut.png"));
    }

    const std::string tga = smallTga();
    const auto* bytes = reinterpret_cast<const uint8_t*>(tga.data());
    const EncodedImage whole = readImage8(bytes, tga.size(), "small.tga");
    EXPECT_EQ(whole.width, 4u);
    EXPECT_EQ((std::vector<uint8_t>(whole.rgba.begin(), whole.rgba.begin() + 4)), (std::vector<uint8_t>{2, 1, 0, 255}));
    for (size_t size = 0; size < tga.size(); ++size)
        EXPECT_THAT(errorOf([&] { readImage8(bytes, size, "small.tga"); }), HasSubstr("small.tga")) << size;
}

TEST_F(ImageIoTest, UnknownImagesAreErrors) {
    EXPECT_THAT(errorOf([&] { readImage8(folder_ / "none.png"); }), HasSubstr("none.png"));
    EXPECT_THAT(errorOf([&] { readImage8(folder_); }), HasSubstr(folder_.string()));
    writeTextFile(folder_ / "text.png", "this is no picture");
    EXPECT_THAT(errorOf([&] { readImage8(folder_ / "text.png"); }),
                AllOf(HasSubstr("text.png"), HasSubstr("expected PNG, JPEG, TGA or BMP")));
}

TEST_F(ImageIoTest, PngsKeepTheirAlphaChannel) {
    const std::vector<uint8_t> rgba{0, 1, 2, 0, 255, 254, 253, 128, 10, 20, 30, 255,
                                    7, 7, 7, 1, 90,  0,   9,   64,  3,  2,  1,  200};
    writePngRgba8(folder_ / "a.png", 3, 2, rgba);
    const EncodedImage back = readImage8(folder_ / "a.png");
    EXPECT_EQ(back.width, 3u);
    EXPECT_EQ(back.height, 2u);
    EXPECT_EQ(back.rgba, rgba);
    EXPECT_EQ(fileCount(), 1u);
}

}  // namespace
}  // namespace manylight
