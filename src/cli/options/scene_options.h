#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ink::cli {

/// Which scenes a command means, as text until `scene_names` or `one_scene` reads them.
struct SceneOptions {
    std::vector<std::string> listed;  ///< by --scenes, which may be given again
    std::vector<std::string> named;   ///< by themselves

    [[nodiscard]] bool is_empty() const { return listed.empty() && named.empty(); }
};

/// Adds --scenes (or --scene) and scenes by themselves to a command; `doc` says what they are to it
/// and what it takes when there are none.
void add_scene_options(CLI::App& command, SceneOptions& options, const std::string& doc);

/// The same for a command that takes one scene; `one_scene` reads it.
void add_one_scene_options(CLI::App& command, SceneOptions& options);

/// The scenes and model files that the options mean, those of --scenes first; none if there are no
/// options.
///
/// A text is a comma list of built-in scenes, model files, `train`, `heldout`, `catalogue` and
/// globs; the name of a file that is there is taken as it stands. A glob means built-in scenes or,
/// where none fits, files. What several globs and groups name is there once. Throws core::Error
/// (where = the option) that lists the scenes for a word that is neither scene nor file, a glob
/// that nothing fits, and a list that names nothing.
[[nodiscard]] std::vector<std::string> scene_names(const SceneOptions& options);

/// The one scene that the options mean. Throws core::Error (where = `command`) unless it is one.
[[nodiscard]] std::string one_scene(const SceneOptions& options, const std::string& command);

/// What is made of these scenes is called: after up to three of them, "spot_temple", else
/// `otherwise`. It can be the name of a file.
[[nodiscard]] std::string name_after(const std::vector<std::string>& scenes,
                                     const std::string& otherwise);

/// The words that may stand in a list of scenes: those built in, then the groups of them.
[[nodiscard]] std::vector<std::string> scene_words();

}  // namespace ink::cli
