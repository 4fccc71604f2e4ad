#include "import/meshes/mesh_files.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"
#include "import/refusal.h"

namespace ink::import {
namespace {

bool is_ply(std::string_view file) {
    return file.starts_with("ply\n") || file.starts_with("ply\r") || file.starts_with("ply ");
}

/// Files in the folder of `model`, whatever folders a name in the model speaks of.
FilesBeside beside(const std::filesystem::path& model) {
    return [folder = model.parent_path()](const std::string& name) {
        const auto file = folder / std::filesystem::path(name).filename();
        std::error_code error;
        // A pipe would keep us waiting.
        if (!std::filesystem::is_regular_file(file, error)) return std::string();
        const std::vector<std::byte> bytes = bytes_of(file);
        return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
}

using Reader = ImportReply (*)(std::string_view, const std::string&);

constexpr Reader read_obj_alone = read_obj;

/// Who reads a file that begins with `head`; nobody here if none does.
Reader reader_of(std::string_view head, const std::string& extension) {
    const std::string_view text = without_mark(head);
    if (is_ply(text) || extension == ".ply") return read_ply;
    if (is_off(text) || extension == ".off") return read_off;
    if (extension == ".stl" || is_stl_text(text)) return read_stl;
    return extension == ".obj" ? read_obj_alone : nullptr;
}

}  // namespace

std::optional<ImportReply> read_mesh_file(const std::filesystem::path& path) {
    const std::string head = head_of(path);
    const Reader reader = reader_of(head, lower_case(path.extension().string()));
    if (reader == nullptr) return std::nullopt;
    const std::vector<std::byte> bytes = bytes_of(path);
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string name = path.stem().string();
    if (reader == read_stl && is_binary_stl(file)) return reader(file, name);
    if (is_utf16(file)) throw Refusal("", "is UTF-16 text, which is not read", "UTF-8");
    if (reader == read_obj_alone && head.find('\0') != head.npos) {
        ImportReply reply;
        reply.status = ImportStatus::wrong_content;
        return reply;
    }
    if (reader == read_obj_alone) return read_obj(without_mark(file), name, beside(path));
    return reader(without_mark(file), name);
}

}  // namespace ink::import
