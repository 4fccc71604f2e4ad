#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "methods/mesh_lookup/side_lists_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "edge/vector_loops.inl"
#include "methods/mesh_lookup/side_lists.h"

HWY_BEFORE_NAMESPACE();
namespace ink::methods::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kLanes = std::min<int>(16, HWY_LANES(std::uint32_t));

/// Sides of one row whose samples differ, both of them faces.
struct RowSides {
    static constexpr std::size_t kMost = 2 * SideList::kSpan + 16;

    std::array<std::uint32_t, kMost> first;
    std::array<std::uint32_t, kMost> second;
    std::array<std::uint32_t, kMost> places;
    std::size_t count = 0;
};

template <class D, class M>
HWY_INLINE std::uint64_t bits_of(D d, M mask) {
    std::array<std::uint8_t, 8> bytes{};
    hn::StoreMaskBits(d, mask, bytes.data());
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes.data(), sizeof bits);
    return bits;
}

/// Sides from samples `a` to samples `b`: those in `doubtful` are to be looked up, those in `sure`
/// are lines. `q` is 1/w at a, `step` away at b.
template <class D, class V, class M>
HWY_INLINE void judge(D d,
                      const CodeRule& rule,
                      V a,
                      V b,
                      const float* q,
                      std::ptrdiff_t step,
                      M& doubtful,
                      M& sure) {
    const hn::RebindToSigned<D> d_code;
    const hn::RebindToFloat<D> d_q;
    const auto code = [&](V words) HWY_ATTR {
        return hn::BitCast(d_code, hn::ShiftRight<LookupWord::kCodeShift>(words));
    };
    const auto apart = hn::Abs(hn::Sub(code(a), code(b)));
    const auto is_flagged = hn::TestBit(hn::Or(a, b), hn::Set(d, LookupWord::kFlag));
    const auto before = hn::LoadU(d_q, q - step), at_a = hn::LoadU(d_q, q);
    const auto at_b = hn::LoadU(d_q, q + step), after = hn::LoadU(d_q, q + 2 * step);
    const auto jump = hn::Sub(at_b, at_a);
    const auto bend_a = hn::Abs(hn::Sub(jump, hn::Sub(at_a, before)));
    const auto bend_b = hn::Abs(hn::Sub(jump, hn::Sub(after, at_b)));
    const auto nearest = hn::Max(at_a, at_b);
    const auto bends = [&](auto bend, const CodeRule::Bend& least) HWY_ATTR {
        const auto of_q = hn::Mul(hn::Set(d_q, least.of_q), nearest);
        return hn::RebindMask(d, hn::Gt(bend, hn::Add(of_q, hn::Set(d_q, least.constant))));
    };
    const auto at_least = [&](int difference) HWY_ATTR {
        return hn::RebindMask(d, hn::Gt(apart, hn::Set(d_code, difference - 1)));
    };
    const auto is_trusted = hn::AndNot(
        is_flagged, hn::And(at_least(rule.trust), bends(hn::Max(bend_a, bend_b), rule.flat)));
    sure = hn::And(doubtful, is_trusted);
    const auto asks =
        hn::Or(hn::Or(at_least(2), is_flagged), bends(hn::Min(bend_a, bend_b), rule.jump));
    doubtful = hn::And(doubtful, hn::AndNot(is_trusted, asks));
}

/// Writes the lanes of a mask to `to`, which has room for a vector; returns how many. Packed in a
/// register first: some processors take a hundred cycles to compress to memory.
template <class D, class V, class M>
HWY_INLINE std::size_t pack(D d, M mask, V lanes, std::uint32_t* to) {
    hn::StoreU(hn::Compress(lanes, mask), d, to);
    return hn::CountTrue(d, mask);
}

/// Appends the sides of a mask to a list.
template <class D, class V, class M>
HWY_INLINE void append(D d, M mask, V first, V second, V places, RowSides& row) {
    pack(d, mask, first, row.first.data() + row.count);
    pack(d, mask, second, row.second.data() + row.count);
    row.count += pack(d, mask, places, row.places.data() + row.count);
}

/// Moves a row's sides to the list, but for those over an edge that is no line from here.
HWY_INLINE void keep_others(const WordTile& words, const RowSides& row, SideList& list) {
    constexpr std::uint32_t kSame = Twin::kFace | Twin::kClosed;
    for (std::size_t i = 0; i < row.count; ++i) {
        const std::uint32_t first = row.first[i] & words.face_bits;
        const std::uint32_t second = row.second[i] & words.face_bits;
        const int mine = words.facing[first], theirs = words.facing[second];
        bool is_open = false;
        for (const Twin twin : words.faces[first].twins) {
            const bool is_beyond = ((twin.word ^ second << 2) & kSame) == 0;
            is_open |= is_beyond && twin.is_open(mine, theirs);
        }
        list.places[list.count] = row.places[i];
        list.count += is_open ? 0 : 1;
    }
}

