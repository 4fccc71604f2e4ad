#include "methods/id_lookup/id_lookup.h"

#include <algorithm>
#include <array>
#include <glm/trigonometric.hpp>
#include <utility>

#include "buffers/packed_sink.h"
#include "buffers/sample_grid.h"

namespace ink::methods {
namespace {

buffers::InputParams input_params(const IdLookup::Params& params) {
    buffers::InputParams inputs;
    inputs.normals = scene::NormalSource::patch;  // not read; corners stay shared
    inputs.crease_deg = params.crease_deg;
    inputs.depth_format = params.depth_format;
    inputs.samples = params.samples;
    return inputs;
}

raster::PassFormat pass_format(const IdLookup::Params& params) {
    raster::PassFormat format;
    format.constant = true;
    format.store = raster::Store::u32;
    format.depth = params.depth_format;
    format.halo_px = 1;
    return format;
}

/// The classes of a tile's own pixels, and of a pixel more on every side, which nobody reads.
class TileKinds {
  public:
    [[nodiscard]] LineKind* row(int y) { return kinds_.data() + (y + 1) * kSpan + 1; }
    void clear(int rows) {
        std::fill_n(kinds_.begin(), static_cast<std::size_t>(rows + 2) * kSpan, LineKind::none);
    }
    /// A pixel that two lines run through shows that of the lower number.
    void mark(int x, int y, LineKind kind) {
        LineKind& at = row(y)[x];
        if (at == LineKind::none || kind < at) at = kind;
    }

  private:
    static constexpr int kSpan = raster::kTileSize_px + 2;
    std::array<LineKind, static_cast<std::size_t>(kSpan) * kSpan> kinds_;
};

/// Looks up the sides between samples that differ and marks the pixels of their lines.
class SideLookup {
  public:
    SideLookup(const ScreenMesh& screen, buffers::Samples samples, const raster::Tile& tile)
        : screen_(screen), has_corners_(samples == buffers::Samples::corner), tile_(tile) {}

    /// False if no sample differs from another: then `kinds` holds nothing of use.
    bool look_up(TileKinds& kinds) const {
        // Of corners the tile's own and those right of and below them; of centres those on all
        // four sides.
        const int first = has_corners_ ? 0 : -1;
        bool is_clear = false;
        for (int y = first; y <= tile_.height_px; ++y) {
            const auto* row = tile_.row<std::uint32_t>(0, y);
            const bool has_below = y < tile_.height_px;
            const auto* below = has_below ? tile_.row<std::uint32_t>(0, y + 1) : row;
            if (!differs(row, below, first)) continue;
            if (!is_clear) kinds.clear(tile_.height_px);
            is_clear = true;
            for (int x = first; x <= tile_.width_px; ++x) {
                const bool has_right = x < tile_.width_px;
                if (has_right && row[x] != row[x + 1]) mark(kinds, x, y, false, row[x], row[x + 1]);
                if (has_below && row[x] != below[x]) mark(kinds, x, y, true, row[x], below[x]);
            }
        }
        return is_clear;
    }

  private:
    [[nodiscard]] bool differs(const std::uint32_t* row,
                               const std::uint32_t* below,
                               int first) const {
        std::uint32_t all = 0;
        for (int x = first; x < tile_.width_px; ++x)
            all |= (row[x] ^ row[x + 1]) | (row[x] ^ below[x]);
        return (all | (row[tile_.width_px] ^ below[tile_.width_px])) != 0;
    }

    void mark(TileKinds& kinds,
              int x,
              int y,
              bool is_down,
              std::uint32_t first,
              std::uint32_t second) const {
        const FoundLine line =
            screen_.line_between({tile_.x0_px + x, tile_.y0_px + y, is_down, first, second});
        if (line.kind == LineKind::none) return;
        if (has_corners_) {  // the side of two pixels
            kinds.mark(x, y, line.kind);
            kinds.mark(is_down ? x - 1 : x, is_down ? y : y - 1, line.kind);
        } else {
            const int step = line.s < 0.5 ? 0 : 1;
            kinds.mark(is_down ? x : x + step, is_down ? y + step : y, line.kind);
        }
    }

