// The colours of the courtyard: linear Rec.709 reflectances between 0.05 and 0.8.
#include "engine/scene/generate/courtyard_parts.h"

namespace manylight::courtyard {

namespace {

template <size_t N>
std::array<uint32_t, N> addShades(Mesh& mesh, const std::string& name, const std::array<glm::dvec3, N>& albedos) {
    std::array<uint32_t, N> indices{};
    for (size_t i = 0; i < N; ++i) indices[i] = addMaterial(mesh, name + "_" + std::to_string(i + 1), albedos[i]);
    return indices;
}

}  // namespace

Palette addPalette(Mesh& mesh) {
    Palette palette{};
    palette.marble = addMaterial(mesh, "marble", {0.78, 0.75, 0.70});
    palette.sandstone = addMaterial(mesh, "sandstone", {0.66, 0.55, 0.40});
    palette.cream = addMaterial(mesh, "cream", {0.76, 0.68, 0.54});
    palette.voussoirRed = addMaterial(mesh, "voussoir_red", {0.55, 0.20, 0.13});
    palette.voussoirPale = addMaterial(mesh, "voussoir_pale", {0.78, 0.70, 0.56});
    palette.plaster = addMaterial(mesh, "plaster", {0.76, 0.66, 0.50});
    palette.wood = addMaterial(mesh, "wood", {0.42, 0.26, 0.14});
    palette.darkWood = addMaterial(mesh, "dark_wood", {0.24, 0.14, 0.08});
    palette.iron = addMaterial(mesh, "iron", {0.20, 0.19, 0.18});
    palette.water = addMaterial(mesh, "water", {0.20, 0.45, 0.50});
    palette.roofTile = addMaterial(mesh, "roof_tile", {0.58, 0.27, 0.17});
    palette.trunk = addMaterial(mesh, "trunk", {0.30, 0.21, 0.14});
    palette.fruit = addMaterial(mesh, "fruit", {0.80, 0.38, 0.06});
    palette.rope = addMaterial(mesh, "rope", {0.35, 0.28, 0.18});
    palette.flower = addMaterial(mesh, "flower", {0.75, 0.16, 0.32});
    palette.paving = addShades<4>(mesh, "paving",
                                  {{{0.62, 0.55, 0.45}, {0.55, 0.49, 0.41}, {0.68, 0.60, 0.48}, {0.50, 0.46, 0.42}}});
    palette.galleryTile = addShades<4>(
        mesh, "gallery_tile", {{{0.56, 0.30, 0.19}, {0.62, 0.36, 0.23}, {0.50, 0.27, 0.18}, {0.60, 0.42, 0.28}}});
    palette.pottery = addShades<4>(mesh, "pottery",
                                   {{{0.62, 0.31, 0.18}, {0.68, 0.40, 0.25}, {0.15, 0.38, 0.48}, {0.70, 0.58, 0.36}}});
    palette.paint = addShades<5>(
        mesh, "paint",
        {{{0.12, 0.36, 0.42}, {0.62, 0.22, 0.14}, {0.70, 0.48, 0.16}, {0.16, 0.24, 0.50}, {0.26, 0.42, 0.22}}});
    palette.cloth = addShades<5>(
        mesh, "cloth",
        {{{0.68, 0.12, 0.10}, {0.78, 0.52, 0.10}, {0.10, 0.30, 0.55}, {0.45, 0.12, 0.38}, {0.12, 0.46, 0.36}}});
    palette.leaf =
        addShades<4>(mesh, "leaf", {{{0.16, 0.34, 0.08}, {0.24, 0.44, 0.10}, {0.12, 0.28, 0.09}, {0.34, 0.48, 0.14}}});
    return palette;
}

}  // namespace manylight::courtyard
