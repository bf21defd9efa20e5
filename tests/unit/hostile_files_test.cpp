// Files that ask for more than they are worth: devices, names that no system takes, memory without data behind it.
#include "engine/core/file.h"
#include "engine/core/finite.h"
#include "engine/image/image_faults.h"
#include "engine/image/image_io.h"
#include "tests/unit/import_test_support.h"

#include <gmock/gmock.h>

#include <limits>

namespace manylight::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class HostileFiles : public SceneFiles {
  protected:
    /// A mesh of one primitive whose positions are claimed and not stored, shown by so many nodes.
    static std::string claimedPositions(size_t count, size_t nodeCount) {
        Json json = {{"asset", {{"version", "2.0"}}}, {"meshes", Json::array()}};
        json["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
        json["accessors"] = {{{"componentType", 5126}, {"count", count}, {"type", "VEC3"}}};
        for (size_t i = 0; i < nodeCount; ++i) json["nodes"].push_back({{"mesh", 0}});
        return json.dump();
    }
};

TEST_F(HostileFiles, DevicesAreNoFiles) {
    try {
        readTextFile("/dev/zero");
        FAIL() << "read to the end";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("/dev/zero: is a device or a pipe, expected a file"));
    }
    const Scene scene = import("a.obj", "mtllib /dev/zero\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(scene.warnings.count("material libraries missing"), 1u);
}

TEST_F(HostileFiles, NamesThatTheSystemRefusesAreMissingFiles) {
    const std::string name(5000, 'n');
    const Scene obj = import("a.obj", "mtllib " + name + ".mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(obj.warnings.count("material libraries missing"), 1u);

    write("b.mtl", "newmtl m\nmap_Kd " + name + ".png\n");
    const Scene mtl = import("b.obj", "mtllib b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    EXPECT_EQ(mtl.warnings.count("textures left out: image not readable"), 1u);

    EXPECT_THAT(errorOf("c.json", R"({"scene": ")" + name + R"(.obj"})"), HasSubstr("expected an existing file"));

    const std::string uri = R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 4, "uri": ")" + name + "\"}]}";
    EXPECT_EQ(import("d.gltf", uri).warnings.count("buffers not readable"), 1u);
}

TEST_F(HostileFiles, AMaterialLibraryIsReadOnce) {
    write("m.mtl", "newmtl m\nKd nan 0 0\n");
    const Scene scene = import("a.obj", "mtllib m.mtl ./m.mtl x/../m.mtl\nmtllib  m.mtl m.mtl\nv 0 0 0\nf 1 1 1\n");
    EXPECT_EQ(scene.warnings.count("material colours set to zero: not finite"), 1u);
}

TEST_F(HostileFiles, MessagesStayOnOneLine) {
    EXPECT_STREQ(Error("a\nb\x1b[2Jc\xc3\xa4").what(), "a?b?[2Jc\xc3\xa4");
    Warnings warnings;
    warnings.add("kind", "a\r\nb");
    EXPECT_EQ(warnings.toText(), "1 kind (a??b)\n");
    const std::string message = errorOf("a.json", R"({"scene": "a\nb.json"})");
    EXPECT_THAT(message, HasSubstr("scene"));
    EXPECT_THAT(message, Not(HasSubstr("\n")));
}

TEST_F(HostileFiles, AnImageHasNoMoreTexelsThanItsBytesCanHold) {
    std::string tga{0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    append<uint16_t>(tga, {16000, 16000});
    tga += {24, 32};
    tga += std::string(100, '\xff');
    try {
        readImage8(reinterpret_cast<const uint8_t*>(tga.data()), tga.size(), "a.tga");
        FAIL() << "read";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("a.tga: image is truncated or damaged: 118 bytes cannot hold 16000 x 16000"));
    }
}

TEST(ImageFaults, AreWhatTheDecoderWouldNotSurvive) {
    const auto faultOf = [](std::string_view bytes) {
        const char* const fault = imageFault({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
        return std::string(fault ? fault : "");
    };
    const auto jpeg = [](const std::string& counts) {
        return "\xff\xd8\xff\xfe" + std::string("\x00\x06zzzz\xff\xc4\x00\x13\x00", 11) + counts;
    };
    EXPECT_EQ(faultOf(jpeg(std::string(16, '\x10') + std::string(256, '\x00'))), "");
    EXPECT_EQ(faultOf(jpeg(std::string(15, '\x10') + '\x11')), "a Huffman table of more than 256 codes");
    EXPECT_EQ(faultOf(jpeg("\xff\xff")), "a Huffman table of more than 256 codes");
    EXPECT_EQ(faultOf('\xff' + jpeg("\xff\xff")), "a Huffman table of more than 256 codes");
    EXPECT_EQ(faultOf("BM" + jpeg("\xff\xff")), "");

    const std::string png = "\x89PNG\r\n\x1a\n";
    EXPECT_EQ(faultOf(png + std::string("\0\0\0\1IDATxcrc4\0\0\0\0IENDcrc4", 25)), "");
    EXPECT_EQ(faultOf(png + std::string("\0\0\0\5IDATxxxx", 12)), "a chunk goes past the end of the file");
    EXPECT_EQ(faultOf(png + std::string("\0\0\0\0IENDcrc4what follows is no chunk", 33)), "");
}

TEST_F(HostileFiles, ClaimsWithoutDataDoNotFillTheMemory) {
    EXPECT_THAT(errorOf("a.gltf", claimedPositions((1 << 20) + 1, 1)),
                HasSubstr("expected an integer in [1, 1048576]"));
    EXPECT_THAT(errorOf("a.gltf", claimedPositions(1 << 18, 100)), HasSubstr("which is too many for a file of"));
    EXPECT_EQ(errorOf("a.gltf", claimedPositions(300, 100)), "");
}

TEST(FiniteBits, AreThoseWithoutAFullExponent) {
    using Limits = std::numeric_limits<float>;
    for (const float value : {0.0f, -0.0f, 1.0f, Limits::denorm_min(), Limits::max(), Limits::lowest()})
        EXPECT_TRUE(hasFiniteBits(value)) << value;
    for (const float value : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), Limits::signaling_NaN()})
        EXPECT_FALSE(hasFiniteBits(value)) << value;
    EXPECT_TRUE(areFiniteBits(0x7f7fffffu));
    EXPECT_FALSE(areFiniteBits(0x7f800000u));
}

}  // namespace
}  // namespace manylight::testing
