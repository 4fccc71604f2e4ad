// What libFuzzer calls, for one target: INK_FUZZ_TARGET is the name of its function.

#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ink::fuzz::INK_FUZZ_TARGET({data, size});
    return 0;
}
