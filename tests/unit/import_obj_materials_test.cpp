#include "tests/unit/import_test_support.h"

namespace manylight::testing {
namespace {

/// A scene of one triangle whose material the test writes.
class ObjMaterials : public SceneFiles {
  protected:
    Scene withMaterial(std::string_view statements) const {
        write("a.mtl", fmt::format("newmtl m\n{}\n", statements));
        return import("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.75\nusemtl m\nf 1/1 2/1 3/1\n");
    }
    Material material(std::string_view statements) const { return withMaterial(statements).materials.at(0); }
};

TEST_F(ObjMaterials, ColoursAreReadAsMeant) {
    write("a.mtl",
          "newmtl plain\n\nnewmtl grey\n\tKd 0.25\nnewmtl bad\nKe nan 1 -2\nKd 2 -1 0.5\nnewmtl text\nKd red\n");
    const Scene scene = import("a.obj",
                               "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl plain\nf 1 2 3\nusemtl grey\nf 1 2 3\n"
                               "usemtl bad\nf 1 2 3\nusemtl text\nf 1 2 3\n");
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0.8f));
    EXPECT_EQ(scene.materials[1].albedo, glm::vec3(0.25f));
    EXPECT_EQ(scene.materials[2].albedo, glm::vec3(1.0f, 0.0f, 0.5f));
    EXPECT_EQ(scene.materials[2].emittedRadiance, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.materials[3].albedo, glm::vec3(0.0f));
    EXPECT_EQ(scene.warnings.count("material colours set to zero: not finite"), 1u);
    EXPECT_EQ(scene.warnings.entries().at("material colours set to zero: not three numbers").examples[0],
              "a.mtl line 9");
    EXPECT_EQ(scene.warnings.count("albedos clamped to [0, 1]"), 1u);
    EXPECT_EQ(scene.warnings.count("emission channels set to zero: negative, not finite or too large"), 1u);
}

TEST_F(ObjMaterials, HighlightsBecomeSpecularReflectance) {
    const Material glossy = material("Kd 0.5 0.5 0.5\nKs 0.5 0.25 0\nNs 30\nillum 2");
    EXPECT_EQ(glossy.specular, glm::vec3(0.04f, 0.02f, 0.0f));
    EXPECT_FLOAT_EQ(glossy.roughness, 0.5f);  // alpha = sqrt(2 / 32) = 1/4
    EXPECT_EQ(glossy.metallic, 0.0f);
    EXPECT_EQ(material("Ks 1 1 1").specular, glm::vec3(0.08f));  // no illum, no Ns
    EXPECT_EQ(material("Ks 1 1 1").roughness, 1.0f);
    EXPECT_EQ(material("Ks 1 1 1\nNs 500\nillum 1").specular, glm::vec3(0.0f));
    EXPECT_EQ(material("Ks 0 0 0\nNs 500\nillum 2").roughness, 1.0f);
    EXPECT_EQ(material("Kd 1 1 1").specular, glm::vec3(0.0f));
    EXPECT_EQ(withMaterial("Ks 3 0 0").warnings.count("highlights clamped to [0, 1]"), 1u);
    EXPECT_EQ(withMaterial("Ks 3 0 0").materials[0].specular, glm::vec3(0.08f, 0, 0));
    EXPECT_EQ(withMaterial("Ks 1 1 1\nNs -4").warnings.count("material numbers ignored: negative or no finite number"),
              1u);
}

TEST_F(ObjMaterials, BlackWithAHighlightIsMetal) {
    write("rg.tga", redGreenTga());
    const Material metal = material("Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 30\nmap_Kd rg.tga");
    EXPECT_EQ(metal.metallic, 1.0f);
    EXPECT_EQ(metal.albedo, glm::vec3(0.9f, 0.6f, 0.3f));
    EXPECT_FALSE(metal.albedoTexture.exists());
    EXPECT_FLOAT_EQ(metal.roughness, 0.5f);
    EXPECT_EQ(material("Kd 0 0 0\nKs 0.2 0.2 0.2\nillum 3").metallic, 1.0f);
    const Material blackPlastic = material("Kd 0 0 0\nKs 0.5 0.5 0.5\nillum 2");
    EXPECT_EQ(blackPlastic.metallic, 0.0f);
    EXPECT_EQ(blackPlastic.specular, glm::vec3(0.04f));
    EXPECT_EQ(material("Kd 0 0 0\nKs 1 1 1\nillum 1").metallic, 0.0f);
}

