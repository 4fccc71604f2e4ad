// Any FBX file, text or binary, gives a sound scene or an Error.

#include <string_view>

#include "import/fbx/fbx_reader.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

void check_fbx(Bytes bytes) {
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto reply = unless_refused([&] { return import::read_fbx_bytes(file, {}); });
    if (!reply) return;
    for (const import::ImportedMesh& mesh : reply->meshes)
        expect(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size(),
               "a vertex has a normal if another has one");
    expect(!reply->animation, "it stands still");
    expect_scene_or_error(*reply);
}

}  // namespace ink::fuzz
