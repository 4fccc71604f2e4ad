// New here: where a side between two samples crosses lines is all that is kept, and chords between
// these crossings are drawn. The second pass asks no mesh.

#include <algorithm>

#include "methods/grey_lines/ink_method.h"
#include "methods/grey_lines/lined_sides.h"

namespace ink::methods {
namespace {

/// A crossing of a side with a line, in eight bytes.
struct ChordEnd {
    std::uint32_t edge = 0;  ///< bits of which edge it is, so that ends of one are joined
    std::uint8_t place = 0;  ///< from the first sample to the second
    std::uint8_t width = 0;  ///< of the widest
};

class Chords : public InkMethod {
  public:
    using Params = InkParams;
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        return add_ink_params(table);
    }
    explicit Chords(const Params& params)
        : InkMethod("chords", params), most_half_px_(static_cast<float>(params.width_px / 2)) {
        for (std::size_t i = 0; i < places_.size(); ++i) {
            places_[i] = static_cast<double>(i) / 255.0;
            halves_px_[i] = most_half_px_ * static_cast<float>(i) / 255;
        }
    }

  private:
    static constexpr std::size_t kMostOfSide = 2;
    static constexpr std::size_t kMostOfCell = 4 * kMostOfSide;
    /// A crossing in the frame.
    struct Crossed {
        glm::dvec2 at;
        float half_px;
        std::uint32_t edge;
    };

    void begin(const raster::TileGrid& samples) override { sides_.reset(samples); }

    void look(const raster::Tile& tile) override {
        const LineWidths widths = this->widths();
        each_lined_side(tile, [&](int x, int y, bool is_down, const SideLines& lines) {
            sides_.add(x, y, is_down, [&](std::vector<ChordEnd>& ends) {
                std::size_t count = 0;
                for (const Crossing& line : lines.all()) {
                    const float half_px = widths.half_px(line.kind, line.q);
                    if (!(half_px > 0) || ++count > kMostOfSide) continue;
                    ends.emplace_back(name_of(line), byte(line.s), byte(half_px / most_half_px_));
                }
            });
        });
    }

    [[nodiscard]] static std::uint8_t byte(double share) {
        return static_cast<std::uint8_t>(255 * std::clamp(share, 0.0, 1.0) + 0.5);
    }

    /// Of an edge not 0, whichever of its faces the line is of; 0 of what has no edge.
    [[nodiscard]] std::uint32_t name_of(const Crossing& line) const {
        if (line.edge >= Crossing::kIntersection) return 0;
        const auto& v = pass().screen().mesh().faces[line.face].vertices;
        const auto [a, b] = std::minmax(v[line.edge], v[(line.edge + 1U) % 3]);
        std::uint64_t bits = (std::uint64_t{a} << 32 | b) * 0x9e3779b97f4a7c15U;
        bits = (bits ^ bits >> 32) * 0xbf58476d1ce4e5b9U;
        return static_cast<std::uint32_t>(bits >> 32) | 1;
    }

    void join(std::size_t tile, std::vector<Piece>& pieces) override {
        sides_.each_cell(tile, [&](int x, int y) {
            std::array<Crossed, kMostOfCell> crossed;
            std::size_t count = 0;
            const auto add = [&](int dx, int dy, bool is_down) {
                for (const ChordEnd& end : sides_.at(x + dx, y + dy, is_down)) {
                    const double s = places_[end.place];
                    crossed[count++] = {
                        .at = {x + dx + (is_down ? 0 : s), y + dy + (is_down ? s : 0)},
                        .half_px = halves_px_[end.width],
                        .edge = end.edge};
                }
            };
            add(0, 0, false);
            add(1, 0, true);
            add(0, 1, false);
            add(0, 0, true);
            join_cell({x + 0.5, y + 0.5}, std::span(crossed).first(count), pieces);
        });
    }

    static void add_chord(const Crossed& from, const Crossed& to, std::vector<Piece>& pieces) {
        pieces.emplace_back(from.at, to.at, from.half_px, to.half_px);
    }

    /// Ends of one edge are joined; of others two by a straight line, more over their middle.
    static void join_cell(const glm::dvec2& middle,
                          std::span<Crossed> crossed,
                          std::vector<Piece>& pieces) {
        if (crossed.size() == 2) return add_chord(crossed[0], crossed[1], pieces);
        std::size_t left = 0;
        for (std::size_t i = 0; i < crossed.size(); ++i) {
            const auto known =
                std::find_if(crossed.begin(),
                             crossed.begin() + static_cast<std::ptrdiff_t>(left),
                             [&](const Crossed& other) {
                                 return other.edge != 0 && other.edge == crossed[i].edge;
                             });
            if (known == crossed.begin() + static_cast<std::ptrdiff_t>(left)) {
                crossed[left++] = crossed[i];
                continue;
            }
            add_chord(*known, crossed[i], pieces);
            std::copy(known + 1, crossed.begin() + static_cast<std::ptrdiff_t>(left), known);
            --left;
        }
        const std::span<Crossed> rest = crossed.first(left);
        if (rest.size() == 2) return add_chord(rest[0], rest[1], pieces);
        Crossed star{.at = rest.size() == 1 ? middle : glm::dvec2(0), .half_px = 0, .edge = 0};
        for (const Crossed& end : rest) {
            if (rest.size() > 1) star.at += end.at / static_cast<double>(rest.size());
        }
        for (const Crossed& end : rest) {
            star.half_px = end.half_px;
            add_chord(end, star, pieces);
        }
    }

    float most_half_px_;
    std::array<double, 256> places_;    ///< of a byte
    std::array<float, 256> halves_px_;  ///< likewise
    LinedSides<ChordEnd> sides_;
};

}  // namespace

method::MethodInfo chords_method() {
    return method::method_info<Chords>("chords");
}

}  // namespace ink::methods
