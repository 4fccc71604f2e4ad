// Any file in the place of an entrant's image is an image of the view's size, or an Error; any text
// in the place of its times.csv is read, or an Error.

#include <zlib.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "core/tables/csv_table.h"
#include "entrants/entrant.h"
#include "harness/images/outline_image.h"
#include "image_io/image_file.h"
#include "tests/core/temp_folder.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

/// A file called `name` that holds `bytes`, in a folder of this process. It is written over by the
/// next call of that name; the folder is removed at the end.
std::filesystem::path scratch_file(const std::string& name, Bytes bytes) {
    static const core::TempFolder folder;
    const std::filesystem::path path = folder / name;
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    if (!file.flush()) throw std::runtime_error("no room for a file");
    return path;
}

constexpr std::array<std::uint8_t, 8> kPngSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

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
        const uLong sum = crc32_z(0, file.data() + at + 4, length + 4);
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        at += length + 12;
    }
    return file;
}

void check_table(const std::string& text) {
    const auto table = unless_refused([&] { return core::split_csv(text, "times.csv"); });
    if (!table) return;
    expect(table->lines.size() == table->records.size(), "each record has a line");
    for (std::size_t i = 0; i < table->records.size(); ++i) {
        expect(table->records[i].size() == table->columns.size(), "each record has every column");
        expect(i == 0 || table->lines[i] > table->lines[i - 1], "lines go on");
    }
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
        expect(!harness::has_dark_lines(image), "lines are light on dark");
    });
    ++view.width_px;
    expect(!unless_refused(read), "an image of another size is refused");
}

void check_entrant_times(Bytes bytes) {
    check_table({bytes.begin(), bytes.end()});
    const auto path = scratch_file("times.csv", bytes);
    (void)unless_refused([&] { return entrants::image_folder_source(path.parent_path()); });
}

}  // namespace ink::fuzz
