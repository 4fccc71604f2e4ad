#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "crosscheck/dense_sampling.h"
#include "truth/model.h"
#include "truth/truth.h"

namespace ink::harness {

/// Within so much of each other two lines of one class are the same line.
inline constexpr double kAgreement_px = 0.25;

/// Of lines that run this near to each other the cross-check may see only one.
inline constexpr double kThinnest_px = 1.0 / 32;

/// Lines this near the frame are not held against each other.
inline constexpr double kFrame_px = 0.5;

/// The share of a line that the other may lack (section 5 of the design).
inline constexpr double kAllowedShare = 0.001;

/// What a single crossing of the cross-check may stand for: the distance between its places along
/// an edge. It counts whole, though the truth may pass over as little of a line as lies between two
/// of its samples, 1/4 px apart.
inline constexpr double kOneCrossing_px = 0.375;

/// How much of the lines of one class either construction has, and how much of it the other has
/// too.
struct ClassAgreement {
    double truth_px = 0;               ///< length of the curves inside the image
    double truth_covered_px = 0;       ///< of that, with a cross-check point of the class close by
    double crosscheck_px = 0;          ///< length that the cross-check's crossings stand for
    double crosscheck_covered_px = 0;  ///< of that, with a curve of the class close by
    /// Not covered, and no disagreement: the third construction sides with the truth, or the digits
    /// of the file leave it open. Curves that the cross-check stepped over, or points of its own
    /// that nothing confirms.
    double truth_abstained_px = 0;
    double crosscheck_abstained_px = 0;
    /// Of both abstained lengths: on a line of another class that both have (judge_disagreements).
    double coincident_px = 0;

    ClassAgreement& operator+=(const ClassAgreement& other);
    /// Whether each has all but kAllowedShare of the other's, or all but kAgreement_px of the
    /// truth's and one crossing of the cross-check's: of a class of a few px that is more than the
    /// share. Abstentions do not count.
    [[nodiscard]] bool is_agreed() const;
    /// Of what the other does not abstain on, the share that it has; 1 where there is no line.
    [[nodiscard]] double truth_share() const;
    [[nodiscard]] double crosscheck_share() const;
};

/// A piece of line that the other construction does not have.
struct Disagreement {
    double x_px = 0;
    double y_px = 0;
    double length_px = 0;
    truth::LineClass line_class = truth::LineClass::none;
    bool is_truth = true;      ///< the curves have it and the cross-check not, or the reverse
    std::size_t curve = 0;     ///< into the curves, where they have it
    bool is_confirmed = true;  ///< false: it is one that the cross-check abstains on
    /// Of the other construction's lines that run within kThinnest_px.
    truth::LineClass beside = truth::LineClass::none;
    std::uint32_t edge = truth::kNoEdge;  ///< of the mesh, where the curves have it
};

/// How the two constructions of one view agree.
struct Agreement {
    std::array<ClassAgreement, truth::kLineClasses.size()>
        by_class;  ///< in the order of kLineClasses
    std::vector<Disagreement> disagreements;

    /// All classes together.
    [[nodiscard]] ClassAgreement total() const;
    /// Every class and all together.
    [[nodiscard]] bool is_agreed() const;
    /// Confirmed uncovered length over length, both ways, all classes; 0 where neither has a line.
    [[nodiscard]] double disagreement_rate() const;
    /// The same of the length on which the cross-check abstains.
    [[nodiscard]] double abstained_share() const;
};

/// How far a point is from the segment from a to b.
[[nodiscard]] double distance_to_segment(const glm::dvec2& p,
                                         const glm::dvec2& a,
                                         const glm::dvec2& b);

/// Holds the curves of a traced truth against the cross-check's points, class by class, both ways.
///
/// Curves are taken every 1/8 px, each sample standing for its share of the curve's length; a
/// sample, or a point, is covered if the other has its class within kAgreement_px. Lines within
/// kFrame_px of the frame are left out: which side of it they lie on is a matter of rounding.
/// Every disagreement counts as confirmed until `judge_disagreements` has been asked. The same for
/// every thread count.
[[nodiscard]] Agreement compare_truths(std::span<const truth::Curve> curves,
                                       const crosscheck::SampledLines& crosscheck,
                                       const scene::View& view,
                                       int threads = 1);

/// Asks the third construction (crosscheck/line_probe.h) about every disagreement, and whether
/// digits leave the place open (crosscheck/line_probe.h). What the one does not confirm, or the
/// other excuses, is moved to the abstained lengths.
///
/// So is what lies on another line that both have: of edges that coincide on the image each may
/// draw another. The third construction must see that other line, and a curve's class must be that
/// of its edge.
void judge_disagreements(const scene::Topology& topology,
                         const scene::View& view,
                         const crosscheck::SamplingOptions& options,
                         Agreement& agreement);

/// Of the curves' length that the cross-check lacks, px: what runs alongside another curve within
/// kThinnest_px. Between the two lies a strip of surface that its samples step over: surfaces that
/// coincide but for rounding, folded slivers, faces seen nearly edge-on. A reason for disagreement,
/// not an excuse from it: it is told beside the rate and is part of it.
[[nodiscard]] double strip_length_px(std::span<const truth::Curve> curves,
                                     const Agreement& agreement);

/// What the cross-check says of a view's truth.
struct Crosscheck {
    Agreement agreement;
    crosscheck::SamplingCounts counts;
    double look_s = 0;  ///< wall time of looking and comparing (kept when it comes from the cache)
};

/// Looks at the view with the cross-check and holds `truth`, which was traced of it, against that;
/// or reads back from `cache_dir` what came of it before.
///
/// Kept beside the truth, as `<truth_key>.crosscheck`, by the same rules (truth_cache.h).
[[nodiscard]] Crosscheck cached_crosscheck(truth::SceneModel& scene,
                                           const scene::View& view,
                                           const truth::Truth& truth,
                                           const std::filesystem::path& cache_dir);

/// A check as bytes, and back; nothing if they are cut off, changed, of another key, or hold a
/// number that is none of its kind.
[[nodiscard]] std::string encode_check(const Crosscheck& check, const std::string& key);
[[nodiscard]] std::optional<Crosscheck> decode_check(std::string_view bytes,
                                                     const std::string& key);

}  // namespace ink::harness
