#pragma once

#include <cstddef>
#include <cstdint>

namespace ink::raster {

/// The low bits of `count` codes, a multiple of 16, at addresses aligned for vectors.
void narrow(const std::uint32_t* codes, std::size_t count, std::uint8_t* to);
void narrow(const std::uint32_t* codes, std::size_t count, std::uint16_t* to);

}  // namespace ink::raster
