#include "tests/unit/import_test_support.h"

namespace manylight::testing {
namespace {

using ObjImport = SceneFiles;

constexpr std::string_view kCubeVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
constexpr std::string_view kCubeFaces =
    "g bottom\nusemtl red\nf 4 3 2 1\ng top\nf 5 6 7 8\ng sides\nusemtl blue\n"
    "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
constexpr std::string_view kColours = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nKe 2 3 4\n";

std::string cube(std::string_view header) {
    return std::string(header) + std::string(kCubeVertices) + std::string(kCubeFaces);
}

/// The cube with faces as if written by another program: same text, other separators.
std::string withReplaced(std::string text, std::string_view from, std::string_view to) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

TEST_F(ObjImport, ReadsQuadCubeWithGroupsAndMaterials) {
    write("colours.mtl", kColours);
    const Scene scene = import("cube.obj", cube("mtllib colours.mtl\n"));
    EXPECT_EQ(scene.triangles.size(), 12u);
    EXPECT_EQ(scene.vertices.size(), 8u);
    ASSERT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(1, 0, 0));
    EXPECT_EQ(scene.materials[1].emittedRadiance, glm::vec3(2, 3, 4));
    EXPECT_EQ(scene.triangles[3].material, 0u);
    EXPECT_EQ(scene.triangles[4].material, 1u);
    EXPECT_NEAR(totalArea(scene), 6.0, 1e-6);
    EXPECT_EQ(scene.importReport["emissiveTriangles"], 8u);
    for (size_t t = 0; t < 12; ++t) {
        const glm::dvec3 middle =
            (filePosition(scene, t, 0) + filePosition(scene, t, 1) + filePosition(scene, t, 2)) / 3.0;
        EXPECT_GT(glm::dot(frontOf(scene, t), middle - glm::dvec3(0.5)), 0.0) << "triangle " << t << " faces inwards";
        EXPECT_EQ(cornerOf(scene, t, 0).normal, glm::vec3(0.0f));
    }
}

TEST_F(ObjImport, MissingLibraryGivesCountedGrey) {
    const Scene scene = import("cube.obj", cube("mtllib nowhere.mtl\n"));
    EXPECT_EQ(scene.triangles.size(), 12u);
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0.8f));
    EXPECT_EQ(scene.warnings.count("material libraries missing"), 1u);
    EXPECT_EQ(scene.warnings.count("materials not defined: given the default grey"), 2u);
}

TEST_F(ObjImport, LineEndsTabsAndContinuationsDoNotMatter) {
    const std::string plain = cube("");
    const Scene expected = import("plain.obj", plain);
    const std::string variants[] = {withReplaced(plain, "\n", "\r\n"), withReplaced(plain, "\n", "\r"),
                                    withReplaced(plain, " ", "\t \t"), withReplaced(plain, "f ", "  f \\\n "),
                                    plain.substr(0, plain.size() - 1), withReplaced(plain, "\n", " # note\n\n")};
    for (size_t i = 0; i < std::size(variants); ++i) {
        const Scene scene = import("variant" + std::to_string(i) + ".obj", variants[i]);
        ASSERT_EQ(scene.triangles.size(), 12u) << "variant " << i;
        for (size_t t = 0; t < 12; ++t)
            for (size_t c = 0; c < 3; ++c)
                EXPECT_EQ(cornerOf(scene, t, c).position, cornerOf(expected, t, c).position) << "variant " << i;
    }
}

TEST_F(ObjImport, NegativeIndicesCountBack) {
    const Scene scene =
        import("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf -3 -2 -1\n");
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_TRUE(isNear(filePosition(scene, 0, 1), {1, 0, 0}));
    EXPECT_TRUE(isNear(filePosition(scene, 1, 2), {0, 1, 5}));
}

TEST_F(ObjImport, SeveralObjectsAndForwardIndices) {
    const Scene scene = import("a.obj", "o one\nf 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\no two\nf 1 3 4\nv 0 0 1\n");
    EXPECT_EQ(scene.triangles.size(), 2u);
    EXPECT_EQ(scene.vertices.size(), 4u);
}

