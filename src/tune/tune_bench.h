#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "harness/suite/suite.h"
#include "harness/truths/tracing.h"
#include "linear_code/channel_planes.h"
#include "method/method_config.h"
#include "score/drawing.h"
#include "score/score.h"
#include "tune/tune_objective.h"
#include "tune/tune_space.h"

namespace ink::tune {

/// A view of a bench, and what is scored against there.
struct BenchView {
    std::size_t scene_index = 0;
    scene::View view;
    core::Image<std::uint32_t> triangle;  ///< that its pixels see (truth::Layers::triangle)
    score::TruthLists lists;
};

/// Draws settings whose code is one linear sum without their method: from channel planes
/// (linear_code/channel_planes.h) that are made once per view and serve every set of weights.
///
/// Planes depend on what the code reads (normals, dihedral deviation, encoding, range,
/// interpolation) alone and are kept by that. An image of them is the method's but for pixels that
/// rounding decides, so it serves to choose among settings; what is reported is the method's.
class TunePlanes {
  public:
    /// Borrows the scenes and their views.
    TunePlanes(const std::vector<harness::SceneViews>& scenes, const std::vector<BenchView>& views)
        : scenes_(scenes), views_(views) {}

    /// Whether these settings can be drawn so: they declare a code that is the same in every scene,
    /// and a set of planes takes no more than a gigabyte. Hangs on no earlier call.
    [[nodiscard]] bool can_draw(const method::MethodConfig& config) const;

    /// Whether it is worth it to search `space` so: none of its numbers makes new planes.
    [[nodiscard]] bool can_search(const method::MethodConfig& config, const TuneSpace& space) const;

    /// The views' images, in their order. can_draw() is the caller's duty.
    [[nodiscard]] std::vector<edge::EdgeImage> images(const method::MethodConfig& config,
                                                      int threads);

  private:
    struct PlaneSet {
        std::string key;  ///< what the code reads
        std::vector<linear_code::ChannelPlanes> views;
    };
    [[nodiscard]] std::size_t set_bytes() const;
    const PlaneSet& planes_of(const method::LinearCode& code, int threads);

    const std::vector<harness::SceneViews>& scenes_;
    const std::vector<BenchView>& views_;
    std::vector<PlaneSet> kept_;  ///< the latest last
};

/// Who draws a setting.
enum class DrawnBy {
    method,  ///< as every harness has it drawn
    planes,  ///< from what its code reads, which is made once (TunePlanes)
};

/// How far planes are from the method that they stand for.
struct PlaneAgreement {
    std::int64_t differ_px = 0;  ///< drawn by one and not by the other, at the threshold
    std::int64_t total_px = 0;   ///< of all views
    std::vector<score::CurveCount> by_planes;  ///< a sum per scene, at 2 px
};

/// What a tuner wants of a set of views: everything but the method's own work, done once.
///
/// Truths are traced (or read) once and kept as lists of pixels; a setting is then drawn and
/// matched at 2 px alone. Where its code is one linear sum it can be drawn from planes, without the
/// scenes. The images of the last settings are kept, so that one that differs in its threshold
/// alone is not drawn again.
class TuneBench {
  public:
    /// Traces every view of `scenes`, saying on a terminal how far it is. Borrows the scenes.
    /// Throws core::Error where a truth is too large or was interrupted.
    TuneBench(const std::vector<harness::SceneViews>& scenes,
              const harness::TraceOptions& trace,
              int threads);
    TuneBench(const TuneBench&) = delete;
    TuneBench& operator=(const TuneBench&) = delete;

    [[nodiscard]] std::size_t view_count() const { return views_.size(); }
    /// A hash of what is scored against: names, sizes, truth pixels.
    [[nodiscard]] const std::string& hash() const { return hash_; }

    /// What can be drawn from planes.
    [[nodiscard]] const TunePlanes& planes() const { return planes_; }

    /// Counts of each view at 2 px and the configuration's own threshold.
    [[nodiscard]] std::vector<score::CurveCount> view_counts(const method::MethodConfig& config,
                                                             DrawnBy by = DrawnBy::method);
    /// Whose views they are.
    [[nodiscard]] const TuneViews& tune_views() const { return tune_views_; }
    /// What gains are over (TuneViews::at_start).
    void start_from(std::vector<score::CurveCount> by_view) {
        tune_views_.at_start = std::move(by_view);
    }
    /// view_counts, summed over the views of each scene.
    [[nodiscard]] std::vector<score::CurveCount> counts(const method::MethodConfig& config,
                                                        DrawnBy by = DrawnBy::method);

    /// Planes held against the method that draws the same.
    [[nodiscard]] PlaneAgreement agreement(const method::MethodConfig& config);

    /// Median over the views of the milliseconds that a drawing takes on one thread, by the clock
    /// of every comparison (harness::draw_in_turns), when this was last asked to draw.
    [[nodiscard]] double draw_ms() const { return draw_ms_; }
    /// From now on draws without threads and takes times.
    void take_times() { takes_times_ = true; }

  private:
    struct Drawn {
        std::string key;  ///< all settings but the threshold, and who drew
        std::vector<edge::EdgeImage> images;
    };
    const std::vector<edge::EdgeImage>& images_of(const method::MethodConfig& config, DrawnBy by);
    [[nodiscard]] std::vector<edge::EdgeImage> drawn_by_method(const method::MethodConfig& config);
    void draw_scene(const method::MethodConfig& config,
                    std::size_t scene_index,
                    std::vector<edge::EdgeImage>& images,
                    std::vector<double>& times_ms) const;

    const std::vector<harness::SceneViews>& scenes_;
    int threads_;
    bool takes_times_ = false;
    double draw_ms_ = 0;
    std::vector<BenchView> views_;
    TuneViews tune_views_;
    std::string hash_;
    TunePlanes planes_;
    std::vector<Drawn> kept_;  ///< the latest last
};

}  // namespace ink::tune
