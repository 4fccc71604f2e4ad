#include "import/file_length.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

/// A format that writes its whole length at a fixed place behind a magic word, little endian.
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

}  // namespace

void check_length(const std::filesystem::path& path) {
    const std::string head = head_of(path);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    for (const LengthField& field : kLengthFields) {
        std::uint32_t promised = 0;
        if (!head.starts_with(field.magic) || head.size() < field.offset + sizeof promised)
            continue;
        std::memcpy(&promised, head.data() + field.offset, sizeof promised);
        if (error || promised <= size) return;
        throw core::Error("",
                          "the file is cut short: its header promises " + std::to_string(promised) +
                              " bytes, it has " + std::to_string(size),
                          "a whole, valid model file");
    }
}

}  // namespace ink::import
