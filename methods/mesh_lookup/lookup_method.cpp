#include "methods/mesh_lookup/lookup_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>
#include <string>

#include "buffers/each_tile.h"
#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"
#include "core/error.h"
#include "methods/mesh_lookup/lookup_table.h"
#include "methods/surface_codes/code_method.h"

namespace ink::methods {
namespace {

/// Steps of 1/w up to this, in px of depth, are flat: codes alone are no line there.
constexpr double kFlat_px = 0.1;

/// Looks up the sides of a tile that are in doubt.
class SideLookup {
  public:
    /// `classes`: an image of the view's size, or null.
    SideLookup(const LookupPass& pass,
               buffers::Samples samples,
               const raster::Tile& tile,
               core::Image<LineKind>* classes)
        : screen_(pass.screen()),
          words_{.tile = tile,
                 .has_corners = samples == buffers::Samples::corner,
                 .face_bits = pass.rule() == nullptr ? kNoNeighbour : LookupWord::kFaceOfCoded,
                 .faces = screen_.mesh().faces,
                 .facing = screen_.facing(),
                 .is_cut = screen_.is_cut()},
          rule_(pass.rule()),
          classes_(classes) {}

    void mark_lines(LineBits& lines) const {
        lines.clear();
        SideList list;
        list_sides(words_, classes_ == nullptr ? rule_ : nullptr, &lines, list);
        if (classes_ != nullptr || !words_.has_corners) {
            for (std::size_t i = 0; i < list.count; ++i)
                mark_one(list.places[i], lines);
            return;
        }
        // Every other side along a line first: what lies between is then mostly marked.
        for (const std::uint32_t parity : {0U, 1U}) {
            for (std::size_t i = 0; i < list.count; ++i) {
                const std::uint32_t place = list.places[i];
                const std::uint32_t along = (place & 1) != 0 ? place >> 1 : place >> 8;
                if ((along & 1) == parity) mark_corners(place, lines);
            }
        }
    }

  private:
    struct Place {
        int x, y;
        bool is_down;

        /// Beside a side between corners (x, y) is one pixel, and this the other.
        [[nodiscard]] int other_x() const { return is_down ? x - 1 : x; }
        [[nodiscard]] int other_y() const { return is_down ? y : y - 1; }
    };
    [[nodiscard]] static Place place_of(std::uint32_t place) {
        return {static_cast<int>(place >> 1 & 0x7f) - 1,
                static_cast<int>(place >> 8) - 1,
                (place & 1) != 0};
    }
    [[nodiscard]] std::uint32_t face_at(int x, int y) const {
        const std::uint32_t word = words_.tile.row<std::uint32_t>(0, y)[x];
        return word == kNoNeighbour ? word : word & words_.face_bits;
    }
    [[nodiscard]] SampleSide side_at(const Place& at) const {
        return {words_.tile.x0_px + at.x,
                words_.tile.y0_px + at.y,
                at.is_down,
                face_at(at.x, at.y),
                at.is_down ? face_at(at.x, at.y + 1) : face_at(at.x + 1, at.y)};
    }

    /// A side of two pixels; nothing is left to be said of it where both are lines.
    void mark_corners(std::uint32_t place, LineBits& lines) const {
        const Place at = place_of(place);
        if (lines.is_done(at.x, at.y) && lines.is_done(at.other_x(), at.other_y())) return;
        const SampleSide side = side_at(at);
        const auto glimpse = screen_.glimpse(side);
        if (glimpse == ScreenMesh::Glimpse::none) return;
        if (glimpse == ScreenMesh::Glimpse::unknown &&
            screen_.line_between(side).kind == LineKind::none)
            return;
        lines.set(at.x, at.y);
        lines.set(at.other_x(), at.other_y());
    }

    /// The same of any samples, with its class.
    void mark_one(std::uint32_t place, LineBits& lines) const {
        const Place at = place_of(place);
        const FoundLine line = screen_.line_between(side_at(at));
        if (line.kind == LineKind::none) return;
        if (words_.has_corners) {
            mark(at.x, at.y, line.kind, lines);
            mark(at.other_x(), at.other_y(), line.kind, lines);
        } else {
            const int step = line.s < 0.5 ? 0 : 1;
            mark(
                at.is_down ? at.x : at.x + step, at.is_down ? at.y + step : at.y, line.kind, lines);
        }
    }

    /// A pixel that two lines run through shows that of the lower number.
    void mark(int x, int y, LineKind kind, LineBits& lines) const {
        const raster::Tile& tile = words_.tile;
        if (x < 0 || x >= tile.width_px || y < 0 || y >= tile.height_px) return;
        lines.set(x, y);
        if (classes_ == nullptr) return;
        LineKind& known = classes_->at(tile.x0_px + x, tile.y0_px + y);
        if (known == LineKind::none || kind < known) known = kind;
    }

