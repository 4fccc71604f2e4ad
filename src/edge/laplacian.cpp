#include "edge/laplacian.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <type_traits>

namespace ink::edge {
namespace {

/// A response with its shifts worked out. `Int` holds every Laplacian of the buffer: 16 bits are
/// enough for bytes and double the lanes of a vector register.
template <class Int>
struct Shifts {
    Int keep;    ///< mask: what is not clipped
    Int modulo;  ///< mask: 2^code_bits - 1
    int left;
    int right;
    int sign;  ///< shift up and down again that reads a wrapped code's L as signed
    Int cap;   ///< the largest value that does not pass 255 when shifted left

    explicit Shifts(const LaplacianResponse& r)
        : keep(static_cast<Int>(~((1 << r.clip_bits) - 1))),
          modulo(static_cast<Int>((1 << r.code_bits) - 1)),
          left(std::max(r.scale_bits, 0)),
          right(std::max(-r.scale_bits, 0)),
          sign(std::numeric_limits<Int>::digits + 1 - r.code_bits),
          cap(static_cast<Int>(255 >> left)) {
        assert(r.clip_bits >= 0 && r.clip_bits <= 15);
        assert(r.scale_bits >= -15 && r.scale_bits <= 15);
        assert(r.code_bits >= 1 && r.code_bits <= 16);
    }
};

template <class Int>
inline Int shift_up(Int value, int by) {
    using Bits = std::make_unsigned_t<Int>;
    return static_cast<Int>(static_cast<Bits>(static_cast<Bits>(value) << by));
}

template <Response kResponse, bool kWraps, class Int>
inline std::uint8_t strength(Int laplacian, const Shifts<Int>& s) {
    if constexpr (kResponse == Response::wrap) {
        const Int v = static_cast<Int>(laplacian & s.modulo & s.keep);
        return static_cast<std::uint8_t>(shift_up(static_cast<Int>(v >> s.right), s.left));
    } else {
        if constexpr (kWraps) {
            laplacian = static_cast<Int>(shift_up(laplacian, s.sign) >> s.sign);
        }
        Int v = kResponse == Response::absolute && laplacian < 0 ? static_cast<Int>(-laplacian)
                                                                 : laplacian;
        v = static_cast<Int>((std::max(v, Int{0}) & s.keep) >> s.right);
        return v > s.cap ? std::uint8_t{255} : static_cast<std::uint8_t>(v << s.left);
    }
}

template <class T>
using Wide = std::conditional_t<sizeof(T) == 1, std::int16_t, std::int32_t>;

template <class T>
struct Rows {
    const T* up;
    const T* mid;
    const T* down;
};

template <Response kResponse, bool kWraps, class T>
void filter(const Rows<T>& in, std::uint8_t* out, int width, const LaplacianResponse& response) {
    using Int = Wide<T>;
    const Shifts<Int> shifts(response);
    // Local copies that cannot alias `out`, or nothing would be vectorised.
    const T* __restrict up = in.up;
    const T* __restrict mid = in.mid;
    const T* __restrict down = in.down;
    std::uint8_t* __restrict to = out;
    for (int x = 0; x < width; ++x) {
        const int laplacian = 4 * mid[x] - up[x] - down[x] - mid[x - 1] - mid[x + 1];
        to[x] = strength<kResponse, kWraps>(static_cast<Int>(laplacian), shifts);
    }
}

template <class T>
void dispatch(const Rows<T>& in, std::uint8_t* out, int width, const LaplacianResponse& r) {
    assert(r.code_bits <= 8 * static_cast<int>(sizeof(T)));
    switch (r.response) {
        case Response::absolute:
            return r.code_wraps ? filter<Response::absolute, true>(in, out, width, r)
                                : filter<Response::absolute, false>(in, out, width, r);
        case Response::positive:
            return r.code_wraps ? filter<Response::positive, true>(in, out, width, r)
                                : filter<Response::positive, false>(in, out, width, r);
        case Response::wrap:
            return filter<Response::wrap, false>(in, out, width, r);
    }
}

}  // namespace

std::uint8_t respond(int laplacian, const LaplacianResponse& r) {
    const Shifts<int> shifts(r);
    switch (r.response) {
        case Response::absolute:
            return r.code_wraps ? strength<Response::absolute, true>(laplacian, shifts)
                                : strength<Response::absolute, false>(laplacian, shifts);
        case Response::positive:
            return r.code_wraps ? strength<Response::positive, true>(laplacian, shifts)
                                : strength<Response::positive, false>(laplacian, shifts);
        case Response::wrap:
            break;
    }
    return strength<Response::wrap, false>(laplacian, shifts);
}

void laplacian_row(const std::uint8_t* up,
                   const std::uint8_t* mid,
                   const std::uint8_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response) {
    dispatch<std::uint8_t>({up, mid, down}, out, width, response);
}

void laplacian_row(const std::uint16_t* up,
                   const std::uint16_t* mid,
                   const std::uint16_t* down,
                   std::uint8_t* out,
                   int width,
                   const LaplacianResponse& response) {
    dispatch<std::uint16_t>({up, mid, down}, out, width, response);
}

}  // namespace ink::edge
