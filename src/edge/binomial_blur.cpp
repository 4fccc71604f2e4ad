#include "edge/binomial_blur.h"

#include <cassert>

namespace ink::edge {
namespace {

template <class T>
struct Rows {
    const T* up;
    const T* mid;
    const T* down;
};

template <class T>
void blur_plain(const Rows<T>& in, T* __restrict out, int width) {
    for (int x = 0; x < width; ++x) {
        const int corners = in.up[x - 1] + in.up[x + 1] + in.down[x - 1] + in.down[x + 1];
        const int sides = in.up[x] + in.down[x] + in.mid[x - 1] + in.mid[x + 1];
        out[x] = static_cast<T>((corners + 2 * sides + 4 * in.mid[x] + 8) >> 4);
    }
}

template <class T>
void blur_wrapped(const Rows<T>& in, T* __restrict out, int width, int code_bits) {
    const int sign = 32 - code_bits;
    const auto mask = static_cast<std::uint32_t>((std::uint64_t{1} << code_bits) - 1);
    for (int x = 0; x < width; ++x) {
        const int center = in.mid[x];
        const auto way = [&](int neighbour) {
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(neighbour - center)
                                             << sign) >>
                   sign;
        };
        const int corners =
            way(in.up[x - 1]) + way(in.up[x + 1]) + way(in.down[x - 1]) + way(in.down[x + 1]);
        const int sides = way(in.up[x]) + way(in.down[x]) + way(in.mid[x - 1]) + way(in.mid[x + 1]);
        const int blurred = center + ((corners + 2 * sides + 8) >> 4);
        out[x] = static_cast<T>(static_cast<std::uint32_t>(blurred) & mask);
    }
}

template <class T>
void blur(const Rows<T>& in, T* out, int width, int code_bits) {
    assert(code_bits >= 0 && code_bits <= 8 * static_cast<int>(sizeof(T)));
    return code_bits == 0 ? blur_plain(in, out, width) : blur_wrapped(in, out, width, code_bits);
}

}  // namespace

void binomial_blur_row(const std::uint8_t* up,
                       const std::uint8_t* mid,
                       const std::uint8_t* down,
                       std::uint8_t* out,
                       int width,
                       int code_bits) {
    blur<std::uint8_t>({up, mid, down}, out, width, code_bits);
}

void binomial_blur_row(const std::uint16_t* up,
                       const std::uint16_t* mid,
                       const std::uint16_t* down,
                       std::uint16_t* out,
                       int width,
                       int code_bits) {
    blur<std::uint16_t>({up, mid, down}, out, width, code_bits);
}

}  // namespace ink::edge
