// The module that programs load when they need images; see image_functions.h.

#include "image_io/image_functions.h"

extern "C" __attribute__((visibility("default"))) const ink::image_io::ImageFunctions*
inkbench_images() {
    using namespace ink::image_io;
    static constexpr ImageFunctions kFunctions{.read_gray_file = read_gray_file,
                                               .read_picture = read_picture,
                                               .read_exr = read_exr,
                                               .write_exr = write_exr,
                                               .encode_png = encode_png};
    return &kFunctions;
}
