#pragma once

#include "image_io/exr_file.h"
#include "image_io/image_file.h"
#include "image_io/picture_file.h"

namespace ink::image_io {

/// The functions of this room, which need OpenImageIO, as the module `inkbench_images` hands them
/// out: programs load it when the first image is read or written, because that library and the 260
/// that it needs take a quarter of a second.
struct ImageFunctions {
    GrayFile (*read_gray_file)(const std::filesystem::path&);
    core::Image<std::uint8_t> (*read_gray)(const std::filesystem::path&);
    Picture (*read_picture)(const std::filesystem::path&);
    ExrFile (*read_exr)(const std::filesystem::path&);
    void (*write_exr)(const ExrFile&, const std::filesystem::path&);
    void (*write_gray)(const core::Image<std::uint8_t>&,
                       const std::filesystem::path&,
                       const Texts&);
    void (*write_rgb)(const core::Image<Rgb>&, const std::filesystem::path&, const Texts&);
    std::vector<std::uint8_t> (*encode_gray)(const core::Image<std::uint8_t>&);
    std::vector<std::uint8_t> (*encode_rgb)(const core::Image<Rgb>&);
};

/// How the module's one function is called; it takes nothing and returns `const ImageFunctions*`.
inline constexpr const char* kImageFunctions = "inkbench_images";

}  // namespace ink::image_io
