#include "methods/shipped_files.h"

#include "methods/shipped_texts.h"

namespace ink::methods {

std::string ShippedFile::where() const {
    const std::string folder(name);
    return "methods/" + folder + "/" + folder + ".toml";
}

std::span<const ShippedFile> method_files() {
    return kMethodFiles;
}

std::span<const ShippedFile> shipped_presets() {
    return kPresetFiles;
}

}  // namespace ink::methods
