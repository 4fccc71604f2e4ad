#include "scene/file_claims.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <sstream>
#include <string_view>

namespace ink::scene {
namespace {

using Bytes = std::span<const std::byte>;

// A claim above this is a lie in any case; capping it keeps the products below from overflowing.
constexpr std::uint64_t kMostCounted = 1ULL << 40;

std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::optional<std::uint32_t> u32_at(Bytes bytes, std::size_t offset) {
    if (bytes.size() < offset + 4) return std::nullopt;
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, 4);  // all these formats are little endian
    return value;
}

/// A format that writes its whole length at a fixed place behind a magic word.
struct LengthField {
    std::string_view magic;
    std::size_t offset;
};
constexpr std::array kLengthFields{
    LengthField{"MM", 2},      // 3DS: length of the main chunk
    LengthField{"glTF", 8},    // glTF 2.0 binary, 5.1 "Header"
    LengthField{"IDP2", 64},   // MD2: ofs_end
    LengthField{"IDP3", 104},  // MD3: ofs_eof
};

FileClaims stl_claims(Bytes head, Bytes tail, std::uint64_t size) {
    constexpr std::size_t kStlHeaderBytes = 84;
    constexpr std::uint64_t kStlTriangleBytes = 50;
    const auto count = u32_at(head, kStlHeaderBytes - 4);
    const std::string_view start = as_text(head);
    const bool has_zero_byte =
        start.substr(0, kStlHeaderBytes).find('\0') != std::string_view::npos;
    const bool says_solid = start.starts_with("solid");
    FileClaims claims;
    const std::uint64_t binary_bytes = kStlHeaderBytes + kStlTriangleBytes * count.value_or(0);
    // Some writers of binary files begin with "solid" too: then the size, or a zero byte, tells.
    if (!says_solid || has_zero_byte || (count && size == binary_bytes)) {
        claims.bytes = binary_bytes;
        claims.faces = count;
    } else {
        claims.ends_early = as_text(tail).find("endsolid") == std::string_view::npos &&
                            as_text(tail).find("ENDSOLID") == std::string_view::npos;
    }
    return claims;
}

std::uint64_t ply_type_bytes(std::string_view type) {
    if (type.ends_with("8") || type == "char" || type == "uchar") return 1;
    if (type.ends_with("16") || type == "short" || type == "ushort") return 2;
    if (type == "double" || type == "float64") return 8;
    return 4;
}

/// Reads "element vertex 8" and its kin up to "end_header".
FileClaims ply_claims(Bytes head) {
    std::istringstream lines{std::string(as_text(head))};
    FileClaims claims;
    std::string line;
    std::uint64_t count = 0;
    std::uint64_t least_bytes = 0;
    bool is_binary = false;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string keyword;
        std::string first;
        std::string second;
        words >> keyword >> first >> second;
        if (keyword == "end_header") {
            if (is_binary) claims.bytes = least_bytes;  // and the header, but nobody needs that
            return claims;
        }
        if (keyword == "format") is_binary = first.starts_with("binary");
        if (keyword == "element") {
            count = 0;
            std::from_chars(second.data(), second.data() + second.size(), count);
            count = std::min(count, kMostCounted);
            if (first == "vertex") claims.vertices = count;
            if (first == "face") claims.faces = count;
        }
        // Of a list only its length is sure to be there.
        if (keyword == "property")
            least_bytes += count * ply_type_bytes(first == "list" ? second : first);
    }
    return {};  // no end of the header in sight: let the reader complain
}

/// The next word of an OFF file's header, comments skipped.
std::string off_word(std::istringstream& words) {
    std::string word;
    while (words >> word && word.starts_with('#'))
        std::getline(words, word);
    return word;
}

FileClaims off_claims(Bytes head) {
    std::istringstream words{std::string(as_text(head))};
    if (!off_word(words).ends_with("OFF")) return {};
    std::array<std::uint64_t, 2> counts{};
    for (std::uint64_t& count : counts) {
        const std::string word = off_word(words);
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
        if (error != std::errc{} || end != word.data() + word.size()) return {};
    }
    return {.vertices = counts[0], .faces = counts[1]};
}

}  // namespace

FileClaims read_claims(std::span<const std::byte> head,
                       std::span<const std::byte> tail,
                       std::uint64_t size,
                       const std::string& extension) {
    const std::string_view start = as_text(head);
    if (extension == ".stl") return stl_claims(head, tail, size);
    if (start.starts_with("ply")) return ply_claims(head);
    if (extension == ".off") return off_claims(head);
    for (const LengthField& field : kLengthFields) {
        if (start.starts_with(field.magic)) return {.bytes = u32_at(head, field.offset)};
    }
    return {};
}

}  // namespace ink::scene
