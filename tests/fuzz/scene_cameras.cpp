// What is looked for in Collada and FBX files of any bytes stands in them.

#include <string_view>

#include "import/assimp/dae_cameras.h"
#include "import/assimp/fbx.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

void check_scene_cameras(Bytes bytes) {
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto is_in_file = [&](const std::string& name) { return file.find(name) != file.npos; };
    for (const import::DaeCamera& camera : import::read_dae_cameras(file))
        expect(is_in_file(camera.node), "a node's name is in the Collada file");
    for (const auto& [name, width] : import::read_fbx_parallel_cameras(file))
        expect(is_in_file(name), "a node's name is in the FBX file");
}

}  // namespace ink::fuzz
