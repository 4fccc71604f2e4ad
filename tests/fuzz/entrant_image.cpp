// Any file in the place of an entrant's image is an image of the view's size, or an Error.

#include <array>
#include <vector>

#include "entrants/image_folder.h"
#include "image_io/picture_file.h"
#include "score/polarity.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/scratch_file.h"

namespace ink::fuzz {
namespace {

constexpr std::array<std::uint8_t, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

/// The checksum of a chunk: CRC-32 as PNG and zlib have it.
std::uint32_t checksum(Bytes bytes) {
    std::uint32_t rest = 0xffffffffU;
    for (const std::uint8_t byte : bytes) {
        rest ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            rest = rest >> 1 ^ ((rest & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~rest;
}

std::uint32_t big_endian(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
           std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// The file with the checksum of each whole chunk mended: else hardly a change would get past them.
std::vector<std::uint8_t> with_checksums(Bytes bytes) {
    std::vector<std::uint8_t> file(bytes.begin(), bytes.end());
    if (file.size() < 8 || !std::equal(kPngSignature.begin(), kPngSignature.end(), file.begin()))
        return file;
    std::size_t at = 8;
    while (file.size() - at >= 12) {
        const std::size_t length = big_endian(file.data() + at);
        if (length > file.size() - at - 12) break;
        const std::uint32_t sum = checksum(Bytes(file).subspan(at + 4, length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += length + 12;
    }
    return file;
}

}  // namespace

void check_entrant_image(Bytes bytes) {
    const auto path = scratch_file("image.png", with_checksums(bytes));
    const auto picture = unless_refused([&] { return image_io::read_picture(path); });
    if (!picture) return;
    scene::View view;
    view.width_px = picture->colour.width_px();
    view.height_px = picture->colour.height_px();
    expect(view.width_px > 0 && view.height_px > 0, "an image has pixels");
    const auto read = [&] { return entrants::read_entrant_image(path, view); };
    expect_usable("an image that can be read is an entrant's", [&] {
        const edge::EdgeImage image = read();
        expect(image.width_px() == view.width_px && image.height_px() == view.height_px,
               "the image has the size of the view");
        expect(!score::has_dark_lines(image), "lines are light on dark");
    });
    ++view.width_px;
    expect(!unless_refused(read), "an image of another size is refused");
}

}  // namespace ink::fuzz
