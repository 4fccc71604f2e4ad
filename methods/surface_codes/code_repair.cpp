#include "methods/surface_codes/code_repair.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <utility>

#include "core/keyed_lists.h"

namespace ink::methods {
namespace {

/// A line of codes that differ by so many is safe from what the next view rounds otherwise; of less
/// a share is lost, of the least that is a line this. Of .7 and .15 the latter left less of what
/// bull and dancer lose.
constexpr int kSafeDifference = 6;
constexpr float kUnsafeLoss = 0.15F;
/// Larger patches are not shifted: it takes long, and they hold most of what is right already.
constexpr std::size_t kMostShiftedFaces = 4000;

/// A set of numbers from which one can be drawn.
class Drawer {
  public:
    explicit Drawer(std::size_t count) : place_(count, kOut) {}
    [[nodiscard]] const std::vector<std::uint32_t>& all() const { return in_; }
    void put(std::uint32_t number, bool is_in) {
        if (is_in == (place_[number] != kOut)) return;
        if (is_in) {
            place_[number] = static_cast<std::uint32_t>(in_.size());
            in_.push_back(number);
            return;
        }
        in_[place_[number]] = in_.back();
        place_[in_.back()] = place_[number];
        in_.pop_back();
        place_[number] = kOut;
    }

  private:
    static constexpr std::uint32_t kOut = 0xffffffffU;
    std::vector<std::uint32_t> in_;
    std::vector<std::uint32_t> place_;  ///< per number, in `in_`
};

class CodeRepair {
  public:
    CodeRepair(const SmoothMesh& mesh,
               const CodeRange& range,
               const SeenSquares& squares,
               const std::vector<std::int32_t>& heights)
        : mesh_(mesh),
          squares_(squares),
          fold_(range.count()),
          least_difference_(range.least_difference),
          graph_(mesh, {1, {}}),
          squares_of_(mesh.face_count(), [&](auto visit) { for_each_face(visit); }),
          faces_of_(mesh.patch_count,
                    [&](auto visit) {
                        for (std::uint32_t f = 0; f < mesh.face_count(); ++f)
                            visit(mesh.patch_of[f], f);
                    }),
          heights_(heights),
          codes_(heights.size()),
          losses_(squares.list.size(), 0),
          rounds_(squares.list.size(), 0),
          wrong_(squares.list.size()) {
        heights_.resize(graph_.node_count(), std::numeric_limits<std::int32_t>::max());
        for (std::uint32_t corner = 0; corner < mesh.fan_of.size(); ++corner) {
            std::int32_t& of_fan = heights_[node_of(corner)];
            of_fan = std::min(of_fan, heights_[corner / 3] + kStep / 2);
        }
        for (std::size_t f = 0; f < codes_.size(); ++f)
            codes_[f] = fold_.code(heights_[f]);
        for (std::uint32_t i = 0; i < losses_.size(); ++i)
            rate(i);
    }

    void run(int moves) {
        for (int move = 0; move < moves && !wrong_.all().empty(); ++move) {
            before_.clear();
            const double loss = loss_;
            try_something();
            settle();
            if (loss_ > loss) take_back();
        }
    }

    [[nodiscard]] std::vector<std::int32_t> heights() const {
        return {heights_.begin(), heights_.begin() + static_cast<std::ptrdiff_t>(codes_.size())};
    }

  private:
    /// Each face of each square, once for each of its sides.
    template <class Visit>
    void for_each_face(Visit visit) const {
        for (std::uint32_t i = 0; i < squares_.list.size(); ++i) {
            const SeenSquare& square = squares_.list[i];
            for (std::uint32_t side = 0; side < square.pairs; ++side)
                for (const std::uint32_t face : square.sides[side])
                    visit(face, i);
        }
    }

    [[nodiscard]] std::uint32_t node_of(std::uint32_t corner) const {
        return static_cast<std::uint32_t>(mesh_.face_count()) + mesh_.fan_of[corner];
    }
    [[nodiscard]] int below(int count) {
        return static_cast<int>(random_() % static_cast<std::uint32_t>(count));
    }
    [[nodiscard]] int sign() { return below(2) == 0 ? 1 : -1; }

    [[nodiscard]] float loss_of(std::uint32_t number) const {
        const SeenSquare& square = squares_.list[number];
        int most = 0;
        for (std::uint32_t i = 0; i < square.pairs; ++i)
            most =
                std::max(most, std::abs(codes_[square.sides[i][0]] - codes_[square.sides[i][1]]));
        const bool is_drawn = most >= least_difference_;
        const float weight = squares_.weights[number];
        if (is_drawn != (square.is_line != 0)) return weight;
        if (!is_drawn || most >= kSafeDifference) return 0;
        return weight * kUnsafeLoss * static_cast<float>(kSafeDifference - most) /
               static_cast<float>(kSafeDifference - 1);
    }

    void rate(std::uint32_t square) {
        const float loss = loss_of(square);
        loss_ += static_cast<double>(loss) - static_cast<double>(losses_[square]);
        losses_[square] = loss;
        wrong_.put(square, loss > 0);
    }