    const ScreenMesh& screen_;
    bool has_corners_;
    const raster::Tile& tile_;
};

/// Hands each row of each tile to `write(tile, y, kinds)`; see IdLookup::draw_classes.
template <class Write>
class LookupSink : public raster::TileSink {
  public:
    LookupSink(const ScreenMesh& screen,
               buffers::Samples samples,
               std::pair<int, int> size_px,
               Write write)
        : screen_(screen), samples_(samples), size_px_(size_px), write_(std::move(write)) {}

    void finish(const raster::Tile& drawn) override {
        const raster::Tile tile = buffers::output_tile(drawn, size_px_.first, size_px_.second);
        if (tile.width_px == 0 || tile.height_px == 0) return;
        TileKinds kinds;
        const bool has_lines = !tile.is_empty && SideLookup(screen_, samples_, tile).look_up(kinds);
        for (int y = 0; y < tile.height_px; ++y)
            write_(tile, y, has_lines ? kinds.row(y) : nullptr);
    }

  private:
    const ScreenMesh& screen_;
    buffers::Samples samples_;
    std::pair<int, int> size_px_;
    Write write_;
};

/// As pictures of the truth have them.
glm::u8vec3 color_of(LineKind kind) {
    switch (kind) {
        case LineKind::none:
            break;
        case LineKind::contour:
            return {32, 36, 42};
        case LineKind::boundary:
            return {204, 121, 167};
        case LineKind::crease:
            return {0, 158, 115};
        case LineKind::intersection:
            return {230, 159, 0};
        case LineKind::seam:
            return {86, 180, 233};
    }
    return {255, 255, 255};
}

/// From the fastest to the most exact, the method as it comes among them.
std::vector<core::ParamValues> sweep() {
    return {
        // Neighbours alone are looked up; what is farther is a line.
        {{"steps", "1"}},
        {{"steps", "4"}},
        // Half the bytes of the depth test.
        {{"depth_format", "z16"}},
        // Blunter creases only, and sharper ones too.
        {{"crease_deg", "60"}},
        {{"crease_deg", "20"}},
        // No cracks closed.
        {{"weld_epsilon", "0"}},
        // The line in either of two pixels.
        {{"samples", "centre"}},
        {},
    };
}

}  // namespace

core::ParamTable<IdLookup::Params> IdLookup::table() {
    core::ParamTable<Params> table;
    table
        .number(&Params::crease_deg,
                "crease_deg",
                {0, 180},
                "deg",
                "Least dihedral deviation of an edge that is a crease.")
        .number(&Params::weld_epsilon,
                "weld_epsilon",
                {0, 0.01},
                "",
                "Boundaries of an object this near meet, as a share of its diagonal.")
        .number(&Params::steps,
                "steps",
                {1, 1000},
                "",
                "Most triangles crossed from one sample to the next before it gives up.");
    return buffers::add_samples_param(table)
        .choice(&Params::depth_format,
                "depth_format",
                {"q32", "z24", "z16"},
                "Format of the depth test.")
        .number(&Params::threshold,
                "threshold",
                {1, 255},
                "",
                "Least edge response of a line pixel; it draws only 0 and 255.");
}

IdLookup::IdLookup(const Params& params)
    : params_(params), format_(pass_format(params)), inputs_(input_params(params)) {}

void IdLookup::look_up(const scene::Scene& scene) {
    std::vector<std::uint32_t> before = std::move(mesh_.face_of_triangle);
    mesh_ = make_lookup_mesh(
        scene,
        {.crease_rad = glm::radians(params_.crease_deg), .weld_epsilon = params_.weld_epsilon});
    have_ids_changed_ = have_ids_changed_ || before != mesh_.face_of_triangle;
    posed_hash_ = scene::scene_hash(scene);
}

void IdLookup::prepare(const scene::Scene& scene) {
    inputs_.prepare(scene);
    look_up(scene);
    have_ids_changed_ = true;
}

void IdLookup::pose(const scene::Scene& scene) {
    inputs_.pose(scene);
    // What meets, and which edges crease, may change with the pose.
    if (scene::scene_hash(scene) != posed_hash_) look_up(scene);
}

template <class Write>
raster::MeshResult IdLookup::draw_classes(const method::Frame& frame,
                                          bool may_keep_still,
                                          std::pair<int, int> size_px,
                                          Write write) {
    inputs_.see(frame);
    screen_.see(mesh_,
                inputs_.view(),
                {.crease_rad = glm::radians(params_.crease_deg), .most_steps = params_.steps},
                frame.threads);
    LookupSink sink(screen_, params_.samples, size_px, std::move(write));
    raster::MeshInput input = inputs_.mesh_input(frame);
    input.constants = mesh_.face_of_triangle;
    input.sky_code = {kNoNeighbour};
    input.may_keep_still = input.may_keep_still && may_keep_still;
    if (have_ids_changed_ || !may_keep_still) input.moved_objects = std::nullopt;
    have_ids_changed_ = false;
    return pass_.draw(format_, input, sink);
}

void IdLookup::draw(const method::Frame& frame, edge::EdgeImage& out) {
    skip_counts_ = {};
    if (inputs_.is_empty()) return out.fill(0);
    const auto write = [&](const raster::Tile& tile, int y, const LineKind* kinds) {
        std::uint8_t* to = out.row(tile.y0_px + y) + tile.x0_px;
        if (kinds == nullptr) {
            std::fill_n(to, tile.width_px, std::uint8_t{0});
            return;
        }
        for (int x = 0; x < tile.width_px; ++x)
            to[x] = kinds[x] == LineKind::none ? 0 : 255;
    };
    const raster::MeshResult result =
        draw_classes(frame, true, {out.width_px(), out.height_px()}, write);
    inputs_.finish(result, out);
    skip_counts_ = result.skips;
}

core::Image<LineKind> IdLookup::classes(const method::Frame& frame) {
    core::Image<LineKind> image(frame.view.width_px, frame.view.height_px, LineKind::none);
    if (inputs_.is_empty()) return image;
    const auto write = [&](const raster::Tile& tile, int y, const LineKind* kinds) {
        if (kinds == nullptr) return;
        std::copy_n(kinds, tile.width_px, image.row(tile.y0_px + y) + tile.x0_px);
    };
    (void)draw_classes(frame, false, {image.width_px(), image.height_px()}, write);
    inputs_.forget_image();
    return image;
}

std::vector<method::Layer> IdLookup::layers(const method::Frame& frame) {
    const core::Image<LineKind> kinds = classes(frame);
    method::Layer layer{"classes", {kinds.width_px(), kinds.height_px()}};
    std::transform(kinds.data(), kinds.data() + kinds.size(), layer.rgb.data(), color_of);
    return {std::move(layer)};
}

method::Cost IdLookup::cost() const {
    method::Cost cost;
    cost.passes = 1;
    cost.values_per_vertex = 0;
    cost.buffer_bytes_per_px = format_.bytes_per_px();
    cost.fill = method::fill_work(format_);
    // Two comparisons, joined; walks are few, and depend on the scene.
    cost.filter = {sizeof(std::uint32_t), 1, 2 + 2};
    return cost;
}

method::MethodInfo id_lookup() {
    method::MethodInfo info = method::method_info<IdLookup>(
        "id_lookup",
        "new here; after item buffers (Weghorst, Hooper and Greenberg 1984) and the exact classes "
        "of the truth",
        "triangle ids, and the line between two that differ looked up in the mesh, with its class");
    info.family = method::Family::ids;
    info.marker = method::Marker::up;
    info.sweep = sweep();
    return info;
}

}  // namespace ink::methods
