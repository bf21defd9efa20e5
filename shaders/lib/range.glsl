#ifndef MANYLIGHT_RANGE_GLSL
#define MANYLIGHT_RANGE_GLSL

// Share of a light of limited range that is left at a distance: 1 - (d / range)^4, nothing beyond (glTF2021,
// KHR_lights_punctual).
float rangeWindow(float distance, float inverseRange) {
    const float squared = (distance * inverseRange) * (distance * inverseRange);
    return clamp(1.0f - squared * squared, 0.0f, 1.0f);
}

#endif
