// Gathering on a coarse grid, refined where it would not do.
#ifndef MANYLIGHT_GATHER_GRID_GLSL
#define MANYLIGHT_GATHER_GRID_GLSL
#include "shaders/lib/reconstruct.glsl"

const float kAlikeEnough = 0.5;  // of sameSurface(): to take a neighbour's light for one's own

// Pixels of the grid gather, every gridStep-th from gridStart on; and those that see what no pixel of the grid within half
// a step sees. The others are filled in by reconstruct_block.comp, whose box reaches as far.
bool gathersItself(ivec2 pixel, int gridStep, ivec2 gridStart) {
    if (!isInPicture(pixel)) return false;
    const ivec2 before = (pixel - gridStart + gridStep) % gridStep;
    if (before == ivec2(0)) return true;
    const Guide center = guideAt(pixel);
    if (!center.takesPart) return true;
    const float footprint = footprintAt(center.position);
    float best = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 offset = ivec2((i & 1) == 0 ? 0 : gridStep, (i & 2) == 0 ? 0 : gridStep) - before;
        const bool isNear = all(lessThanEqual(2 * abs(offset), ivec2(gridStep)));
        if (isNear && isInPicture(pixel + offset))
            best = max(best, sameSurface(center, guideAt(pixel + offset), footprint, offset));
    }
    return best < kAlikeEnough;
}

#endif