TEST_F(ObjMaterials, PbrExtensionComesFirst) {
    const Material metal = material("Kd 0.5 0.5 0.5\nKs 0 0 0\nNs 1000\nPr 0.25\nPm 1");
    EXPECT_EQ(metal.metallic, 1.0f);
    EXPECT_EQ(metal.roughness, 0.25f);
    EXPECT_EQ(metal.specular, glm::vec3(0.0f));
    const Material rough = material("Pr 0.75");
    EXPECT_EQ(rough.metallic, 0.0f);
    EXPECT_EQ(rough.specular, glm::vec3(0.04f));
    const Scene outside = withMaterial("Pr 7\nPm 1e999\nPc 0.5\nmap_Pr a.png");
    EXPECT_EQ(outside.materials[0].roughness, 1.0f);
    EXPECT_EQ(outside.warnings.count("material values brought into [0, 1]"), 1u);
    EXPECT_EQ(outside.warnings.count("material numbers ignored: negative or no finite number"), 1u);
    EXPECT_EQ(outside.warnings.count("sheen, clearcoat and anisotropy left out"), 1u);
    EXPECT_EQ(outside.warnings.count("textures left out: only map_Kd, map_Ke, map_d, norm and bump are read"), 1u);
}

TEST_F(ObjMaterials, DissolveAndItsOpposite) {
    EXPECT_EQ(material("d 1\nTr 1").alphaMode, AlphaMode::Opaque);
    EXPECT_EQ(material("d 0.25").alphaMode, AlphaMode::Blend);
    EXPECT_EQ(material("d 0.25").opacity, 0.25f);
    EXPECT_EQ(material("Tr 0.25").opacity, 0.75f);
    EXPECT_EQ(material("Tr 1\nd 1").opacity, 1.0f);
    EXPECT_EQ(material("Tr 7").opacity, 0.0f);
    EXPECT_EQ(withMaterial("d 7").materials[0].opacity, 1.0f);
    EXPECT_EQ(withMaterial("d 7").warnings.count("material values brought into [0, 1]"), 1u);
    EXPECT_EQ(withMaterial("d -halo 0.5").materials[0].opacity, 0.5f);
    EXPECT_EQ(withMaterial("d x").warnings.count("material numbers ignored: negative or no finite number"), 1u);
    EXPECT_EQ(withMaterial("illum 7\nd 0.5").warnings.count("refraction left out"), 1u);
}

TEST_F(ObjMaterials, EmissionMaps) {
    write("rg.tga", redGreenTga());
    const Material lamp = material("Ke 5 5 5\nmap_Ke rg.tga");
    EXPECT_EQ(lamp.emittedRadiance, glm::vec3(5.0f));
    EXPECT_EQ(lamp.emissionTexture.texture, 0);
    EXPECT_EQ(material("map_Ke rg.tga").emittedRadiance, glm::vec3(1.0f));
    EXPECT_FALSE(material("Ke 0 0 0\nmap_Ke rg.tga").emissionTexture.exists());
    EXPECT_EQ(material("Ke 5 5 5\nmap_Ke gone.png").emittedRadiance, glm::vec3(5.0f));
}

TEST_F(ObjMaterials, StatementsThatAreNoneAreCounted) {
    write("a.mtl", "Kd 1 0 0\nnewmtl m\nkd 0 1 0\nfoo 3\nKa 1 1 1\nNi 1.5\nnewmtl m\nKd 0 0 1\nmap_Kd \n");
    const Scene scene = import("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0, 1, 0));
    EXPECT_EQ(scene.warnings.count("material statements before any newmtl ignored"), 1u);
    EXPECT_EQ(scene.warnings.count("material statements of unknown meaning ignored"), 1u);
    EXPECT_EQ(scene.warnings.count("materials defined twice: the first is used"), 1u);
    EXPECT_EQ(scene.warnings.count("textures left out: no file name"), 1u);
}

}  // namespace
}  // namespace manylight::testing
