// Any file with the magic word of MDL, MD2 or MD3 gives a sound scene or an Error.

#include "import/quake_models.h"

#include <string_view>

#include "tests/fuzz/fuzz.h"
#include "tests/import/quake_files.h"

namespace ink::fuzz {
namespace {

using import::Md3File;
using import::ModelBytes;

ModelBytes model_bytes(Bytes bytes) {
    const auto all = std::as_bytes(bytes);
    return {"", {all.begin(), all.end()}};
}

Md3File part(const char* name, const std::string& text) {
    return {name, model_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()})};
}

template <class Read>
void check_reader(Read read) {
    const auto reply = unless_refused(read);
    if (!reply) return;
    expect(!reply->meshes.empty() || !reply->animation, "motion is of something");
    expect_scene_or_error(*reply);
}

/// Alone, and as each part of a player that carries another.
void check_md3(Bytes bytes) {
    const Md3File lower = part("lower", import::md3_file(3, "tag_torso"));
    const Md3File upper = part("upper", import::md3_file(2, "tag_head"));
    const Md3File head = part("head", import::md3_file(1, "tag_none"));
    check_reader([&] { return import::read_md3({{"alone", model_bytes(bytes)}}); });
    check_reader([&] { return import::read_md3({{"lower", model_bytes(bytes)}, upper, head}); });
    check_reader([&] { return import::read_md3({lower, {"upper", model_bytes(bytes)}, head}); });
}

}  // namespace

void check_quake_models(Bytes bytes) {
    const std::string_view magic(reinterpret_cast<const char*>(bytes.data()),
                                 std::min<std::size_t>(bytes.size(), 4));
    if (magic == "IDPO")
        check_reader([&] { return import::read_mdl(model_bytes(bytes), "model"); });
    if (magic == "IDP2")
        check_reader([&] { return import::read_md2(model_bytes(bytes), "model"); });
    if (magic == "IDP3") check_md3(bytes);
}

}  // namespace ink::fuzz
