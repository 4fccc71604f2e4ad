#include "methods/surface_codes/code_repair.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <utility>

#include "buffers/each_tile.h"
#include "core/keyed_lists.h"
#include "core/numbering.h"
#include "methods/mesh_lookup/lookup_method.h"

namespace ink::methods {
namespace {

constexpr std::size_t kMostSquares = 6'000'000;

/// A camera that has most of a ball in view.
scene::View random_view(const RandomViews& from,
                        const scene::Sphere& bounds,
                        std::mt19937& random) {
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    glm::dvec3 way(0);
    do {
        way = {number(-1, 1), number(-1, 1), number(-1, 1)};
    } while (glm::dot(way, way) > 1 || glm::dot(way, way) < 1e-4);
    way.y *= 0.7;  // models are seen from the side more than from above
    const double distance = bounds.radius * number(2.3, 3.5);
    scene::View view{{}, from.width_px, from.height_px};
    view.camera = scene::look_at(bounds.center_world + distance * glm::normalize(way),
                                 bounds.center_world,
                                 {0, 1, 0},
                                 view.camera.fov_y_rad);
    scene::fit_clip_range(view.camera, bounds);
    return view;
}

/// The lines of a view, and the faces that it shows.
class SquareViews : public LookupMethod {
  public:
    SquareViews(const SurfaceCodes& codes, double crease_deg)
        : LookupMethod({.crease_deg = crease_deg}),
          codes_(codes),
          graph_(codes.mesh(), {1, {}}),
          squares_(1 << 16) {}

    void add(const scene::View& view, std::size_t most) {
        most_ = most;
        lines_ = edge::EdgeImage(view.width_px, view.height_px);
        draw({view}, lines_);
        const LookupMesh& mesh = pass().screen().mesh();
        face_of_.assign(mesh.faces.size(), SmoothMesh::kNone);
        for (std::size_t t = 0; t < mesh.face_of_triangle.size(); ++t)
            if (mesh.face_of_triangle[t] != kNoNeighbour)
                face_of_[mesh.face_of_triangle[t]] = codes_.face_of()[t];
        buffers::EachTile sink([&](const raster::Tile& drawn) {
            if (drawn.is_empty) return;
            const raster::Tile tile =
                buffers::output_tile(drawn, lines_.width_px(), lines_.height_px());
            for (int y = 0; y < tile.height_px; ++y)
                for (int x = 0; x < tile.width_px; ++x)
                    add_pixel(tile, x, y);
        });
        (void)pass().draw({view}, false, sink);
        pass().inputs().forget_image();
    }

    [[nodiscard]] SeenSquares take() { return {std::move(squares_.keys()), std::move(weights_)}; }

  private:
    void add_pixel(const raster::Tile& tile, int x, int y) {
        const std::uint32_t* const above = tile.row<std::uint32_t>(0, y) + x;
        const std::uint32_t* const below = tile.row<std::uint32_t>(0, y + 1) + x;
        const std::array round{above[0], above[1], below[1], below[0]};
        if (round[0] == round[1] && round[0] == round[2] && round[0] == round[3]) return;
        SeenSquare square;
        for (std::size_t i = 0; i < 4; ++i)
            if (!add_side(round[i], round[(i + 1) % 4], square)) return;
        if (square.pairs == 0) return;
        square.is_line = lines_.at(tile.x0_px + x, tile.y0_px + y) != 0 ? 1 : 0;
        count(square);
    }

    /// Whether codes decide of the square, too.
    bool add_side(std::uint32_t seen0, std::uint32_t seen1, SeenSquare& square) const {
        if (seen0 == seen1) return true;
        if (seen0 == kNoNeighbour || seen1 == kNoNeighbour) return false;
        const auto [low, high] = std::minmax(face_of_[seen0], face_of_[seen1]);
        if (high == SmoothMesh::kNone) return false;
        if (low != high && !goes_on(low, high)) insert({low, high}, square);
        return true;
    }

    static void insert(const std::array<std::uint32_t, 2>& side, SeenSquare& square) {
        std::uint32_t at = square.pairs;
        while (at > 0 && side < square.sides[at - 1])
            --at;
        if (at > 0 && square.sides[at - 1] == side) return;
        for (std::uint32_t i = square.pairs++; i > at; --i)
            square.sides[i] = square.sides[i - 1];
        square.sides[at] = side;
    }

    /// Whether codes of two faces differ by one at most, whatever they are.
    [[nodiscard]] bool goes_on(std::uint32_t face0, std::uint32_t face1) const {
        const SmoothMesh& mesh = codes_.mesh();
        for (std::uint32_t i = 3 * face0; i < 3 * face0 + 3; ++i) {
            if (mesh.across[i] == face1) return true;
            for (std::uint32_t k = 3 * face1; k < 3 * face1 + 3; ++k)
                if (mesh.fan_of[i] == mesh.fan_of[k] && !graph_.is_slit_end(mesh.fan_of[i]))
                    return true;
        }
        return false;
    }

    void count(const SeenSquare& square) {
        if (weights_.size() >= most_) return;
        const auto [number, is_new] = squares_.insert(square);
        if (is_new) weights_.push_back(0);
        weights_[number] += 1;
    }

    const SurfaceCodes& codes_;
    SurfaceGraph graph_;
    edge::EdgeImage lines_;
    std::vector<std::uint32_t> face_of_;  ///< per face of the look-up's mesh
    core::Numbering<SeenSquare> squares_;
    std::vector<float> weights_;
    std::size_t most_ = 0;
};

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

SeenSquares seen_squares(const SurfaceCodes& codes,
                         double crease_deg,
                         const RandomViews& from,
                         const EachPose& each_pose) {
    SquareViews drawing(codes, crease_deg);
    std::mt19937 random(from.seed);
    std::size_t pose = 0;
    each_pose([&](const scene::PreparedScene& scene) {
        if (pose == 0) drawing.prepare(scene);
        drawing.pose(scene);
        const std::size_t most = kMostSquares / from.poses * ++pose;
        for (int i = 0; i < from.views; ++i)
            drawing.add(random_view(from, scene.bounds(), random), most);
    });
    return drawing.take();
}

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
