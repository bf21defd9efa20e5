// libFuzzer's entry points for the reader MANYLIGHT_FUZZ_READER.
#include "tests/fuzz/glb_mutator.h"
#include "tests/fuzz/readers.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t mostBytes, unsigned int seed);
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t mostBytes);

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    manylight::fuzz::readAndCheck(MANYLIGHT_FUZZ_READER, {reinterpret_cast<const char*>(data), size});
    return 0;
}

#ifdef MANYLIGHT_FUZZ_GLB
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t mostBytes, unsigned int seed) {
    return manylight::fuzz::mutateGlb(data, size, mostBytes, seed, LLVMFuzzerMutate);
}
#endif
