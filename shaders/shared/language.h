// Lets one header speak to both languages. Structs use the scalar block layout, which is glm's own packing.
#ifdef __cplusplus
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#define MANYLIGHT_SHARED_BEGIN namespace manylight::shared { using uint = uint32_t; using glm::mat4; using glm::uvec2; using glm::uvec4; using glm::vec2; using glm::vec3; using glm::vec4;
#define MANYLIGHT_SHARED_END }
#define MANYLIGHT_CONSTANT(type, name, value) inline constexpr type name = value
#define MANYLIGHT_FUNCTION inline
#define MANYLIGHT_PRECISE
#else
#define MANYLIGHT_SHARED_BEGIN
#define MANYLIGHT_SHARED_END
#define MANYLIGHT_CONSTANT(type, name, value) const type name = value
#define MANYLIGHT_FUNCTION
#define MANYLIGHT_PRECISE precise
#endif
