// Extensions and the frame's constants: every entry point includes this first.
#ifndef MANYLIGHT_PRELUDE_GLSL
#define MANYLIGHT_PRELUDE_GLSL
#extension GL_EXT_scalar_block_layout : require
#include "shaders/shared/bindings.h"
#include "shaders/shared/constants.h"
#include "shaders/shared/frame.h"

layout(set = 0, binding = kBindingFrame, scalar) uniform FrameBlock { FrameConstants frame; };

#endif
