// What must hold of any reply of a reader of models.

#include <vector>

#include "core/error.h"
#include "import/imported_scene.h"
#include "import/scene_stream.h"
#include "scene/animation.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

constexpr std::uint64_t kMostTriangles = 1 << 20;

std::vector<std::byte> stream_of(const import::ImportReply& reply) {
    std::vector<std::byte> stream;
    const auto append = [&](const void* data, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(data);
        stream.insert(stream.end(), bytes, bytes + size);
    };
    import::write_reply(reply, append);
    return stream;
}

void check_poses(scene::Scene scene) {
    const double end_s = scene.animation->duration_s;
    for (const double time_s : {0.0, 0.3 * end_s, end_s, 2 * end_s}) {
        for (const auto between : {scene::Between::blended, scene::Between::whole}) {
            scene::pose_scene(scene, time_s, between);
            scene::check_scene(scene);
        }
    }
    scene::rest_scene(scene);
    scene::check_scene(scene);
}

}  // namespace

void expect_scene_or_error(const import::ImportReply& reply) {
    const std::vector<std::byte> stream = stream_of(reply);
    auto read = import::read_reply(stream);
    expect(read.has_value(), "a reply that was written can be read");
    // A mesh without triangles loses its material: the second stream is what stays.
    const std::vector<std::byte> second = stream_of(*read);
    const auto read_again = import::read_reply(second);
    expect(read_again.has_value() && stream_of(*read_again) == second,
           "a reply goes through a stream unchanged");
    scene::Scene scene;
    try {
        scene = import::scene_from_reply(std::move(*read), "model.x", kMostTriangles);
    } catch (const core::Error& error) {
        expect_clear(error);
        return;
    }
    try {
        scene::check_scene(scene);
        if (scene.animation) check_poses(scene);
    } catch (const core::Error& error) {
        throw BrokenLaw(std::string("a scene that was taken is sound: ") + error.what());
    }
}

}  // namespace ink::fuzz
