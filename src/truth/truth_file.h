#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "truth/truth.h"

namespace ink::truth {

/// A truth as bytes, sealed with its key (core/kept_file.h).
[[nodiscard]] std::string encode_truth(const Truth& truth, const std::string& key);

/// The truth that `encode_truth` wrote under the same key; nothing if the bytes are no such thing,
/// or images differ in size. Never throws for what is in the bytes, and allocates no more than
/// images of 2^27 px take.
[[nodiscard]] std::optional<Truth> decode_truth(std::string_view bytes, const std::string& key);

}  // namespace ink::truth
