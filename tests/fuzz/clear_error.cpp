#include <cctype>

#include "core/error.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

void expect_clear(const core::Error& error) {
    const std::string line = error.what();
    expect(!error.what_happened().empty(), "an Error says what happened");
    for (const char c : line)
        expect(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f, "an Error is one line");
}

}  // namespace ink::fuzz
