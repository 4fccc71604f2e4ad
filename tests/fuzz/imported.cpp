// What must hold of any reply of a reader of models, and of any bytes in the place of one.

#include <vector>

#include "import/imported_scene.h"
#include "scene/animation.h"
#include "tests/fuzz/fuzz.h"
#include "tests/import/imported_meshes.h"

namespace ink::fuzz {
namespace {

constexpr std::uint64_t kMostTriangles = 1 << 20;

void check_poses(scene::Scene scene) {
    const double end_s = scene.animation->duration_s;
    for (const double time_s : {0.0, 0.3 * end_s, end_s, 2 * end_s}) {
        scene::pose_scene(scene, time_s);
        scene::check_scene(scene);
    }
    scene::rest_scene(scene);
    scene::check_scene(scene);
}

}  // namespace

void expect_scene_or_error(const import::ImportReply& reply) {
    const std::vector<std::byte> stream = import::stream_of(reply);
    auto read = import::read_reply(stream);
    expect(read.has_value(), "a reply that was written can be read");
    // A mesh without triangles loses its material: the second stream is what stays.
    const std::vector<std::byte> second = import::stream_of(*read);
    const auto read_again = import::read_reply(second);
    expect(read_again.has_value() && import::stream_of(*read_again) == second,
           "a reply goes through a stream unchanged");
    const auto scene = unless_refused(
        [&] { return import::scene_from_reply(std::move(*read), "model.x", kMostTriangles); });
    if (!scene) return;
    expect_usable("a scene that was taken is sound", [&] {
        scene::check_scene(*scene);
        if (scene->animation) check_poses(*scene);
    });
}

void check_scene_stream(Bytes bytes) {
    const auto reply = import::read_reply(std::as_bytes(bytes));
    if (reply) expect_scene_or_error(*reply);
}

}  // namespace ink::fuzz
