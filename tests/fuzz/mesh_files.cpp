// Any file gives a sound scene or an Error to the readers of OBJ, OFF, PLY and STL.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/meshes/mesh_readers.h"
#include "tests/fuzz/fuzz.h"
#include "tests/import/imported_meshes.h"

namespace ink::fuzz {
namespace {

using MeshReader = import::ImportReply (*)(std::string_view, const std::string&);

/// The reply as a stream; nothing for an Error.
std::optional<std::vector<std::byte>> read_all(MeshReader read, std::string_view file) {
    const auto reply = unless_refused([&] { return read(file, "model"); });
    if (!reply) return std::nullopt;
    std::size_t positions = 0;
    for (const import::ImportedMesh& mesh : reply->meshes) {
        positions += mesh.positions.size();
        expect(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(),
               "a vertex has a normal if another has one");
    }
    expect(positions <= file.size(), "a vertex takes a byte of the file at least");
    expect_scene_or_error(*reply);
    return import::stream_of(*reply);
}

/// No more is taken from a file than it holds, and of a text the same whether its lines end with LF
/// or with CR LF.
void check_mesh_reader(MeshReader read, Bytes bytes) {
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto reply = read_all(read, file);
    if (file.find_first_of(std::string_view("\r\0", 2)) != file.npos) return;  // no plain text
    std::string with_cr;
    for (const char c : file)
        with_cr += c == '\n' ? "\r\n" : std::string(1, c);
    if (file.find("format binary") == file.npos)
        expect(read_all(read, with_cr) == reply, "lines may end either way");
}

}  // namespace

void check_obj(Bytes bytes) {
    check_mesh_reader(import::read_obj, bytes);
}

void check_off(Bytes bytes) {
    check_mesh_reader(import::read_off, bytes);
}

void check_ply(Bytes bytes) {
    check_mesh_reader(import::read_ply, bytes);
}

void check_stl(Bytes bytes) {
    check_mesh_reader(import::read_stl, bytes);
}

}  // namespace ink::fuzz