/// Lists those of the sides in `bits` at which the near plane may cut a face, and returns the
/// others. Their samples are `first` and `second` on, the place of the first of them is `place`.
HWY_INLINE std::uint64_t list_cut(const WordTile& words,
                                  std::uint64_t bits,
                                  const std::uint32_t* first,
                                  const std::uint32_t* second,
                                  std::uint32_t place,
                                  SideList& list) {
    if (words.is_cut.empty()) return bits;
    const auto is_cut = [&](std::uint32_t word) {
        return word != kNoNeighbour && words.is_cut[word & words.face_bits] != 0;
    };
    std::uint64_t others = bits;
    for (std::uint64_t rest = bits; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        if (!is_cut(first[i]) && !is_cut(second[i])) continue;
        others &= ~(std::uint64_t{1} << i);
        list.places[list.count++] = place + (static_cast<std::uint32_t>(i) << 1);
    }
    return others;
}

void list_in(const WordTile& words, const CodeRule* rule, LineBits* lines, SideList& list) {
    const raster::Tile& tile = words.tile;
    const bool lists_all = rule == nullptr || lines == nullptr;
    const int first = words.has_corners ? 0 : -1;
    for (int y = first; y <= tile.height_px; ++y) {
        const bool has_below = y < tile.height_px;
        const auto* const here = tile.row<std::uint32_t>(0, y);
        const auto* const below = has_below ? here + tile.stride : here;
        const float* const q = rule == nullptr ? nullptr : tile.depth_row<float>(y);
        RowSides row;
        edge::HWY_NAMESPACE::cover_once<std::uint32_t, kLanes>(
            tile.width_px + 1,
            [&](auto d, int x) HWY_ATTR {
                const auto a = hn::LoadU(d, here + x);
                const auto b = hn::LoadU(d, here + x + 1);
                const auto c = hn::LoadU(d, below + x);
                const auto in_row = hn::FirstN(d, static_cast<std::size_t>(tile.width_px - x));
                auto right = hn::And(hn::Ne(a, b), in_row);
                auto down = hn::Ne(a, c);
                if (hn::AllFalse(d, hn::Or(right, down))) return;
                const auto sky = hn::Set(d, kNoNeighbour);
                const auto from_sky = hn::Eq(a, sky);
                auto sky_right = hn::And(right, hn::Or(from_sky, hn::Eq(b, sky)));
                auto sky_down = hn::And(down, hn::Or(from_sky, hn::Eq(c, sky)));
                right = hn::AndNot(sky_right, right);
                down = hn::AndNot(sky_down, down);
                const auto place = static_cast<std::uint32_t>((y + 1) << 8 | (x + 1) << 1);
                const auto places = hn::Add(hn::Set(d, place), hn::ShiftLeft<1>(hn::Iota(d, 0)));
                const auto places_down = hn::Or(places, hn::Set(d, 1U));
                if (rule != nullptr) {
                    auto sure_right = sky_right, sure_down = sky_down;
                    auto more = right;
                    if (!hn::AllFalse(d, right)) {
                        judge(d, *rule, a, b, q + x, 1, right, more);
                        sure_right = hn::Or(sure_right, more);
                    }
                    if (!hn::AllFalse(d, down)) {
                        judge(d, *rule, a, c, q + x, tile.stride, down, more);
                        sure_down = hn::Or(sure_down, more);
                    }
                    if (lists_all) {
                        right = hn::Or(right, hn::AndNot(sky_right, sure_right));
                        down = hn::Or(down, hn::AndNot(sky_down, sure_down));
                    } else if (!hn::AllFalse(d, hn::Or(sure_right, sure_down))) {
                        const auto others = [&](auto sure, const auto* second, unsigned is_down)
                                                HWY_ATTR {
                                                    return list_cut(words,
                                                                    bits_of(d, sure),
                                                                    here + x,
                                                                    second + x,
                                                                    place | is_down,
                                                                    list);
                                                };
                        lines->set_right(x, y, others(sure_right, here + 1, 0));
                        lines->set_down(x, y, others(sure_down, below, 1));
                    }
                }
                if (lists_all && !hn::AllFalse(d, hn::Or(sky_right, sky_down))) {
                    auto* to = list.places.data();
                    list.count += pack(d, sky_right, places, to + list.count);
                    list.count += pack(d, sky_down, places_down, to + list.count);
                }
                if (hn::AllFalse(d, hn::Or(right, down))) return;
                append(d, right, a, b, places, row);
                append(d, down, a, c, places_down, row);
            },
            first);
        keep_others(words, row, list);
    }
}

void write_in(std::uint64_t bits, int width_px, std::uint8_t* out) {
    edge::HWY_NAMESPACE::cover_once<std::uint8_t, std::min<int>(64, HWY_LANES(std::uint8_t))>(
        width_px, [&](auto d, int x) HWY_ATTR {
            const std::uint64_t rest = bits >> x;
            std::array<std::uint8_t, 8> own{};
            std::memcpy(own.data(), &rest, sizeof rest);
            const auto mask = hn::LoadMaskBits(d, own.data());
            hn::StoreU(hn::IfThenElseZero(mask, hn::Set(d, std::uint8_t{255})), d, out + x);
        });
}

}  // namespace ink::methods::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ink::methods {
namespace {

HWY_EXPORT(list_in);
HWY_EXPORT(write_in);

}  // namespace

void list_sides(const WordTile& words, const CodeRule* rule, LineBits* lines, SideList& list) {
    list.count = 0;
    HWY_DYNAMIC_DISPATCH(list_in)(words, rule, lines, list);
}

void write_bits(std::uint64_t bits, int width_px, std::uint8_t* out) {
    HWY_DYNAMIC_DISPATCH(write_in)(bits, width_px, out);
}

}  // namespace ink::methods
#endif
