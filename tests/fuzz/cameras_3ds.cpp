// Cameras and lights of any .3ds file can be used: cameras have an angle, and keys are in order.

#include "import/stage_3ds.h"

#include <numbers>

#include "import/chunks_3ds.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/import/imported_meshes.h"

namespace ink::fuzz {
namespace {

void check_keys(const std::vector<scene::VectorKey>& keys) {
    for (std::size_t k = 0; k < keys.size(); ++k) {
        expect(keys[k].time_s >= 0, "times are 0 or more");
        expect(k == 0 || keys[k - 1].time_s <= keys[k].time_s, "keys are in order of time");
    }
}

/// As the reader of models has it: the scene of a file that Assimp has read already.
import::ImportReply reply_with_cameras(Bytes bytes){
    import::ImportReply reply = import::cube_reply();
scene::Animation motion;
motion.duration_s = 1;
motion.node_of_instance = {scene::kNoNode};
motion.nodes.push_back({scene::kNoNode, glm::dmat4(2), {}, {}, {}});
const std::filesystem::path file = scratch_file("cameras.3ds", bytes);
reply.cameras = import::read_3ds_cameras(file, motion);
reply.lights = import::read_3ds_lights(file, motion, reply.notes);
reply.animation = std::move(motion);
return reply;
}  // namespace

}  // namespace ink::fuzz

void check_cameras_3ds(Bytes bytes) {
    const auto cameras = import::read_3ds_cameras(std::as_bytes(bytes));
    for (const import::ImportedCamera& camera : cameras) {
        expect(camera.fov_y_rad > 0 && camera.fov_y_rad < std::numbers::pi,
               "an angle lies between 0 and 180 degrees");
    }
    std::size_t keys = 0;
    for (const import::Track3ds& track : import::tracks_of(std::as_bytes(bytes))) {
        check_keys(track.places);
        check_keys(track.colors);
        keys += track.places.size() + track.colors.size();
    }
    const auto lights = import::read_3ds_lights(std::as_bytes(bytes));
    expect(18 * keys + 32 * cameras.size() + 12 * lights.size() <= bytes.size(),
           "what is read stands in the file");
    if (!cameras.empty() || !lights.empty()) expect_scene_or_error(reply_with_cameras(bytes));
}

}  // namespace ink::fuzz
