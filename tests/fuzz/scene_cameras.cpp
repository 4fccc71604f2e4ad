// A Collada document of any bytes gives an Error or one that needs no more changes.

#include <string_view>

#include "import/assimp/dae_file.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

void check_scene_cameras(Bytes bytes) {
    const std::string_view file(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto dae = unless_refused([&] { return import::read_dae_text(file); });
    if (dae) {
        const import::DaeFile again = import::read_dae_text(dae->text);
        expect(again.text == dae->text, "what was made ready for Assimp is ready");
        expect(!again.has_motion, "its motion is taken out");
    }
}

}  // namespace ink::fuzz
