// Claims are numbers of the header alone.

#include "import/file_claims.h"

#include <array>
#include <string_view>

#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

using import::FileClaims;

bool is_same(const FileClaims& a, const FileClaims& b) {
    return a.bytes == b.bytes && a.vertices == b.vertices && a.faces == b.faces &&
           a.lines == b.lines;
}

void check_stl(const FileClaims& claims) {
    expect(claims.bytes.has_value() == claims.faces.has_value() || !claims.faces,
           "a binary STL that counts its faces claims their bytes");
    if (claims.faces) expect(*claims.bytes == 84 + 50 * *claims.faces, "50 bytes a face");
    expect(!(claims.ends_early && claims.bytes), "an STL is a text or it is not");
}

}  // namespace

void check_file_claims(Bytes bytes) {
    Feed feed(bytes);
    constexpr std::array kExtensions{".stl", ".ply", ".off", ".3ds", ".glb", ".md2", ".obj", ""};
    const std::string extension =
        kExtensions[static_cast<std::size_t>(feed.whole(0, kExtensions.size() - 1))];
    const std::size_t tail_bytes = feed.raw<std::uint8_t>();
    const auto head = std::as_bytes(feed.rest());
    const auto tail = head.last(std::min(tail_bytes, head.size()));
    const FileClaims claims = import::read_claims(head, tail, head.size(), extension);
    expect(is_same(claims, import::read_claims(head, tail, head.size(), extension)),
           "the same header claims the same");
    if (extension == ".stl") return check_stl(claims);
    expect(is_same(claims, import::read_claims(head, {}, head.size() + 1, extension)),
           "only of an STL do size and tail matter");
    expect(!claims.ends_early, "only an STL ends early");
    expect(!(claims.bytes && claims.lines), "a PLY is a text or it is not");
    if (claims.lines) {
        expect(*claims.lines >= claims.vertices.value_or(0), "a vertex has a line of a text");
        expect(*claims.lines >= claims.faces.value_or(0), "a face has a line of a text");
    }
}

}  // namespace ink::fuzz
