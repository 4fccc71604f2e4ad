#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/experiment_plan.h"

namespace ink::experiment {

/// How far a run came.
enum class RunState {
    unfinished,  ///< blocks are missing: it was interrupted or killed, or is at work
    finished,
    invalid,  ///< all is there, but what must hold does not: see RunRecord::faults
};

/// "unfinished", "finished", "invalid": as run.toml has it.
[[nodiscard]] std::string_view name(RunState state);

/// What a run folder says of itself in run.toml: what was asked, and which build and machine
/// answered. Enough to write its tables from finished blocks without the plan.
struct RunRecord : RunHead {
    int blocks = 0;  ///< of the whole run
    int cells = 0;

    RunState state = RunState::unfinished;
    int blocks_done = 0;
    double work_s = 0;  ///< that the finished blocks took; 0 if times are left out
    std::vector<std::string> missing_blocks = {};  ///< keys of the blocks that are not done
    std::vector<std::string> faults = {};          ///< why the run is invalid
    /// What came of it, in a line, where its tables do not say it; "" elsewhere.
    std::string finding = {};
};

/// The record of a run of `plan` that has not begun.
[[nodiscard]] RunRecord record_of(const Plan& plan);

/// The record in `folder`/run.toml; nothing if there is no such file. Throws core::Error (where =
/// the file) for one that is no record of a run.
[[nodiscard]] std::optional<RunRecord> read_record(const std::filesystem::path& folder);

/// Writes `folder`/run.toml whole. Throws core::Error if it cannot be written.
void write_record(const RunRecord& record, const std::filesystem::path& folder);

/// Throws core::Error (where = the folder) unless `there`, the record of its results, is of the
/// same run as `mine`; says what differs.
void refuse_other_run(const std::filesystem::path& folder,
                      const RunRecord& there,
                      const RunRecord& mine);

}  // namespace ink::experiment
