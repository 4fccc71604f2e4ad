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

/// How messages call the option of a row: "--axes" of "--axes,--axis".
[[nodiscard]] std::string flag_of(const std::string& row);

/// The rows that say what a truth is.
[[nodiscard]] const std::vector<std::string>& truth_rows();

}  // namespace ink::cli
