#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <tuple>
#include <vector>

#include "experiment/experiment.h"
#include "harness/cells/view_cells.h"
#include "harness/scores/miss_prediction.h"
#include "scene/prepared_scene.h"

namespace ink::experiment {

/// The scenes of an experiment, and what is kept of those that are worked on from block to block:
/// the model, the methods made ready, the truths of the last views. Several lanes
/// (core::run_lanes) may use it at a time, for one scene or for several.
class ViewBench {
  public:
    /// Loads the scenes of `experiment` at each of its sizes. Throws core::Error as load_scenes
    /// does.
    ViewBench(const Experiment& experiment, harness::TraceOptions trace);

    [[nodiscard]] const Experiment& experiment() const { return experiment_; }
    [[nodiscard]] const std::vector<method::MethodConfig>& configs() const { return configs_; }
    [[nodiscard]] const std::vector<scene::Scene>& scenes() const { return scenes_; }
    [[nodiscard]] std::size_t view_count(std::size_t scene, const ImageSize& size) const;
    [[nodiscard]] const scene::View& view(std::size_t scene,
                                          const ImageSize& size,
                                          std::size_t n) const;
    [[nodiscard]] harness::CellOptions cell_options(int threads) const;

    /// The truth of a view; those of the last two views asked for are at hand, for lanes are seldom
    /// further apart. One lane traces a scene at a time.
    [[nodiscard]] std::shared_ptr<const harness::TracedView> traced(std::size_t scene,
                                                                    const scene::View& view);
    harness::MissPredictor& predictor(std::size_t scene);
    /// How many methods or settings may be ready for a scene at a time: what they prepare for a
    /// large mesh takes gigabytes. At least 1.
    [[nodiscard]] std::size_t most_at_once(std::size_t scene) const;
    /// Held by who uses the methods() of a scene: they draw one view at a time.
    [[nodiscard]] std::unique_lock<std::mutex> hold_methods(std::size_t scene);
    /// The methods from the `first` on, most_at_once of them, at their own settings, ready for the
    /// scene. Those last asked for are at hand.
    std::shared_ptr<harness::PreparedMethods> methods(std::size_t scene, std::size_t first);
    /// Some methods made ready for the scene; they are not kept.
    [[nodiscard]] std::shared_ptr<harness::PreparedMethods> prepared(
        std::span<const method::MethodConfig> configs, std::size_t scene);

    /// Lets go what is kept of a scene.
    void release(std::size_t scene);

  private:
    /// Adds views of one size, and the scenes if these are the first.
    void add_scenes(const ImageSize& size, std::vector<harness::SceneViews> scenes);

    /// What is kept of one scene.
    struct Desk {
        std::unique_ptr<truth::SceneModel> model = {};
        std::unique_ptr<harness::MissPredictor> predictor = {};
        std::unique_ptr<scene::PreparedScene> prepared = {};
        std::mutex using_methods = {};
        std::shared_ptr<harness::PreparedMethods> methods = {};
        std::size_t first_method = 0;
        struct Traced {
            const scene::View* view = nullptr;
            std::shared_ptr<const harness::TracedView> truth = {};
        };
        std::mutex tracing = {};
        std::array<Traced, 2> traced = {};  ///< the last asked for first
    };

    /// What is kept of a scene, made if it is not there.
    Desk& desk_of(std::size_t scene);

    Experiment experiment_;
    harness::TraceOptions trace_;
    std::vector<method::MethodConfig> configs_;
    raster::SkipSet skips_;
    std::vector<scene::Scene> scenes_;
    std::map<std::tuple<std::size_t, int, int>, std::vector<scene::View>> views_;
    std::mutex desks_mutex_;
    std::vector<std::unique_ptr<Desk>> desks_;  ///< by scene
};

}  // namespace ink::experiment
