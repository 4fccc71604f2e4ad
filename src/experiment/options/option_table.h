#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/param.h"
#include "experiment/experiment.h"

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

/// A seed. Throws core::Error unless it is a whole number of 64 bits.
[[nodiscard]] std::uint64_t parse_seed(const core::GivenText& given);

/// Runs `read`; an error of it names `where` as the place.
template <class Read>
auto at_place(const std::string& where, Read read) {
    try {
        return read();
    } catch (const core::Error& error) {
        throw core::Error(where, error.what_happened(), error.accepted());
    }
}

}  // namespace ink::experiment
