#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "experiment/experiment.h"

namespace ink::cli {

/// What a command lets its user ask of an experiment: rows of experiment::option_table().
class ExperimentOptions {
  public:
    /// `usual` is what the command does unless told otherwise; help shows its values.
    explicit ExperimentOptions(experiment::Experiment usual = {}) : usual_(std::move(usual)) {}

    /// Adds the options of these rows ("measure.crease_deg") to a command; `doc`, if there is one,
    /// in place of the row's. The object must stay where it is.
    void add_to(CLI::App& command,
                const std::vector<std::string>& rows,
                const std::string& doc = "");

    /// The usual experiment with what was given in its place. Throws core::Error (where = the
    /// option) for text that means nothing.
    [[nodiscard]] experiment::Experiment read() const;

    /// What was given of a row; nothing, too, of one that was not added.
    [[nodiscard]] const std::vector<std::string>& given(const std::string& row) const;
    [[nodiscard]] bool is_given(const std::string& row) const { return !given(row).empty(); }
    /// Whether views were asked for, of which scenes have their own.
    [[nodiscard]] bool has_views() const {
        return is_given("views.views") || is_given("views.eye");
    }

    /// What is done unless something else is given.
    [[nodiscard]] experiment::Experiment& usual() { return usual_; }

  private:
    experiment::Experiment usual_;
    std::map<std::size_t, std::vector<std::string>> given_;  ///< by row, in the table's order
};

/// The rows that say what a truth is.
[[nodiscard]] const std::vector<std::string>& truth_rows();

/// Adds --methods (or --method), which may be given again, to a command; `usual` says in words
/// what it takes when there are none. `method_list` or `one_method` reads the texts.
void add_method_options(CLI::App& command,
                        std::vector<std::string>& texts,
                        const std::string& usual = "all");

/// The same for a command that takes one method, `usual` if none is named; `one_method` reads it.
void add_one_method_option(CLI::App& command,
                           std::vector<std::string>& texts,
                           const std::string& usual,
                           const std::string& doc = "Method (see inkbench list methods)");

/// The registered methods that comma lists and globs mean, as one list a,b; "" for no texts.
///
/// Throws core::Error (where = "--methods") that lists the methods for an unknown name, a glob that
/// no method fits, and a list that names nothing.
[[nodiscard]] std::string method_list(const std::vector<std::string>& texts);

/// The one method that the texts mean, `usual` for no texts. Throws core::Error (where = `option`)
/// unless it is one.
[[nodiscard]] std::string one_method(const std::vector<std::string>& texts,
                                     const std::string& usual,
                                     const std::string& option = "--method");

/// Adds --set, which may be given again; `doc` says what is set.
void add_set_option(CLI::App& command,
                    std::vector<std::string>& settings,
                    const std::string& doc = "A parameter: key=value or method.key=value");

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
