#include "import/rest_alone.h"

#include <algorithm>

#include "core/error.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

const std::string kAtRest = "its animation, as it is read at rest alone";

}  // namespace

void note_rest_alone(const ModelChoice& choice, std::vector<std::string>& notes) {
    if (!choice.animation.empty()) {
        throw Refusal("",
                      "animation \"" + choice.animation + "\": the file is read at rest alone",
                      kMotionByGltf);
    }
    notes.push_back(kAtRest + " (for motion: " + kMotionByGltf + ')');
}

bool is_at_rest_alone(const scene::FileFacts& file) {
    return std::ranges::any_of(file.notes,
                               [](const std::string& note) { return note.starts_with(kAtRest); });
}

void check_motion_is_read(const scene::Scene& scene, const std::string& option) {
    if (!is_at_rest_alone(scene.file)) return;
    throw core::Error(
        option, "the file of " + scene.name + " is read at rest alone", kMotionByGltf);
}

}  // namespace ink::import
