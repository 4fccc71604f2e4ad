#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"
#include "score/score.h"

namespace ink::tune {

/// What one evaluation found.
struct TuneValue {
    double value = 0;  ///< what the search lowers: the error, and more beyond a time budget
    double error = 0;  ///< what the objective makes of the counts
    std::optional<double> draw_ms = {};  ///< where a time budget asked for it
    bool is_by_planes = false;  ///< else the method itself drew; no part of the log's lines
    std::vector<score::CurveCount> by_view = {};  ///< of each training view
};

/// The finished evaluations of a search, on disk as soon as they are known.
///
/// A setting may be there twice, drawn from planes and by its method, under a key of its own each.
/// Lines are flushed one by one. A search that was killed and is started again with the same key
/// finds them, and since it asks for the same settings in the same order it comes to the point
/// where it stopped without drawing anything. Numbers are written so that they read back the same.
class TuneLog {
  public:
    /// Opens `path`. Lines of another key are thrown away, as is a last line without an end. Throws
    /// core::Error (where = the path) if it cannot be written.
    TuneLog(std::filesystem::path path, const std::string& key);

    /// How many evaluations were found there.
    [[nodiscard]] std::size_t found() const { return found_; }

    /// What was found for these settings ("a=1;b=2").
    [[nodiscard]] std::optional<TuneValue> find(const std::string& settings) const;
    void add(const std::string& settings, const TuneValue& value);
    /// Takes the file away: the search is finished.
    void remove();

  private:
    void read(const std::string& key);

    std::filesystem::path path_;
    std::ofstream stream_;
    std::map<std::string, TuneValue> values_;
    std::size_t found_ = 0;
};

/// One evaluation, in the order in which a search asked for them.
struct TuneStep {
    std::string phase;  ///< start | global | local | random
    core::ParamValues settings;
    TuneValue found;
};

}  // namespace ink::tune
