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
    explicit Strokes(const Params& params) : InkMethod("strokes", params) {}

  private:
    void begin(const raster::TileGrid& samples) override {
        sides_.reset(samples);
        faces_.reset(samples);
    }
    void look(const raster::Tile& tile) override {
        faces_.take(tile);
        each_lined_side(tile, [&](int x, int y, bool is_down, const SideLines& lines) {
            sides_.add(x, y, is_down, [&](std::vector<NamedCrossing>& named) {
                for (const Crossing& line : lines.all())
                    named.push_back({name_of(line, pass().screen()), line});
            });
        });
    }
    void join(std::size_t tile, std::vector<Piece>& pieces) override {
        const StrokeFrame frame{pass().screen(), sides_, faces_, widths()};
        std::optional<CellStrokes> strokes;  // most tiles are empty
        sides_.each_cell(tile, [&](int x, int y) {
            if (!strokes) strokes.emplace(frame, pieces);
            strokes->draw({x, y});
        });
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
