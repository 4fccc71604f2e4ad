#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "harness/clock/outside_method.h"
#include "method/method_config.h"

namespace ink::entrants {

/// The image in a file as edge responses (harness/images/outline_image.h). Throws core::Error that
/// names the file if it cannot be read or has another size than the view.
[[nodiscard]] edge::EdgeImage read_entrant_image(const std::filesystem::path& path,
                                                 const scene::View& view);

/// Images `folder/<scene>/<view>.png`, and their times from `folder/times.csv` if it is there.
/// Throws core::Error for a times.csv that cannot be read.
[[nodiscard]] harness::OutsideSource image_folder_source(const std::filesystem::path& folder);

/// A method from outside that takes part: a folder of images, or a program that draws them.
struct Entrant {
    std::string name;  ///< as rows call it
    std::filesystem::path path;
    bool is_program = false;
};

/// "NAME=PATH" as an entrant: a folder, or a file that can be executed.
///
/// Throws core::Error (where = "--entrant") for text without "=", a name that is not of letters,
/// digits, _ and -, a name of a registered method or a baseline, and a path that is neither.
[[nodiscard]] Entrant parse_entrant(const std::string& text);

/// The entrant as a method configuration.
///
/// Images of a folder are `path/<scene>/<view>.png`, of any depth, dark lines on light or light on
/// dark (harness/images/outline_image.h); `path/times.csv` (scene, view, draw_ms) says how long
/// they took. A program is called as `path view.json out.png` once a view (view_json()); its time
/// is what it prints as "draw_ms NUMBER", else the processor time of the whole call, its children's
/// too. A missing image, one of another size, and a program that fails, hangs or writes nothing is
/// an error of that view alone; it hangs after `wall_s` seconds. Parameters are `threshold` (128),
/// and for the record `entrant` (the path) and `content` (a hash of the images or the program).
[[nodiscard]] method::MethodConfig entrant_config(const Entrant& entrant, double wall_s = 60);

/// A method whose images come from what `make_source` makes, as a configuration. Its parameters are
/// `threshold` (128) and, for the record, `facts`; `origin` says in words where the images are
/// from, `summary` what the method is.
///
/// Throws core::Error (where = "--entrant") for a name that parse_entrant would refuse.
[[nodiscard]] method::MethodConfig outside_config(
    const std::string& name,
    const std::string& origin,
    const std::string& summary,
    const std::function<harness::OutsideSource()>& make_source,
    const core::ParamValues& facts = {});

}  // namespace ink::entrants
