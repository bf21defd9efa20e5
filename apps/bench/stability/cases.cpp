#include "apps/bench/stability/families.h"

namespace manylight {

using namespace stability;

const std::vector<StabilityCase>& stabilityCases() {
    constexpr bool kQuick = true;
    constexpr bool kSlow = false;
    static const std::vector<StabilityCase> cases = {
        {1, "furnace", "closed room, most light is reflected light", kQuick, furnace},
        {1, "furnace-stiff", "albedo 0.99 and 0.999: a thousand bounces matter", kSlow, furnaceStiff},
        {2, "integrating-sphere", "every bounce adds half of the one before", kQuick, integratingSphere},
        {3, "single-path", "G is constant in a sphere: one light path must give the whole", kQuick, singlePath},
        {4, "form-factors", "weak singularity at a shared edge; reciprocity (6)", kQuick, formFactors},
        {5, "polygon-lights", "light from beside the horizon", kQuick, polygonLights},
        {7, "energy-balance", "every depth has its share of the flux", kQuick, energyBalance},
        {8, "unit-power-of-two", "lengths from 2^-60 to 2^60", kSlow, powerOfTwoUnits},
        {9, "unit-power-of-ten", "lengths from 1e-9 to 1e12, which round", kSlow, powerOfTenUnits},
        {10, "far-from-origin", "coordinates of 1e3 to 1e8 sizes", kQuick, farFromOrigin},
        {11, "far-apart", "two rooms, far apart for their size", kSlow, farApart},
        {12, "light-power-of-two", "light from 2^-100 to 2^100", kSlow, brightAndDim},
        {13, "unequal-lights", "a light 1e10 times as strong where it is not seen", kQuick, unequalLights},
        {14, "range-of-float", "light beside the ends of the range of float", kQuick, rangeOfFloat},
        {15, "faulty-emitters", "no area, no light, NaN, negative", kQuick, faultyEmitters},
        {16, "nothing-to-see", "no light, no geometry, nothing in view", kSlow, nothingToSee},
        {16, "camera-in-wall", "the camera on a wall, in a corner, in a solid", kQuick, cameraInWall},
        {17, "faulty-normals", "normals of no length, NaN, infinite, denormal", kQuick, faultyNormals},
        {18, "faulty-vertices", "NaN, infinite, collinear, repeated corners (19)", kQuick, faultyVertices},
        {19, "watertight", "rays at shared edges and vertices, slivers", kQuick, watertight},
        {19, "watertight-million", "the same, a million rays each", kSlow, watertightMillion},
        {20, "signed-zeros", "rays along axes, in planes and edges, of no length", kQuick, signedZeros},
        {21, "one-centroid", "triangles that no split tells apart; one triangle", kQuick, oneCentroid},
        {21, "one-triangle", "a BVH of one leaf", kQuick, oneTriangle},
        {21, "millions-of-triangles", "five million triangles", kSlow, millionsOfTriangles},
        {22, "vpl-on-receiver", "VPLs where the light they give is seen: 0 / 0", kQuick, vplOnReceiver},
        {23, "concave-corner", "G has no bound where walls meet", kQuick, concaveCornerQuick},
        {23, "concave-corner-full", "the same at six distances, and where walls shine", kSlow, concaveCorner},
        {23, "glancing", "light at two degrees between plates", kSlow, glancing},
        {23, "keyhole", "a lamp behind a hole", kSlow, keyhole},
        {23, "crack-between-rooms", "a slit of 1e-3", kSlow, crackBetweenRooms},
        {24, "coplanar", "a lamp in the plane of a ceiling, floors in one plane", kQuick, coplanar},
        {24, "duplicates", "every triangle twice", kQuick, duplicates},
        {25, "thin-walls", "a wall of 1e-2 to 1e-7 of the scene, and of none", kSlow, thinWalls},
        {25, "ray-offsets", "points leave surfaces by more than a hit is wrong", kQuick, rayOffsets},
        {26, "nested-boxes", "closed boxes in closed boxes", kQuick, nestedBoxes},
        {27, "faulty-albedos", "albedo 0, 1, above, NaN, (1, 0, 0)", kQuick, faultyAlbedos},
        {28, "coincident-vpls", "a hundred thousand VPLs in one point", kQuick, coincidentVpls},
        {30, "opposed-normals", "shading normals that contradict the surface", kQuick, opposedNormals},
        {31, "picture-sizes", "1x1, 1x8193, beyond the device's limit", kQuick, pictureSizes},
        {31, "vpl-counts", "0, 1, and no multiple of any group", kQuick, vplCounts},
        {31, "million-vpls", "2^20 VPLs and one more (32)", kSlow, millionVpls},
        {33, "bands-of-dispatches", "work beyond the bound on a dispatch", kSlow, bandsOfDispatches},
        {34, "repeated", "the same again, and with nothing left out (35)", kSlow, repeated},
        {36, "extreme-bounds", "bounds that cut nothing and everything", kSlow, extremeBounds},
        {37, "techniques-agree", "forward, deferred", kSlow, techniquesAgree},
        {37, "estimators-agree", "roulette, clamping, counts, path tracer", kSlow, estimatorsAgree},
        {39, "injected-nan", "a NaN where no file can put one", kSlow, injectedNan},
        {40, "untidy-obj", "CRLF, tabs, negative indices, lines cut off", kQuick, untidyObj},
    };
    return cases;
}

}  // namespace manylight