    const ScreenMesh& screen_;
    WordTile words_;
    const CodeRule* rule_;
    core::Image<LineKind>* classes_;
};

/// As pictures of the truth have them, by kind: paper, contours, boundaries, creases, intersections
/// and seams.
glm::u8vec3 color_of(LineKind kind) {
    static const std::array<glm::u8vec3, 6> kColors = {{{255, 255, 255},
                                                        {32, 36, 42},
                                                        {204, 121, 167},
                                                        {0, 158, 115},
                                                        {230, 159, 0},
                                                        {86, 180, 233}}};
    return kColors.at(static_cast<std::size_t>(kind));
}

}  // namespace

std::vector<std::uint32_t> lookup_codes(const scene::PreparedScene& scene,
                                        const LookupParams& params) {
    const SurfaceCodeParams code_params{
        {.crease_deg = params.crease_deg, .weld_epsilon = params.weld_epsilon}};
    SurfaceCodes codes(code_options(code_params, surface_setup(code_params)));
    codes.prepare(scene);
    return codes.object_codes(scene, code_params.length_px);
}

LookupPass::LookupPass(const LookupParams& params, const std::optional<CodedLookup>& coded)
    : ConstantPass(buffers::constant_inputs(params),
                   buffers::constant_format(raster::Store::u32, params.depth_format, coded ? 2 : 1),
                   kNoNeighbour),
      params_(params),
      coded_(coded) {}

void LookupWord::require_room(std::string_view method, std::size_t faces) {
    if (faces < kFaceOfCoded) return;
    throw core::Error(std::string(method),
                      fmt::format("{} triangles", faces),
                      fmt::format("less than {}", kFaceOfCoded));
}

void LookupPass::prepare(const scene::PreparedScene& scene) {
    codes_.clear();
    ConstantPass::prepare(scene);
}

std::vector<std::uint32_t> LookupPass::constants_of(const scene::PreparedScene& scene) {
    // A copy: where methods draw in turns, one that is shared would be in the caches.
    mesh_ =
        *scene.get(fmt::format("lookup mesh {} {}", params_.crease_deg, params_.weld_epsilon), [&] {
            return make_lookup_mesh(scene,
                                    {.crease_rad = glm::radians(params_.crease_deg),
                                     .weld_epsilon = params_.weld_epsilon});
        });
    return coded_ ? words_of(scene) : mesh_.face_of_triangle;
}

/// Words of codes, flags and faces, per global triangle.
std::vector<std::uint32_t> LookupPass::words_of(const scene::PreparedScene& scene) {
    LookupWord::require_room(coded_->method, mesh_.faces.size());
    if (codes_.empty()) codes_ = lookup_codes(scene, params_);
    const std::vector<std::uint32_t> words = lookup_words(mesh_, codes_);
    std::vector<std::uint32_t> of_triangles = mesh_.face_of_triangle;
    for (std::uint32_t& face : of_triangles)
        if (face != kNoNeighbour) face = words[face];
    return of_triangles;
}

void LookupPass::follow_view(const method::Frame& frame) {
    const scene::View& view = inputs().view();
    screen_.see(mesh_,
                view,
                {.crease_rad = glm::radians(params_.crease_deg), .most_steps = params_.steps},
                frame.threads);
    if (!coded_) return;
    const scene::DepthSlope px = scene::Projection(view).q_per_px();
    const auto bend = [&](double length_px) {
        const scene::DepthSlope least = length_px * px;
        return CodeRule::Bend{static_cast<float>(least.of_q), static_cast<float>(least.constant)};
    };
    rule_ = {.jump = bend(coded_->jump_px), .flat = bend(kFlat_px), .trust = coded_->trust};
}

raster::SkipCounts LookupMethod::draw_lines(const method::Frame& frame, edge::EdgeImage& out) {
    buffers::EachTile sink([&](const raster::Tile& drawn) {
        if (drawn.is_empty) return buffers::clear_tile(drawn, out);
        const raster::Tile tile = buffers::output_tile(drawn, out.width_px(), out.height_px());
        if (tile.width_px == 0 || tile.height_px == 0) return;
        LineBits lines;
        SideLookup(pass(), params_.samples, tile, nullptr).mark_lines(lines);
        for (int y = 0; y < tile.height_px; ++y)
            write_bits(lines.row(y), tile.width_px, out.row(tile.y0_px + y) + tile.x0_px);
    });
    return pass().draw_lines(frame, sink, out);
}

core::Image<LineKind> LookupMethod::classes(const method::Frame& frame) {
    core::Image<LineKind> image(frame.view.width_px, frame.view.height_px, LineKind::none);
    if (pass().is_empty()) return image;
    buffers::EachTile sink([&](const raster::Tile& drawn) {
        if (drawn.is_empty) return;
        const raster::Tile tile = buffers::output_tile(drawn, image.width_px(), image.height_px());
        if (tile.width_px == 0 || tile.height_px == 0) return;
        LineBits lines;
        SideLookup(pass(), params_.samples, tile, &image).mark_lines(lines);
    });
    (void)pass().draw(frame, false, sink);
    pass().inputs().forget_image();
    return image;
}

std::vector<method::Layer> LookupMethod::layers(const method::Frame& frame) {
    return {{"classes", core::mapped<glm::u8vec3>(classes(frame), color_of)}};
}

}  // namespace ink::methods
