#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "truth/crossings/crossings.h"

namespace ink::truth {

/// What touches on one image.
struct SeenContacts {
    Crossings all;                         ///< contacts and coplanar pairs; no segments
    std::vector<std::uint8_t> is_touched;  ///< per edge 1 if it has a contact
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_digits;  ///< pairs of faces, sorted

    /// Whether two faces, the lower first, touch by their digits, so that their crossing is none.
    [[nodiscard]] bool is_contact(std::uint32_t face0, std::uint32_t face1) const;
};

/// The contacts of a scene, and with them those by digits (written_contacts.h) that `is_unseen`
/// says an image cannot tell from a contact. Nothing if there are none of these.
[[nodiscard]] std::optional<SeenContacts> find_seen_contacts(
    const Crossings& crossings,
    std::size_t edge_count,
    const std::function<bool(const WrittenContact&)>& is_unseen);

}  // namespace ink::truth
