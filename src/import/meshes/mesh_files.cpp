#include "import/meshes/mesh_files.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"
#include "import/refusal.h"

namespace ink::import {
namespace {

bool is_ply(std::string_view file) {
    return file.starts_with("ply\n") || file.starts_with("ply\r") || file.starts_with("ply ");
}

using Reader = ImportReply (*)(std::string_view, const std::string&);

/// Who reads a file that begins with `head`; nobody here if none does.
Reader reader_of(std::string_view head, const std::string& extension) {
    const std::string_view text = without_mark(head);
    if (is_ply(text) || extension == ".ply") return read_ply;
    if (is_off(text) || extension == ".off") return read_off;
    if (extension == ".stl" || is_stl_text(text)) return read_stl;
    return extension == ".obj" ? read_obj : nullptr;
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
    if (reader == read_obj && head.find('\0') != head.npos) {
        ImportReply reply;
        reply.status = ImportStatus::wrong_content;
        return reply;
    }
    return reader(without_mark(file), name);
}

}  // namespace ink::import
