// The loaders that the system has as libraries, compiled here from their headers: the sanitizers and the fuzzer's
// search then see into them.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
