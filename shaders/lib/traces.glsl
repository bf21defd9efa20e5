// Every entry point that traces rays includes this before all else. It is compiled twice, see cmake/Shaders.cmake: for
// the traversal of bvh.glsl, and with MANYLIGHT_RAY_QUERY for that of the device.
#ifndef MANYLIGHT_TRACES_GLSL
#define MANYLIGHT_TRACES_GLSL
#ifdef MANYLIGHT_RAY_QUERY
#extension GL_EXT_ray_query : require
#endif

#endif
