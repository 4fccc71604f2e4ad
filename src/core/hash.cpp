#include "core/hash.h"

#include <fmt/format.h>

namespace ink::core {

void Hasher::step(std::uint64_t word) {
    std::uint64_t h = state_ ^ word;
    h ^= h >> 33;
    h *= 0xff51afd7ed558ccdULL;
    h ^= h >> 33;
    h *= 0xc4ceb9fe1a85ec53ULL;
    h ^= h >> 33;
    state_ = h;
}

Hasher& Hasher::bytes(const void* data, std::size_t size) {
    const auto* p = static_cast<const unsigned char*>(data);
    std::uint64_t word = 0;
    for (; size >= 8; size -= 8, p += 8) {
        std::memcpy(&word, p, 8);
        step(word);
    }
    if (size > 0) {
        word = 0;
        std::memcpy(&word, p, size);
        step(word ^ (static_cast<std::uint64_t>(size) << 56));
    }
    return *this;
}

std::string Hasher::hex() const {
    return fmt::format("{:016x}", state_);
}

}  // namespace ink::core
