#include "core/hash.h"

#include <fmt/format.h>

#include <array>
#include <cassert>

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

void Hasher::bytes_beside(std::span<Hasher> hashers,
                          std::span<const void* const> data,
                          std::size_t size) {
    assert(hashers.size() == data.size());
    const std::size_t whole = size / 8 * 8;
    std::size_t first = 0;
    for (; first + kBeside <= hashers.size(); first += kBeside) {
        std::array<Hasher, kBeside> own;
        std::array<const unsigned char*, kBeside> from{};
        for (std::size_t i = 0; i < kBeside; ++i) {
            own[i] = hashers[first + i];
            from[i] = static_cast<const unsigned char*>(data[first + i]);
        }
        for (std::size_t at = 0; at < whole; at += 8) {
            for (std::size_t i = 0; i < kBeside; ++i) {
                std::uint64_t word = 0;
                std::memcpy(&word, from[i] + at, 8);
                own[i].step(word);
            }
        }
        for (std::size_t i = 0; i < kBeside; ++i)
            hashers[first + i] = own[i].bytes(from[i] + whole, size - whole);
    }
    for (; first < hashers.size(); ++first)
        hashers[first].bytes(data[first], size);
}

std::string Hasher::hex() const {
    return fmt::format("{:016x}", state_);
}

}  // namespace ink::core
