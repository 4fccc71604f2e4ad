#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "truth/truth.h"

namespace ink::truth {

/// A truth as bytes: magic, key, length and hash of what follows, then all of it. Machine byte
/// order.
[[nodiscard]] std::vector<std::uint8_t> encode_truth(const Truth& truth, const std::string& key);

/// The truth that `encode_truth` wrote under the same key; nothing if the bytes are cut off,
/// changed, of another key or of another kind, or images differ in size. Never throws for what is
/// in the bytes, and allocates no more than images of 2^27 px take.
[[nodiscard]] std::optional<Truth> decode_truth(std::span<const std::uint8_t> bytes,
                                                const std::string& key);

}  // namespace ink::truth
