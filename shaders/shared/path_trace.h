#ifndef MANYLIGHT_SHARED_PATH_TRACE_H
#define MANYLIGHT_SHARED_PATH_TRACE_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

// A path from the camera on its way; 80 bytes. Stored only between dispatches.
struct PathState {
    vec3 origin;       // on the surface, not yet offset
    uint isAlive;      // 0 once the path left the scene, was absorbed or came to its end
    vec3 direction;    // unit
    float density;     // of `direction`, 1/sr; of no meaning before the first surface
    vec3 throughput;   // product of albedo / survival probability
    uint scatterings;  // surfaces met so far
    vec3 normal;       // geometric normal at the origin; zero at the camera
    uint unused;
    vec3 radiance;     // what the path has brought so far
    uint unused2;
};

// lavapipe ends every loop silently after 65,535 iterations of an invocation: a longer path takes several dispatches.
MANYLIGHT_CONSTANT(uint, kSurfacesPerDispatch, 64u);
// Such paths are traced band by band, so that their states fit a small buffer.
MANYLIGHT_CONSTANT(uint, kPathStatesPerBand, 1u << 18);

struct PathTracePush {
    uint firstRow;  // of the band
    uint endRow;
    uint minScatterings;  // light that was scattered as often as this to that is counted; 0 is emission, 1 direct light
    uint maxScatterings;
    uint russianRoulette;
    uint jitter;  // a new place in the pixel for every pixel and frame; otherwise the centre
};

MANYLIGHT_SHARED_END
#endif
