// Every number here was found on the training scenes of the catalogue at 1280x720, all views, by
// drawing each with mote16 or mote4 at settings of which these are the ends of the plateaus. What
// was tried is on the method's page.

#include "methods/auto/auto_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

namespace ink::methods {
namespace {

// The code range is less than the store's, so that far differs from the sky by a line's step.
constexpr double kByteRange = 240;
constexpr double kWordRange = 60000;

// A line's step, as shares of the code's range.
constexpr double kLeastStep = 4.0 / 60000;     // flat faces: what clip_bits = 2 leaves
constexpr double kDepthCurvedStep = 1.0 / 30;  // depth alone on a curved surface
constexpr double kStepPerDegree = 1.0 / 1540;  // sums, by the dihedral deviation between facets
constexpr double kMostStep = 1.0 / 62;         // sums, whatever the dihedral deviation
constexpr double kLogStep = 1.0 / 300;         // below it, log w's kinks within planes would show
constexpr double kClippedCodes = 4;            // the least response that clip_bits = 2 leaves

constexpr double kSoupShare = 0.1;  // of triangles without a neighbour

// Depth, nx, ny, nz. No two alike, nor any the sum of others: turns about the axes of the view do
// not cancel. Depth most, for it alone parts parallel faces.
constexpr double kWeights[4] = {16.0 / 37, 12.0 / 37, 6.0 / 37, 3.0 / 37};

class Planner {
  public:
    Planner(const scene::SceneStatistics& statistics, const PlanWishes& wishes)
        : statistics_(statistics), wishes_(wishes) {}

    CodePlan make() {
        choose_channels();
        choose_step();
        choose_store();
        choose_encoding();
        say_what_no_code_sees();
        scale();
        return std::move(plan_);
    }

  private:
    void say(std::string what, std::string why) {
        plan_.lines.push_back({std::move(what), std::move(why)});
    }

    [[nodiscard]] bool is_soup() const { return statistics_.loose_share() > kSoupShare; }

    void choose_channels() {
        using Channels = PlanWishes::Channels;
        is_depth_only_ = wishes_.channels != Channels::all;
        const std::string depth_alone = "depth alone, no normals";
        const std::string both = "depth and normals, weighted 16 : 12 : 6 : 3";
        if (wishes_.channels != Channels::planned) {
            return say(is_depth_only_ ? depth_alone : both, "requested by a parameter");
        }
        if (is_soup()) {
            return say(depth_alone,
                       fmt::format("{:.0f} % of the triangles have no neighbour, so normals cannot "
                                   "be smoothed over them and jump at every facet",
                                   100 * statistics_.loose_share()));
        }
        if (!statistics_.has_creases() && !statistics_.may_cross()) {
            return say(
                depth_alone,
                fmt::format("no edge bends by {:.0f} degrees and no components can cross, so "
                            "every line that a code can see is a step of depth",
                            glm::degrees(statistics_.crease_rad)));
        }
        is_depth_only_ = false;
        if (statistics_.has_creases()) {
            return say(both,
                       fmt::format("{} creases turn the normal where depth has only a kink; "
                                   "weights that differ do not cancel in the same directions",
                                   statistics_.creases.count + statistics_.nonmanifold.count));
        }
        say(both,
            fmt::format("{} pairs of components may cross, and where they do depth has no step",
                        statistics_.overlapping_components));
    }

    void choose_step() {
        const bool is_rough = statistics_.is_curved() || is_soup();
        const double deviation_deg = glm::degrees(statistics_.largest_smooth_rad);
        std::string why;
        if (!is_rough) {
            step_ = kLeastStep;
            why =
                "all faces are flat: a plane's code, rounded once, responds with 2 at most, and 3 "
                "is clipped";
        } else if (is_depth_only_) {
            step_ = kDepthCurvedStep;
            why = "depth bends from facet to facet, most where a curved surface turns away";
        } else {
            step_ = std::clamp(deviation_deg * kStepPerDegree, kLeastStep, kMostStep);
            why = fmt::format(
                "facets of smooth surfaces bend by up to {:.1f} degrees, and their "
                "normals' slopes with them",
                deviation_deg);
        }
        step_ *= wishes_.step_scale;
        say(fmt::format("least step of a line: {:.2g} % of the range", 100 * step_),
            std::move(why));
    }

