// A program of somebody else's: reads a scene with the installed library.
#include "engine/core/error.h"
#include "engine/scene/import.h"

#include <cstdio>
#include <fstream>

int main() {
    try {
        std::ofstream("square.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        const manylight::Scene scene = manylight::importScene("square.obj");
        std::printf("manylight %s: %zu triangles\n", PACKAGE_VERSION, scene.triangles.size());
        return 0;
    } catch (const manylight::Error& error) {
        std::fprintf(stderr, "consumer: %s\n", error.what());
        return error.exitCode();
    }
}
