#ifndef MANYLIGHT_SHARED_WINDOW_H
#define MANYLIGHT_SHARED_WINDOW_H
#include "shaders/shared/language.h"

MANYLIGHT_SHARED_BEGIN

struct WindowPicturePush {
    uvec2 size;       // pixels of the picture
    uvec2 otherSize;  // of what is shown beyond the divider
    uvec2 canvas;     // of the window; both pictures fill it
    float divider;    // pixels from the left; the canvas' width or more: no other picture
    vec4 tile;        // pixels that are drawn: left, top, right, bottom
};

struct WindowPanelPush {
    vec4 clip;     // pixels: left, top, right, bottom
    vec2 origin;   // of the vertices' coordinates
    vec2 scale;    // pixels per unit of them
    uvec2 canvas;  // pixels
    uvec2 atlas;   // texels
    uint firstIndex;
};

/// Dear ImGui's own layout of a vertex.
struct PanelVertex {
    vec2 position;
    vec2 uv;
    uint rgba;  // red in the lowest byte, sRGB
};

MANYLIGHT_SHARED_END
#endif
