// New here: where a side between two samples crosses lines is all that is kept, and chords between
// these crossings are drawn. The second pass asks no mesh.

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "methods/grey_lines/ink_method.h"
#include "methods/grey_lines/lined_sides.h"

namespace ink::methods {
namespace {

/// A crossing of a side with a line, in eight bytes.
struct ChordEnd {
    std::uint32_t edge = 0;  ///< bits of which edge it is, so that ends of one are joined
    std::uint8_t place = 0;  ///< from the first sample to the second
    std::uint8_t width = 0;  ///< of the widest

    ChordEnd(std::uint32_t of_edge, std::uint8_t at, std::uint8_t share)
        : edge(of_edge), place(at), width(share) {}
};

struct ChordParams : InkParams {
    /// Lines of a bundle are drawn as one, as often as they are true as one. From the catalogue.
    ChordParams() { threshold = 110; }
};

class Chords : public InkMethod {
  public:
    using Params = ChordParams;
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
    static constexpr std::uint8_t kMostBetween = 104;   ///< 0.41
    static constexpr std::uint8_t kLeastOfSpike = 115;  ///< 0.45
    /// A crossing in the frame.
    struct Crossed {
        glm::dvec2 at{0};
        float half_px = 0;
        std::uint32_t edge = 0;
    };

    void begin(const raster::TileGrid& samples) override {
        sides_.reset(samples);
        spikes_.resize(sides_.tiles());
    }

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
        spikes_[tile].clear();
        sides_.each_cell(tile, [&](int x, int y) {
            std::array<Crossed, kMostOfCell> crossed;
            std::size_t count = 0, most_of_side = 0;
            const auto add = [&](int dx, int dy, bool is_down) {
                const auto ends = sides_.at(x + dx, y + dy, is_down);
                most_of_side = std::max(most_of_side, ends.size());
                for (const ChordEnd& end : ends) {
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
            if (count == most_of_side) spikes_[tile].emplace_back(x, y);
            join_cell({x + 0.5, y + 0.5}, std::span(crossed).first(count), pieces);
        });
    }

    static void add_chord(const Crossed& from, const Crossed& to, std::vector<Piece>& pieces) {
        pieces.emplace_back(from.at, to.at, from.half_px, to.half_px);
    }

    /// Ends of one edge are joined; of others two by a straight line, more over their middle. One
    /// that is left ends at what hides it, the nearest chord, and without one halfway across.
    static void join_cell(const glm::dvec2& middle,
                          std::span<Crossed> crossed,
                          std::vector<Piece>& pieces) {
        if (crossed.size() == 2) return add_chord(crossed[0], crossed[1], pieces);
        const std::size_t before = pieces.size();
        const std::span<Crossed> rest = join_edges(crossed, pieces);
        if (rest.size() == 2) return add_chord(rest[0], rest[1], pieces);
        Crossed star;
        if (rest.size() == 1) {
            const std::span chords = std::span(pieces).subspan(before);
            star.at = chords.empty() ? halfway(rest[0].at, middle) : nearest(rest[0].at, chords);
        } else {
            for (const Crossed& end : rest)
                star.at += end.at / static_cast<double>(rest.size());
        }
        for (const Crossed& end : rest) {
            star.half_px = end.half_px;
            add_chord(end, star, pieces);
        }
    }

    /// Joins ends of one edge, and returns those that are left.
    static std::span<Crossed> join_edges(std::span<Crossed> crossed, std::vector<Piece>& pieces) {
        std::size_t left = 0;
        for (std::size_t i = 0; i < crossed.size(); ++i) {
            const auto end = crossed.begin() + static_cast<std::ptrdiff_t>(left);
            const auto known = std::find_if(crossed.begin(), end, [&](const Crossed& other) {
                return other.edge != 0 && other.edge == crossed[i].edge;
            });
            if (known == end) {
                crossed[left++] = crossed[i];
                continue;
            }
            add_chord(*known, crossed[i], pieces);
            std::copy(known + 1, end, known);
            --left;
        }
        return crossed.first(left);
    }

    /// From a side straight on, as far as the middle of the cell.
    static glm::dvec2 halfway(const glm::dvec2& from, const glm::dvec2& middle) {
        const glm::dvec2 way = glm::abs(middle - from);
        return way.x > way.y ? glm::dvec2(middle.x, from.y) : glm::dvec2(from.x, middle.y);
    }

    static glm::dvec2 nearest(const glm::dvec2& from, std::span<const Piece> chords) {
        glm::dvec2 best = chords.front().a;
        for (const Piece& chord : chords) {
            const glm::dvec2 along = chord.b - chord.a;
            const double t =
                glm::dot(from - chord.a, along) / std::max(glm::dot(along, along), 1e-12);
            const glm::dvec2 at = chord.a + std::clamp(t, 0.0, 1.0) * along;
            if (glm::distance(at, from) < glm::distance(best, from)) best = at;
        }
        return best;
    }

    /// Of lines of one pixel. Two that are less than two apart are to stay two at half: ink is less
    /// of a pixel between them. A spike is shorter than its samples tell, and is to stay at half.
    void touch_up(int margin_px, int threads, edge::EdgeImage& out) override {
        if (most_half_px_ > 0.5F) return;
        const auto keep = [&](int x, int y, std::uint8_t least, std::uint8_t most) {
            if (!out.contains(x - margin_px, y - margin_px)) return;
            std::uint8_t& ink = out.at(x - margin_px, y - margin_px);
            ink = std::clamp(ink, least, most);
        };
        core::parallel_for(sides_.tiles(), threads, [&](std::size_t tile) {
            sides_.each_between(tile, [&](int x, int y) { keep(x, y, 0, kMostBetween); });
            for (const glm::ivec2& cell : spikes_[tile])
                keep(cell.x, cell.y, kLeastOfSpike, 255);
        });
    }

    float most_half_px_;
    std::array<double, 256> places_;    ///< of a byte
    std::array<float, 256> halves_px_;  ///< likewise
    LinedSides<ChordEnd> sides_;
    std::vector<std::vector<glm::ivec2>> spikes_;  ///< by tile, cells crossed on one side alone
};

}  // namespace

method::MethodInfo chords_method() {
    return method::method_info<Chords>("chords");
}

}  // namespace ink::methods