    /// At one side of the worse of two wrong squares.
    void try_something() {
        const std::vector<std::uint32_t>& wrong = wrong_.all();
        const auto any = [&] { return wrong[static_cast<std::size_t>(random_() % wrong.size())]; };
        std::uint32_t worst = any();
        if (const std::uint32_t other = any(); losses_[other] > losses_[worst]) worst = other;
        const SeenSquare& square = squares_.list[worst];
        auto [face, beside] =
            square.sides.at(static_cast<std::size_t>(below(static_cast<int>(square.pairs))));
        if (below(2) == 0) std::swap(face, beside);
        const std::uint32_t patch = mesh_.patch_of[face];
        if (patch != mesh_.patch_of[beside] && below(4) == 0 &&
            faces_of_.of(patch).size() < kMostShiftedFaces)
            return shift(patch, sign() * (1 + below(40)) * kStep);
        move(face, square.is_line != 0 ? parting() : nearing(heights_[beside] - heights_[face]));
    }

    /// By how much a face moves where a line is to be.
    [[nodiscard]] std::int32_t parting() {
        const int steps = 1 + below(below(4) == 0 ? 16 : 6);
        return sign() * (steps * kStep - below(kStep));
    }
    /// And where none is to be, the other lying so much higher.
    [[nodiscard]] std::int32_t nearing(std::int32_t higher) {
        if (higher == 0 || std::abs(higher) >= 40 * kStep) return sign() * kStep;
        return static_cast<std::int32_t>(std::int64_t{higher} * (1 + below(8)) / 8);
    }

    void set_height(std::uint32_t node, std::int32_t height) {
        before_.emplace_back(node, heights_[node]);
        heights_[node] = height;
    }

    void shift(std::uint32_t patch, std::int32_t by) {
        for (const std::uint32_t face : faces_of_.of(patch)) {
            set_height(face, heights_[face] + by);
            for (std::uint32_t corner = 3 * face; corner < 3 * face + 3; ++corner)
                shifted_.push_back(node_of(corner));
        }
        std::ranges::sort(shifted_);
        shifted_.erase(std::unique(shifted_.begin(), shifted_.end()), shifted_.end());
        for (const std::uint32_t node : shifted_)
            set_height(node, heights_[node] + by);
        shifted_.clear();
    }

    /// Raises or lowers a face, and what its ways take along: Dijkstra 1959, by keys that are
    /// heights, or these below 0.
    void move(std::uint32_t face, std::int32_t by) {
        const int sign = by > 0 ? -1 : 1;
        set_height(face, heights_[face] + by);
        due_.assign(1, {sign * heights_[face], face});
        while (!due_.empty()) {
            std::pop_heap(due_.begin(), due_.end(), std::greater<>());
            const auto [key, node] = due_.back();
            due_.pop_back();
            if (key != sign * heights_[node]) continue;
            graph_.for_each_way(node, [&, key = key, node = node](std::uint32_t to, std::int32_t) {
                const bool is_half = std::max(node, to) >= codes_.size();
                const std::int32_t least = key + (is_half ? kStep / 2 : kStep);
                if (sign * heights_[to] <= least) return;
                set_height(to, sign * least);
                due_.emplace_back(least, to);
                std::push_heap(due_.begin(), due_.end(), std::greater<>());
            });
        }
    }

    /// Codes and losses of what has moved.
    void settle() {
        ++round_;
        for (const auto& [node, height] : before_) {
            if (node >= codes_.size()) continue;
            const int code = fold_.code(heights_[node]);
            if (code == codes_[node]) continue;
            codes_[node] = code;
            for (const std::uint32_t square : squares_of_.of(node)) {
                if (rounds_[square] == round_) continue;
                rounds_[square] = round_;
                touched_.push_back(square);
            }
        }
        for (const std::uint32_t square : touched_)
            rate(square);
        touched_.clear();
    }

    void take_back() {
        for (auto at = before_.rbegin(); at != before_.rend(); ++at)
            heights_[at->first] = at->second;
        settle();
    }

    const SmoothMesh& mesh_;
    const SeenSquares& squares_;
    Fold fold_;
    int least_difference_;
    SurfaceGraph graph_;
    core::KeyedLists<std::uint32_t> squares_of_;  ///< per face
    core::KeyedLists<std::uint32_t> faces_of_;    ///< per patch
    std::vector<std::int32_t> heights_;           ///< per node of the graph
    std::vector<int> codes_;                      ///< per face
    std::vector<float> losses_;                   ///< per square
    std::vector<std::uint32_t> rounds_;           ///< per square, when it was rated last
    Drawer wrong_;
    double loss_ = 0;
    std::uint32_t round_ = 0;
    std::vector<std::pair<std::uint32_t, std::int32_t>> before_;  ///< nodes that moved, from where
    std::vector<std::pair<std::int32_t, std::uint32_t>> due_;
    std::vector<std::uint32_t> shifted_;
    std::vector<std::uint32_t> touched_;
    std::mt19937 random_{1};
};

}  // namespace

std::vector<std::int32_t> repaired_heights(const SmoothMesh& mesh,
                                           const CodeRange& range,
                                           const SeenSquares& squares,
                                           const std::vector<std::int32_t>& heights,
                                           int moves) {
    CodeRepair repair(mesh, range, squares, heights);
    repair.run(moves);
    return repair.heights();
}

}  // namespace ink::methods
