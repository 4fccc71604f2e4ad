#include "truth/truth.h"

#include <chrono>
#include <cmath>

#include "core/parallel.h"
#include "scene/precision/rounding.h"
#include "truth/curve_facts.h"
#include "truth/eye_scene.h"
#include "truth/eye_view.h"
#include "truth/label_image.h"
#include "truth/model.h"
#include "truth/surface_walk.h"
#include "truth/trace_layers.h"
#include "truth/trace_lines.h"

namespace ink::truth {
namespace {

constexpr double kSameDepth = 1e-10;  ///< relative: rounding between two ways to reach one depth

/// Whether a feature that one walk crossed is in front of what the walk from the other end ran
/// over.
bool is_in_front(const CrossedFeature& feature, const SurfaceWalk& other, double near) {
    if (other.feature && other.feature->edge == feature.edge) return true;
    const auto q = other.q_at(1 - feature.s);
    if (!q || *q * near > 1 + kSameDepth) return true;
    return feature.q >= *q * (1 - kSameDepth);
}

/// A point between the two centres where the surface of one walk comes out of that of the other.
struct Emergence {
    double s = 0;
    double q = 0;
};

/// Where the surface walked from the first centre, until then the nearer, goes under that walked
/// from the second: there the two pierce each other.
class Profiles {
  public:
    Profiles(const SurfaceWalk& there, const SurfaceWalk& back, double near)
        : there_(there), back_(back), near_(near) {}

    [[nodiscard]] std::optional<Emergence> crossing() {
        list_breaks();
        std::optional<Gap> above;
        for (const double s : breaks_) {
            const auto gap = gap_at(s);
            if (!gap) continue;
            if (gap->difference > kSameDepth * gap->q) {
                above = gap;
            } else if (above && gap->difference < -kSameDepth * gap->q) {
                // Linear in between; a break between may have been a tie, and is as good.
                const double part = above->difference / (above->difference - gap->difference);
                return Emergence{above->s + part * (gap->s - above->s),
                                 above->q + part * (gap->q - above->q)};
            }
        }
        return std::nullopt;
    }

  private:
    struct Gap {
        double s, q, difference;
    };

    /// 1/w of the first surface less that of the second, if both are there.
    [[nodiscard]] std::optional<Gap> gap_at(double s) const {
        const auto q0 = there_.q_at(s), q1 = back_.q_at(1 - s);
        if (!q0 || !q1 || *q0 * near_ > 1 || *q1 * near_ > 1) return std::nullopt;
        return Gap{s, *q0, *q0 - *q1};
    }

    /// Where either profile may bend, in the part that both walks ran over, ascending.
    void list_breaks() {
        const double low = std::max(0.0, 1 - back_.end()), high = std::min(1.0, there_.end());
        if (low >= high) return;
        breaks_ = {low, high};
        const auto keep = [&](double s) {
            if (s > low && s < high) breaks_.push_back(s);
        };
        for (const WalkedPiece& piece : there_.pieces)
            keep(piece.s_end);
        for (const WalkedPiece& piece : back_.pieces)
            keep(1 - piece.s_end);
        std::ranges::sort(breaks_);
    }

    const SurfaceWalk& there_;
    const SurfaceWalk& back_;
    double near_;
    std::vector<double> breaks_;
};

/// At which of two neighbours the line between them is drawn.
enum class Mark : std::uint8_t { none, first, second };

class PairRule {
  public:
    explicit PairRule(const EyeView& eye) : eye_(eye) {}

    Mark mark(const CentrePair& pair) {
        walk_surface(eye_, pair, there_);
        if (there_.reached && !differs(pair, there_)) return Mark::none;
        walk_surface(eye_, pair.reversed(), back_);
        if (back_.reached && !differs(pair, back_)) return Mark::none;
        if (there_.reached || back_.reached) return nearer(pair);
        const bool at_first = there_.feature && is_in_front(*there_.feature, back_, eye_.near);
        const bool at_second = back_.feature && is_in_front(*back_.feature, there_, eye_.near);
        const auto emergence = Profiles(there_, back_, eye_.near).crossing();
        if (!at_first && !at_second) {
            if (!emergence) return nearer(pair);
            return emergence->s < 0.5 ? Mark::first : Mark::second;
        }
        const bool is_second_nearer =
            !at_first || (at_second && there_.feature->edge != back_.feature->edge &&
                          back_.feature->q > there_.feature->q * (1 + kSameDepth));
        double s = is_second_nearer ? 1 - back_.feature->s : there_.feature->s;
        const double q = is_second_nearer ? back_.feature->q : there_.feature->q;
        if (emergence && emergence->q > q * (1 + kSameDepth)) s = emergence->s;
        return s < 0.5 ? Mark::first : Mark::second;
    }

