// Any file, and any text of a model part, gives a sound scene or an Error to the reader of 3MF.

#include "import/three_mf.h"

#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/scratch_file.h"

namespace ink::fuzz {

void check_three_mf(Bytes bytes) {
    const auto path = scratch_file("a.3mf", bytes);
    if (const auto reply = unless_refused([&] { return import::read_3mf(path); }))
        expect_scene_or_error(*reply);
    // Every part that it names is itself once more.
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto reply = unless_refused(
        [&] { return import::read_3mf_model([&](const std::string&) { return text; }, "model"); });
    if (!reply) return;
    std::size_t positions = 0;
    for (const import::ImportedMesh& mesh : reply->meshes)
        positions = std::max(positions, mesh.positions.size());
    expect(positions <= bytes.size(), "a vertex takes a byte of the file at least");
    expect_scene_or_error(*reply);
}

}  // namespace ink::fuzz
