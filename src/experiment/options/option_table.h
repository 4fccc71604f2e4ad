#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/param.h"
#include "experiment/experiment.h"
#include "harness/suite/suite.h"

namespace ink::experiment {

/// An option of an experiment beside its row: where it is given.
struct Option {
    std::string flag;      ///< on the command line, "--crease"; "" if only files have it
    std::string noun;      ///< of a list with choices: what one of them is, "axis"; else ""
    unsigned kinds = 0;    ///< whose files have it: a bit for each ExperimentKind; 0: no file
    bool is_once = false;  ///< a list of which a command takes one text
};

/// Where a row stands in a file and in what run.toml records.
struct OptionPlace {
    std::string table;  ///< "measure"; "" is the top
    std::string key;    ///< "times"
};
[[nodiscard]] OptionPlace place_of(const core::Param& param);

/// The field to which these pointers to members lead, one inside the other, for a row.
template <auto... kPath>
inline constexpr auto kField = [](auto& whole) -> auto& {
    return (whole.*....*kPath);
};

/// All options of an experiment. A row's name is its table and key in a file ("measure.times"), and
/// its place in what run.toml records as asked; its sentence is the help of the command line. A
/// list with choices holds names of these alone. Rows are set in their order: what a row of views
/// means may depend on those before it.
struct OptionTable {
    core::ParamTable<Experiment> rows;
    std::vector<Option> options;  ///< one for each row

    /// Says where the row is given that is then added to what is returned.
    core::ParamTable<Experiment>& in(unsigned kinds, std::string flag = "", std::string noun = "") {
        options.push_back({std::move(flag), std::move(noun), kinds});
        return rows;
    }

    /// The row of that name. Throws std::out_of_range if there is none: the caller's mistake.
    [[nodiscard]] std::size_t row(std::string_view name) const;
    [[nodiscard]] const core::Param& param(std::size_t row) const { return rows.params()[row]; }
    /// What an experiment has of a row, as texts: none for a number out of its range, such as 0 for
    /// no limit.
    [[nodiscard]] std::vector<std::string> texts(const Experiment& experiment,
                                                 std::size_t row) const;
    [[nodiscard]] bool has_kind(std::size_t row, ExperimentKind kind) const {
        return (options[row].kinds >> static_cast<unsigned>(kind) & 1U) != 0;
    }
};

[[nodiscard]] const OptionTable& option_table();

/// Puts what was given in place of an option's value. Throws core::Error (where = the first text's)
/// for a kind of experiment that does not have it, and for texts that mean nothing.
void set_option(Experiment& experiment,
                std::string_view name,
                const std::vector<core::GivenText>& given);

/// A bit of Option::kinds.
constexpr unsigned bit(ExperimentKind kind) {
    return 1U << static_cast<unsigned>(kind);
}

/// Runs `read`; an error of it names `where` as the place.
template <class Read>
auto at_place(const std::string& where, Read read) {
    try {
        return read();
    } catch (const core::Error& error) {
        throw core::Error(where, error.what_happened(), error.accepted());
    }
}

/// Adds the rows that say which views are meant, and how they look, to the table of all options.
///
/// Commands have --views and --eye with what belongs to it, files `orbit`, `directions`,
/// `file_cameras` and `cameras`, a list of tables: rows of these are of one of the two alone.
void add_view_rows(OptionTable& table);

/// The rows of views as commands have them, in the order of help: --size, --views, --projection,
/// --parallel, --fit, --margin, --object, --eye, --target, --up, --fov, --time, --frame,
/// --animation, --seams.
[[nodiscard]] const std::vector<std::string>& view_rows();

/// Checks what was asked of views against each other, when all of it is there, and completes it: a
/// height of parallel views goes to cameras that are set by hand. Throws core::Error (where = the
/// option).
void settle_views(harness::ViewRequest& request);

/// What is up: an axis by its name, or a direction, "X,Y,Z". Throws core::Error (where = the
/// text's).
[[nodiscard]] glm::dvec3 parse_direction(const core::GivenText& given);

/// A direction, and the text that says so. Throws core::Error (where = the text's) if its length is
/// 0.
[[nodiscard]] glm::dvec3 checked_direction(const glm::dvec3& direction,
                                           const core::GivenText& given);

/// "X,Y,Z". Throws core::Error (where = the text's) for text that is no point.
[[nodiscard]] glm::dvec3 parse_point(const core::GivenText& given);

/// The models of a list: a TOML file whose [[model]] tables have `file` and `kind`, and
/// `split = "train"` where settings may be found on the model.
///
/// Tables of [[package]] may hold models too, as those of experiments/models.toml do. Other keys
/// are skipped: they say how a model is got. Throws core::Error (where = file and line) for a file
/// that cannot be read, one without models, a model without file or kind, another split, and a file
/// that is listed twice.
[[nodiscard]] std::vector<harness::ListedModel> read_model_list(const std::filesystem::path& path);

}  // namespace ink::experiment