  private:
    /// Whether the ids at both ends differ though a walk came from the one to the other.
    [[nodiscard]] bool differs(const CentrePair& pair, const SurfaceWalk& walk) const {
        return walk.has_left_patch && eye_.model.patch[pair.from] != eye_.model.patch[pair.to];
    }

    /// The pixel that method `ids` marks where two ids differ: the nearer, of equally near ones
    /// that of the lower id.
    [[nodiscard]] Mark nearer(const CentrePair& pair) const {
        if (pair.from == kNoFace) return Mark::second;
        if (pair.to == kNoFace) return Mark::first;
        const double q0 = there_.q_at(0).value_or(0), q1 = back_.q_at(0).value_or(0);
        if (std::abs(q0 - q1) <= kSameDepth * q0)
            return pair.from < pair.to ? Mark::first : Mark::second;
        return q0 > q1 ? Mark::first : Mark::second;
    }

    const EyeView& eye_;
    SurfaceWalk there_, back_;
};

/// What the rule says of each sample and the next to the right, and of each and that below.
struct Marks {
    core::Image<Mark> right, below;
};

/// `face` holds the face that is seen at each sample, the first of which lies at (offset_px,
/// offset_px).
Marks mark_pairs(const EyeView& eye,
                 const core::Image<std::uint32_t>& face,
                 double offset_px,
                 int threads) {
    const int width = face.width_px(), height = face.height_px();
    Marks marks{{width, height, Mark::none}, {width, height, Mark::none}};
    core::parallel_for(static_cast<std::size_t>(height), threads, [&](std::size_t row) {
        PairRule rule(eye);
        const int y = static_cast<int>(row);
        const auto mark = [&](int x, int dx, int dy) {
            const std::uint32_t from = face.at(x, y), to = face.at(x + dx, y + dy);
            if (from == to) return Mark::none;
            return rule.mark({x + offset_px, y + offset_px, 1.0 * dx, 1.0 * dy, from, to});
        };
        for (int x = 0; x < width; ++x) {
            if (x + 1 < width) marks.right.at(x, y) = mark(x, 1, 0);
            if (y + 1 < height) marks.below.at(x, y) = mark(x, 0, 1);
        }
    });
    return marks;
}

/// One exact sample a pixel, at its centre: the exact classes seen through ids at pixel centres,
/// 255 where a line runs between two pixels that are neighbours, else 0. A check on construction A,
/// whose visibility it does not use. No ceiling: a method may draw lines wider than a pixel and so
/// join the dots of a bar thinner than one, or mark by luck what no sample sees.
///
/// Where the faces at two neighbouring centres (left and right, or above and below) differ, the
/// rule walks over the mesh along the segment between them, from the one face towards the other
/// centre and from the other back, until it reaches the other face (there is no line) or crosses a
/// feature edge. That is a line if the edge's surface is not behind the surface of the other walk
/// at that point; of two lines the nearer counts, of equally near ones the first. Against the sky
/// there is one walk. A face within 1e-3 px of its centre counts as met there. Where the surface of
/// one walk, until then the nearer, goes under that of the other, the two pierce each other: that
/// is a line too, found from the depths along both walks and not from the crossings of the model.
/// Where the ids differ (smooth patches, of one object or two) and no such line is found, the pixel
/// is marked that method `ids` marks: something lies between that neither centre hits, or the
/// patches meet without sharing vertices. Over a crack of less than 1/64 px, and between faces that
/// coincide, ids do not differ.
///
/// The line is drawn at that of the two pixels which holds the crossing, as the truth image draws
/// it. At the pixel of the nearer surface it would be as near, but where lines run two pixels apart
/// thinning then merges other ones than in the truth: F .944 instead of .993 on a flag
/// beside its pole, of .957 instead of .978 on temple.glb.
///
/// `face` holds at each pixel centre the index of the seen face in the topology, or kNoFace.
edge::EdgeImage draw_sampled(const EyeView& eye,
                             const core::Image<std::uint32_t>& face,
                             int threads) {
    const Marks marks = mark_pairs(eye, face, 0.5, threads);
    edge::EdgeImage image(face.width_px(), face.height_px());
    const auto draw = [&](Mark mark, int x, int y, int dx, int dy) {
        if (mark == Mark::first) image.at(x, y) = 255;
        if (mark == Mark::second) image.at(x + dx, y + dy) = 255;
    };
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            draw(marks.right.at(x, y), x, y, 1, 0);
            draw(marks.below.at(x, y), x, y, 0, 1);
        }
    }
    return image;
}

