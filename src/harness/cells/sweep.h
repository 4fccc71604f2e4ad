#pragma once

#include <span>
#include <vector>

#include "harness/cells/cell.h"
#include "harness/scores/evaluations.h"
#include "method/method_config.h"

namespace ink::harness {

/// How the settings of a method's sweep are timed beside the methods themselves, which are timed as
/// `measure` says.
///
/// A front takes medians over views, one a scene: with a dozen scenes one time of a setting does,
/// with fewer two, and one where a frame is long. They are most of what a comparison times.
[[nodiscard]] MeasureOptions sweep_measure(MeasureOptions measure, std::size_t scenes);

/// The settings over which `config` is swept, each as a configuration: what the user set, with a
/// line of MethodInfo::sweep on top. Settings that come out equal appear once. A method without a
/// sweep is the configuration alone, so that fronts have it.
[[nodiscard]] std::vector<method::MethodConfig> sweep_configs(const method::MethodConfig& config);

/// Settings of which one drawing serves all that differ by a threshold that is no part of it.
class SharedDrawings {
  public:
    explicit SharedDrawings(std::span<const method::MethodConfig> settings);

    /// The settings that are drawn.
    [[nodiscard]] const std::vector<method::MethodConfig>& drawn() const { return drawn_; }
    /// What was drawn of them, in their order, as the evaluations of all settings.
    [[nodiscard]] std::vector<Evaluation> shared(std::vector<Evaluation> drawn) const;

  private:
    std::span<const method::MethodConfig> settings_;
    std::vector<method::MethodConfig> drawn_;
    std::vector<std::size_t> drawing_of_;  ///< per setting
};

}  // namespace ink::harness
