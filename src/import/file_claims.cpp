#include "import/file_claims.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

namespace ink::import {
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

/// What the lines of a PLY header add up to.
struct PlyHeader {
    FileClaims claims;
    bool is_binary = false;
    std::uint64_t element_count = 0;  ///< of the element being described
    std::uint64_t least_bytes = 0;    ///< of the elements alone
    std::uint64_t least_lines = 0;    ///< one each for the header's own and for every element
};

/// Adds one header line, such as "element vertex 8" or "property list uchar int vertex_indices".
void add_ply_line(const std::vector<std::string>& words, PlyHeader& header) {
    if (words.size() < 3) return;
    if (words[0] == "format") header.is_binary = words[1].starts_with("binary");
    if (words[0] == "element") {
        std::uint64_t count = 0;
        std::from_chars(words[2].data(), words[2].data() + words[2].size(), count);
        count = std::min(count, kMostCounted);
        header.element_count = count;
        header.least_lines += count;
        if (words[1] == "vertex") header.claims.vertices = count;
        if (words[1] == "face") header.claims.faces = count;
    }
    if (words[0] == "property") {
        const bool is_list = words[1] == "list";  // of which only the length is sure to be there
        header.least_bytes += header.element_count * ply_type_bytes(words[is_list ? 2 : 1]);
    }
}

FileClaims ply_claims(Bytes head) {
    std::istringstream lines{std::string(as_text(head))};
    PlyHeader header;
    std::string line;
    while (std::getline(lines, line)) {
        ++header.least_lines;
        std::istringstream stream(line);
        const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
        if (!words.empty() && words[0] == "end_header") {
            if (header.is_binary) header.claims.bytes = header.least_bytes;
            if (!header.is_binary) header.claims.lines = header.least_lines;
            return header.claims;
        }
        add_ply_line(words, header);
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

}  // namespace ink::import
