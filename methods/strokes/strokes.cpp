// New here: the mesh edges behind the samples of surface_lookup, clipped to cells, followed where
// no sample tells of them, and drawn by a round pen.

#include "methods/grey_lines/ink_method.h"
#include "methods/strokes/cell_strokes.h"

namespace ink::methods {
namespace {

class Strokes : public InkMethod {
  public:
    using Params = InkParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        return add_ink_params(table);
    }
    explicit Strokes(const Params& params) : InkMethod(params) {}

  private:
    void begin(int width_px, int height_px) override {
        sides_.reset(width_px, height_px);
        faces_.reset(width_px, height_px);
    }
    void look(const raster::Tile& tile) override {
        faces_.take(tile);
        each_lined_side(tile, [&](int x, int y, bool is_down, const SideLines& lines) {
            std::array<NamedCrossing, std::tuple_size_v<decltype(lines.crossings)>> named;
            for (std::size_t i = 0; i < lines.count; ++i)
                named[i] = {name_of(lines.crossings[i], pass().screen()), lines.crossings[i]};
            sides_.add(x, y, is_down, std::span(named).first(lines.count));
        });
    }
    void join(std::size_t tile, std::vector<Piece>& pieces) override {
        const StrokeFrame frame{pass().screen(), sides_, faces_, widths()};
        CellStrokes strokes(frame, pieces);
        sides_.each_cell(tile, [&](int x, int y) { strokes.draw({x, y}); });
    }

    /// The words are kept.
    [[nodiscard]] method::PixelBytes filter_bytes() const override { return {8, 5}; }

    LinedSides<NamedCrossing> sides_;
    SampleFaces faces_;
};

}  // namespace

method::MethodInfo strokes_method() {
    return method::method_info<Strokes>("strokes");
}

}  // namespace ink::methods
