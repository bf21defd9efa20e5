// The meshes that the scene generators build: polygons of three or four corners in double precision.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace manylight {

inline constexpr uint32_t kNoIndex = 0xffffffffu;

/// A Lambertian reflector, linear Rec.709; `emittedRadiance` in W / (sr m^2) from the front side.
struct MeshMaterial {
    std::string name;
    glm::dvec3 albedo{0.5};
    glm::dvec3 emittedRadiance{0.0};
};

/// A planar, convex polygon, counter-clockwise seen from the front.
struct MeshFace {
    std::array<uint32_t, 4> position{kNoIndex, kNoIndex, kNoIndex, kNoIndex};  // the last one is absent in a triangle
    std::array<uint32_t, 4> normal{kNoIndex, kNoIndex, kNoIndex, kNoIndex};    // all absent in a flat face
    uint32_t material = 0;

    uint32_t cornerCount() const { return position[3] == kNoIndex ? 3 : 4; }
};

/// A named run of faces, up to the next object. A closed one is the boundary of a solid, its faces turned outwards.
struct MeshObject {
    std::string name;
    size_t firstFace = 0;
    bool closed = true;
};

struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<MeshFace> faces;
    std::vector<MeshObject> objects;
    std::vector<MeshMaterial> materials;
};

/// Where a part stands: a rotation about the vertical axis, then a translation.
struct Placement {
    glm::dvec3 origin{0.0};
    double cosYaw = 1.0;
    double sinYaw = 0.0;

    glm::dvec3 direction(const glm::dvec3& local) const {
        return {cosYaw * local.x + sinYaw * local.z, local.y, cosYaw * local.z - sinYaw * local.x};
    }
    glm::dvec3 point(const glm::dvec3& local) const { return origin + direction(local); }
    /// The same orientation, moved to a point given in this frame.
    Placement at(const glm::dvec3& local) const { return {point(local), cosYaw, sinYaw}; }
};

Placement turned(const glm::dvec3& origin, double yaw);

/// Opens a new object; the faces added from here on belong to it.
void beginObject(Mesh& mesh, std::string name, bool closed = true);

uint32_t addMaterial(Mesh& mesh, std::string name, const glm::dvec3& albedo,
                     const glm::dvec3& emittedRadiance = glm::dvec3(0.0));

/// Adds a vertex, rounded to 1e-5: last-bit differences between mathematical libraries vanish, and the text of an
/// OBJ holds exactly what the mesh does.
uint32_t addPosition(Mesh& mesh, const glm::dvec3& position);
uint32_t addNormal(Mesh& mesh, const glm::dvec3& normal);

void addTriangle(Mesh& mesh, uint32_t material, uint32_t a, uint32_t b, uint32_t c);
void addQuad(Mesh& mesh, uint32_t material, uint32_t a, uint32_t b, uint32_t c, uint32_t d);
void addQuad(Mesh& mesh, uint32_t material, const std::array<glm::dvec3, 4>& corners);

/// A quad counts as two triangles.
size_t triangleCount(const Mesh& mesh);

}  // namespace manylight