TEST_F(ObjImport, CornersWithDifferentNormalsAreDifferentVertices) {
    const Scene scene = import("a.obj",
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvn 0 0 2\nvn 0 3 0\nvt 0.25 0.25 # note\n"
                               "f 1/1/1 2//1 3/1\nf 2//2 4//1 3/1\n");
    EXPECT_EQ(scene.vertices.size(), 5u);
    EXPECT_EQ(cornerOf(scene, 0, 0).normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(cornerOf(scene, 1, 0).normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(cornerOf(scene, 0, 2).normal, glm::vec3(0.0f));
    EXPECT_EQ(cornerOf(scene, 0, 0).uv, glm::vec2(0.25f, 0.75f));
}

TEST_F(ObjImport, VertexColoursAreDecoded) {
    const Scene scene = import("a.obj", "v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 7 0 0\nv 1 1 0 2\nf 1 2 3\nf 2 4 3\n");
    EXPECT_EQ(cornerOf(scene, 0, 0).colour, glm::vec4(1.0f));
    EXPECT_EQ(cornerOf(scene, 0, 1).colour.r, 1.0f);
    EXPECT_NEAR(cornerOf(scene, 0, 1).colour.g, 0.214f, 1e-3f);  // of sRGB's 0.5
    EXPECT_EQ(cornerOf(scene, 0, 1).colour.b, 0.0f);
    EXPECT_EQ(cornerOf(scene, 0, 2).colour, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(cornerOf(scene, 1, 1).colour, glm::vec4(1.0f));
    EXPECT_EQ(scene.warnings.count("vertex colours brought into [0, 1]"), 1u);
    EXPECT_EQ(scene.warnings.entries().at("vertex weights ignored").examples, std::vector<std::string>{"line 4"});
}

TEST_F(ObjImport, ConcavePolygonKeepsItsAreaAndWinding) {
    // An arrow head that a fan from the first corner would overlap.
    const Scene scene =
        import("a.obj", "v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 2 3 4 1\nf 4 1 2 3\nf 1 2 3 4\nf 3 4 1 2\n");
    EXPECT_EQ(scene.triangles.size(), 8u);
    EXPECT_NEAR(totalArea(scene), 4 * 6.0, 1e-5);
    for (size_t t = 0; t < 8; ++t) EXPECT_GT(frontOf(scene, t).z, 0.0);
}

TEST_F(ObjImport, PolygonOfManyCornersIsWhole) {
    std::string comb;  // 300 teeth: far from convex, more corners than fit a byte
    std::string face = "f";
    for (int i = 0; i < 300; ++i) comb += fmt::format("v {} 0 0\nv {} 5 0\n", 2 * i, 2 * i + 1);
    for (int i = 0; i < 600; ++i) face += fmt::format(" {}", i + 1);
    comb += "v 599 -1 0\nv 0 -1 0\n" + face + " 601 602\n";
    const Scene scene = import("comb.obj", comb);
    EXPECT_EQ(scene.triangles.size(), 600u);
    EXPECT_EQ(scene.warnings.count("polygons split by guess: self-intersecting or very large"), 0u);
    double shoelace = 0.5 * 599 * 5 + 599;  // 299.5 teeth of base 2 and height 5, on a bar of height 1
    EXPECT_NEAR(totalArea(scene), shoelace, 1e-3);
}

TEST_F(ObjImport, FaultsAreCountedWithTheirLine) {
    const Scene scene = import("a.obj",
                               "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nv 1,5 2 3\n"  // lines 1 to 5
                               "f 1 2 3\nf 0 1 2\nf 1 2 9\nf -9 1 2\nf 1 2\nf 1 a 2\n"
                               "f 1 2 4\nf 1 2 5\nf 1 1 2\nf 99999999999999999999 1 2\nf 1/7/9 2 3\nl 1 2\ncurv 1 2\n");
    EXPECT_EQ(scene.triangles.size(), 2u);
    const auto& entries = scene.warnings.entries();
    const auto& outOfRange = entries.at("faces dropped: vertex index out of range");
    EXPECT_EQ(outOfRange.count, 4u);
    EXPECT_EQ(outOfRange.examples, (std::vector<std::string>{"line 7", "line 8", "line 9"}));
    EXPECT_EQ(entries.at("faces dropped: fewer than three corners").examples[0], "line 10");
    EXPECT_EQ(entries.at("faces dropped: malformed corner").examples[0], "line 11");
    EXPECT_EQ(entries.at("malformed vertex data: not a number").examples[0], "line 5");
    EXPECT_EQ(entries.at("triangles dropped: vertex not finite or beyond 1e150").examples[0], "line 12");
    EXPECT_EQ(entries.at("triangles dropped: vertex not finite or beyond 1e150").count, 2u);
    EXPECT_EQ(entries.at("triangles dropped: zero area").examples[0], "line 14");
    EXPECT_EQ(entries.at("texture coordinate indices out of range").count, 1u);
    EXPECT_EQ(entries.at("normal indices out of range").count, 1u);
    EXPECT_EQ(entries.at("line and point elements dropped").count, 1u);
    EXPECT_EQ(entries.at("statements ignored: not part of polygonal OBJ").count, 1u);
}

TEST_F(ObjImport, RefusesWhatIsNoObj) {
    EXPECT_NE(errorOf("a.obj", "{\"asset\": 1}\n").find("a.obj: no line is an OBJ statement"), std::string::npos);
    EXPECT_EQ(import("empty.obj", "").triangles.size(), 0u);
}

TEST_F(ObjImport, SurvivesEveryTruncation) {
    const std::string text = cube("mtllib colours.mtl\n") + "vt 0.5 0.5\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n";
    write("colours.mtl", kColours);
    size_t mostTriangles = 0;
    for (size_t size = 0; size <= text.size(); ++size) {
        try {
            const Scene scene = import("cut.obj", std::string_view(text).substr(0, size));
            mostTriangles = std::max(mostTriangles, scene.triangles.size());
        } catch (const Error& error) {
            EXPECT_LT(size, std::strlen("mtllib")) << error.what();  // no statement yet
        }
    }
    EXPECT_EQ(mostTriangles, 13u);
}

}  // namespace
}  // namespace manylight::testing
