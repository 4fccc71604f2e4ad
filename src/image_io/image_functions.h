#pragma once

#include "image_io/exr_file.h"
#include "image_io/image_file.h"

namespace ink::image_io {

/// The functions of this room, which need OpenImageIO, as the module `inkbench_images` hands them
/// out: programs load it when the first image is read or written, because that library and the 260
/// that it needs take a quarter of a second.
struct ImageFunctions {
    GrayFile (*read_gray_file)(const std::filesystem::path&);
    Picture (*read_picture)(const std::filesystem::path&);
    ExrFile (*read_exr)(const std::filesystem::path&);
    void (*write_exr)(const ExrFile&, const std::filesystem::path&);
    std::vector<std::uint8_t> (*encode_png)(const PngPixels&, const Texts&, const std::string&);
};

/// How the module's one function is called; it takes nothing and returns `const ImageFunctions*`.
inline constexpr const char* kImageFunctions = "inkbench_images";

}  // namespace ink::image_io
