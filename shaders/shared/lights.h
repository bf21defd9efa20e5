// Light paths and what they leave behind.
#ifndef MANYLIGHT_SHARED_LIGHTS_H
#define MANYLIGHT_SHARED_LIGHTS_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// A light path on its way: where it starts next, and the flux it carries.
struct Ray {
    vec3 origin;     // on the surface, not yet offset
    uint isAlive;    // 0 once the path left the scene or was absorbed
    vec3 direction;  // unit
    uint depth;      // surfaces met so far
    vec3 intensity;  // flux of the path, W: emitted radiance * cos / pdf, then times albedo / survival probability
    float inverseRange;  // of the light that it leaves, 1 / length
    vec3 normal;     // geometric normal at the origin; zero where the path starts in free space
    float unused2;
};

// How a light's emission varies with direction.
MANYLIGHT_CONSTANT(uint, kLightSurface, 0u);      // cosine lobe about `direction`: a VPL or a point on an area light
MANYLIGHT_CONSTANT(uint, kLightPoint, 1u);        // the same everywhere
MANYLIGHT_CONSTANT(uint, kLightSpot, 2u);         // a cone about `direction`
MANYLIGHT_CONSTANT(uint, kLightDirectional, 3u);  // parallel light travelling along `direction`

// A light as the shading loops see it: a VPL, a real light, or a sample of an area light.
struct LightData {
    vec3 position;
    float intensity;   // largest channel: W/sr along `direction` (surface), W/sr (point, spot), W/m^2 (directional)
    vec3 direction;    // unit: normal of a surface, axis of a spot, travel of directional light
    uint kind;
    vec3 colour;       // intensity * colour is the spectrum; the largest channel is 1
    float cosCutoff;   // spot: dark outside
    float cosBeam;     // spot: full intensity inside
    uint depth;        // VPL: bounces since the emitter
    uint pathIndex;    // VPL: which light path left it
    float inverseRange;  // point, spot: 1 / length, 0: without limit
};

// What a VPL's surface does with light, for scenes where that depends on directions: the VPL emits
// flux * f_r(incoming, direction) per unit of projected area.
struct VplGloss {
    vec3 flux;      // W, with the correction for shading normals
    float alpha;    // alpha, f90, diffuse, f0: see bsdf.h
    vec3 incoming;  // unit, to where the path came from
    float f90;
    vec3 normal;    // unit shading normal, on that side
    float unused0;
    vec3 diffuse;
    float unused1;
    vec3 f0;
    float unused2;
};
MANYLIGHT_CONSTANT(uint, kTexelsPerGloss, 5u);

// As texels of four floats: position and intensity, direction (and kind), colour (and cosCutoff), the rest.
MANYLIGHT_CONSTANT(uint, kTexelsPerLight, 4u);

// One entry of the emitter table: a light or an emissive triangle. Nine tenths of the choice go by power.
MANYLIGHT_CONSTANT(uint, kEmitterPoint, 1u);
MANYLIGHT_CONSTANT(uint, kEmitterSpot, 2u);
MANYLIGHT_CONSTANT(uint, kEmitterDirectional, 3u);
MANYLIGHT_CONSTANT(uint, kEmitterTriangle, 4u);
MANYLIGHT_CONSTANT(uint, kEmitterEnvironment, 5u);

// Texel by texel, what belongs together.
struct Emitter {
    vec3 position;          // of the light, or corner 0 of the triangle
    uint kind;
    vec3 edge1;             // triangle: corner 1 - corner 0; spot, directional: unit direction of travel
    float probability;      // that a light path starts here
    vec3 edge2;             // triangle: corner 2 - corner 0
    float areaProbability;  // the same among triangles and the environment alone, for direct light
    vec3 emission;          // radiance (triangle, environment), W/sr (point, spot), W/m^2 (directional)
    float area;             // of the triangle
    float cosCutoff;
    float cosBeam;
    float inverseRange;     // 1 / length, 0: without limit
    float unused;
    uint triangle;          // of the BVH's order
    uint emissionTexture;   // that multiplies `emission`, see material.h
    uvec2 unused2;
};
MANYLIGHT_CONSTANT(uint, kTexelsPerEmitter, 6u);

// A slot of the two alias tables (Walker 1977): below the threshold it stands for the emitter of its own number.
struct EmitterChoice {
    float threshold;  // among all emitters
    uint alias;
    float areaThreshold;  // among triangles and the environment
    uint areaAlias;
};

// Counters that passes raise and the host reads after the frame.
struct FrameStatus {
    uint loopBudgetExceeded;    // a ray was cut off by the driver's loop limit: the picture is wrong
    uint shadingNormalsCapped;  // light-path vertices whose shading-normal correction met its bound
    uint pathsTruncated;        // light paths alive at the depth limit
    uint vplsTraced;            // vertices of all light paths
    uint vplsShaded;            // of these, in the VPL list
};

#ifdef __cplusplus
static_assert(sizeof(LightData) == 16 * kTexelsPerLight);
static_assert(sizeof(Emitter) == 16 * kTexelsPerEmitter);
static_assert(sizeof(EmitterChoice) == 16);
static_assert(sizeof(VplGloss) == 16 * kTexelsPerGloss);
#endif

MANYLIGHT_SHARED_END
#endif
