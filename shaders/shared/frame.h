// What every pass of a frame may need to know: one uniform buffer.
#ifndef MANYLIGHT_SHARED_FRAME_H
#define MANYLIGHT_SHARED_FRAME_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// All positions and lengths in the scene's normalised frame.
struct FrameConstants {
    mat4 clipFromWorld;
    vec3 cameraPosition;
    uint seed;
    vec3 cameraRight;  // times the half width of the image plane at distance 1
    uint frame;
    vec3 cameraDown;   // times the half height
    uint emitterCount;
    vec3 cameraForward;
    uint deltaLightCount;  // the first entries of the emitter table: point, spot and directional lights
    uvec2 imageSize;
    vec2 pixelOffset;      // of the sample inside its pixel, in [0, 1); (0.5, 0.5) is the centre
    vec3 sceneCenter;
    float sceneRadius;     // of a sphere around the scene
    vec3 environmentRadiance;  // where there is no map of it
    float geometryBound;   // upper bound of the geometry term, 1 / length^2
    uint pathCount;        // light paths of this frame
    uint vplCount;         // VPLs shaded in this frame
    uint lightSampleCount; // points sampled on area lights and directions of the environment
    uint triangleCount;
    uint bounceCount;      // surfaces a light path may meet
    // A path tracer chooses an emitter with probability emitterPowerShare * its power + emitterEqualShare.
    float emitterPowerShare;
    float emitterEqualShare;
    float environmentProbability;  // that it chooses the environment
    // The same for the choice among area lights and the environment alone.
    float areaPowerShare;
    float areaEqualShare;
    float areaEnvironmentProbability;
    uvec2 environmentSize;  // of the map, texels
    uint environmentCellSide;
    float environmentTurn;
    float pixelShare;  // of a pixel's area, that textures are averaged over
};

MANYLIGHT_SHARED_END
#endif