    void choose_store() {
        using Bytes = PlanWishes::Bytes;
        // Twice the least that the clipped response can tell, so that rounding decides nothing.
        const bool is_enough = step_ * kByteRange > 1.99 * kClippedCodes;
        const bool is_byte =
            wishes_.bytes == Bytes::one || (wishes_.bytes == Bytes::planned && is_enough);
        plan_.store = is_byte ? raster::Store::u8 : raster::Store::u16;
        say(is_byte ? "one byte per pixel" : "two bytes per pixel",
            wishes_.bytes != Bytes::planned
                ? "requested by a parameter"
                : fmt::format("that step is {:.1f} of {:.0f} codes of a byte, and clipping leaves "
                              "multiples of 4",
                              step_ * kByteRange,
                              kByteRange));
    }

    void choose_encoding() {
        using Encoding = PlanWishes::Encoding;
        const bool is_log = wishes_.encoding == Encoding::log ||
                            (wishes_.encoding == Encoding::planned && step_ >= kLogStep);
        plan_.encoding = is_log ? raster::DepthEncoding::log : raster::DepthEncoding::inverse;
        const std::string what = is_log ? "depth as log w" : "depth as 1/w";
        if (wishes_.encoding != Encoding::planned) return say(what, "requested by a parameter");
        say(what,
            is_log
                ? "each code is the same share of the distance, where 1/w spends most on what is "
                  "nearest; its kinks where triangles of a plane meet are less than the step"
                : "on a plane it is linear over all its triangles, and a step this small allows no "
                  "kink within a plane");
    }

    void say_what_no_code_sees() {
        if (statistics_.seams.count == 0) return;
        say("nothing for seams",
            fmt::format("at {} edges two objects meet without a crease: depth and normal are the "
                        "same on both sides, and no sum of them can differ",
                        statistics_.seams.count));
    }

    /// Ranges and shift such that a step of the planned size has kPlannedResponse.
    void scale() {
        const double range = plan_.store == raster::Store::u8 ? kByteRange : kWordRange;
        const double step = std::max(step_ * range, kClippedCodes);
        const int shift = static_cast<int>(std::floor(std::log2(step / kPlannedResponse)));
        plan_.scale_bits = -shift;
        // At most 1, and more than a half.
        const double share = std::ldexp(kPlannedResponse, shift) / step;
        const double sum = range * share;
        plan_.ranges.depth = is_depth_only_ ? sum : sum * kWeights[0];
        for (int i = 0; i < 3 && !is_depth_only_; ++i)
            plan_.ranges.normal[i] = sum * kWeights[i + 1];
    }

    const scene::SceneStatistics& statistics_;
    const PlanWishes& wishes_;
    CodePlan plan_;
    bool is_depth_only_ = true;
    double step_ = 0;
};

}  // namespace

buffers::CodeLayout CodePlan::layout() const {
    const int bits = store == raster::Store::u8 ? 8 : 16;
    return {.store = store, .planes = 1, .fields = {{.ranges = ranges, .bits = bits}}};
}

buffers::PackParams CodePlan::applied_to(buffers::PackParams params) const {
    params.depth_encoding = encoding;
    params.depth_sign = buffers::DepthSign::far_high;
    params.scale_bits = scale_bits;
    params.sky = store == raster::Store::u8 ? 255 : 65535;
    return params;
}

CodePlan make_plan(const scene::SceneStatistics& statistics, const PlanWishes& wishes) {
    return Planner(statistics, wishes).make();
}

}  // namespace ink::methods
