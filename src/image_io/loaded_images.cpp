// The functions of this room for programs, from the module `inkbench_images`.

#include <dlfcn.h>

#include <new>

#include "core/error.h"
#include "core/program_folder.h"
#include "image_io/image_functions.h"

namespace ink::image_io {
namespace {

namespace fs = std::filesystem;

/// The module lies beside the program in the build, and in a folder of libraries once installed.
const ImageFunctions& load() {
    std::error_code ignored;
    const fs::path program = core::program_folder();
    fs::path module = program / INK_IMAGE_MODULE;
    if (!fs::exists(module, ignored)) module = program / INK_IMAGE_MODULE_INSTALLED;
    void* const handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
    void* const found = handle == nullptr ? nullptr : dlsym(handle, kImageFunctions);
    if (found == nullptr) {
        const char* const said = dlerror();
        const std::string reason = said == nullptr ? "" : said;
        // The loader's words for memory that is too short.
        for (const char* sign : {"failed to map", "annot allocate", "annot create"})
            if (reason.find(sign) != std::string::npos) throw std::bad_alloc();
        throw core::Error(module.lexically_normal().string(),
                          "images need this module, and it cannot be loaded: " + reason,
                          "the file that is built and installed with this program");
    }
    return *reinterpret_cast<const ImageFunctions* (*)()>(found)();
}

const ImageFunctions& loaded() {
    static const ImageFunctions& functions = load();
    return functions;
}

}  // namespace

GrayFile read_gray_file(const fs::path& path) {
    return loaded().read_gray_file(path);
}

Picture read_picture(const fs::path& path) {
    return loaded().read_picture(path);
}

ExrFile read_exr(const fs::path& path) {
    return loaded().read_exr(path);
}

void write_exr(const ExrFile& file, const fs::path& path) {
    loaded().write_exr(file, path);
}

std::vector<std::uint8_t> encode_png(const PngPixels& image,
                                     const Texts& texts,
                                     const std::string& where) {
    return loaded().encode_png(image, texts, where);
}

}  // namespace ink::image_io
