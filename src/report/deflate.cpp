#include "report/deflate.h"

#include <zlib.h>

namespace ink::report {

std::vector<std::uint8_t> deflated(std::span<const std::byte> bytes) {
    uLongf size = compressBound(bytes.size());
    std::vector<std::uint8_t> packed(size);
    compress(packed.data(),
             &size,
             reinterpret_cast<const Bytef*>(bytes.data()),  // NOLINT
             bytes.size());
    packed.resize(size);
    return packed;
}

}  // namespace ink::report
