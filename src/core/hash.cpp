#include "core/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace ink::core {

Hasher& Hasher::bytes(const void* data, std::size_t size) {
    state_ = XXH3_64bits_withSeed(data, size, state_);
    return *this;
}

std::string Hasher::hex() const {
    return fmt::format("{:016x}", state_);
}

}  // namespace ink::core