/// One exact sample a pixel, at its corner: a pixel is a line, 255, if on one of its four sides the
/// surface seen at the one corner does not go on to the other, by the rule of draw_sampled; else 0.
///
/// What lies between two corners is known exactly where either corner's surface tells of it, and
/// else not at all: of a bar thinner than a pixel, whose both lines pass between two corners,
/// nothing is seen there. Where a line runs within its pixel need not be asked: it is the pixel
/// that the truth image marks, too. No ceiling either, for the same reasons.
///
/// `face` holds the index of the seen face, or kNoFace, at each pixel corner: one row and one
/// column more than the image, (x, y) the upper left corner of pixel (x, y).
edge::EdgeImage draw_exact_corner(const EyeView& eye,
                                  const core::Image<std::uint32_t>& face,
                                  int threads) {
    const auto [right, below] = mark_pairs(eye, face, -kCornerShift_px, threads);
    edge::EdgeImage image(face.width_px() - 1, face.height_px() - 1);
    for (int y = 0; y < image.height_px(); ++y) {
        for (int x = 0; x < image.width_px(); ++x) {
            const bool is_line = right.at(x, y) != Mark::none || right.at(x, y + 1) != Mark::none ||
                                 below.at(x, y) != Mark::none || below.at(x + 1, y) != Mark::none;
            image.at(x, y) = is_line ? 255 : 0;
        }
    }
    return image;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TruthCounts counts_of(const Model& model,
                      const scene::View& view,
                      const TracedLines& lines,
                      const LabelImage& image) {
    TruthCounts counts;
    counts.triangles = model.topology.counts.triangles;
    counts.degenerate = model.topology.counts.degenerate;
    counts.duplicate = model.topology.counts.duplicate;
    counts.joined_vertices = model.topology.counts.joined_vertices;
    counts.collapsed = model.topology.counts.collapsed;
    counts.defect_edges = model.defect_edges;
    counts.candidate_edges = lines.candidate_edges;
    counts.samples = lines.samples;
    counts.rays = lines.rays;
    counts.pairs_tested = model.crossings.pairs_tested;
    counts.crossings = model.crossings.segments.size();
    counts.contacts = model.crossings.contacts.size();
    counts.merged_px = image.merged_px;
    counts.crowded_share = image.crowded_share;
    counts.rounding_px = scene::most_rounding_px(model.topology, view);
    return counts;
}

}  // namespace

Truth trace_truth(const Model& model, const scene::View& view, const TruthOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    if (view.width_px <= 0 || view.height_px <= 0) return {};
    const EyeView eye(model, view, options.threads);
    const EyeScene scene(model.topology, view.camera, options.threads);

    Truth truth;
    TracedLines lines = trace_lines(eye, scene, options);
    lines.rays += fill_curve_facts(eye, scene, lines.curves, options.threads);
    LabelImage image = draw_labels(lines.curves, view.width_px, view.height_px, model.crease_rad);
    truth.counts = counts_of(model, view, lines, image);
    truth.labels = std::move(image.labels);
    truth.below_crease = std::move(image.below_crease);
    truth.curves = std::move(lines.curves);
    if (options.layers) {
        TracedLayers seen = trace_layers(eye, scene, options.threads);
        truth.sampled = draw_sampled(eye, seen.face, options.threads);
        truth.exact_corner =
            draw_exact_corner(eye, trace_corners(eye, scene, options.threads), options.threads);
        truth.layers = std::move(seen.layers);
    }
    truth.trace_s = seconds_since(begin);
    return truth;
}

Truth trace_truth(const scene::Scene& scene, const scene::View& view, const TruthOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    const Model model = build_model(scene, options);
    Truth truth = trace_truth(model, view, options);
    truth.trace_s = seconds_since(begin);
    return truth;
}

}  // namespace ink::truth
