#include "methods/surface_codes/seen_squares.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <utility>

#include "buffers/each_tile.h"
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

}  // namespace ink::methods
