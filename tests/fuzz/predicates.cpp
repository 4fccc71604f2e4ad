// Predicates have the sign that whole numbers of any length give.

#include "scene/predicates.h"

#include <array>
#include <cmath>
#include <vector>

#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

/// A whole number of any length: digits of 32 bits, the lowest first, none of the highest 0.
struct Whole {
    std::vector<std::uint32_t> digits;
    bool is_negative = false;

    [[nodiscard]] int sign() const { return digits.empty() ? 0 : is_negative ? -1 : 1; }
};

void trim(Whole& a) {
    while (!a.digits.empty() && a.digits.back() == 0)
        a.digits.pop_back();
}

bool is_less(const Whole& a, const Whole& b) {  // of the sizes
    if (a.digits.size() != b.digits.size()) return a.digits.size() < b.digits.size();
    return std::lexicographical_compare(
        a.digits.rbegin(), a.digits.rend(), b.digits.rbegin(), b.digits.rend());
}

Whole operator-(Whole a) {
    a.is_negative = !a.is_negative;
    return a;
}

Whole operator+(const Whole& a, const Whole& b) {
    if (is_less(a, b)) return b + a;
    const bool is_sum = a.is_negative == b.is_negative;
    Whole result = a;
    std::int64_t carry = 0;
    for (std::size_t i = 0; i < a.digits.size(); ++i) {
        const std::int64_t other = i < b.digits.size() ? b.digits[i] : 0;
        const std::int64_t digit = a.digits[i] + (is_sum ? other : -other) + carry;
        result.digits[i] = static_cast<std::uint32_t>(digit);
        carry = digit >> 32;
    }
    if (carry > 0) result.digits.push_back(static_cast<std::uint32_t>(carry));
    trim(result);
    return result;
}

Whole operator-(const Whole& a, const Whole& b) {
    return a + -b;
}

Whole operator*(const Whole& a, const Whole& b) {
    Whole result;
    result.digits.resize(a.digits.size() + b.digits.size());
    result.is_negative = a.is_negative != b.is_negative;
    for (std::size_t i = 0; i < a.digits.size(); ++i) {
        std::uint64_t carry = 0;
        for (std::size_t j = 0; j < b.digits.size() || carry > 0; ++j) {
            const std::uint64_t other = j < b.digits.size() ? b.digits[j] : 0;
            const std::uint64_t digit = a.digits[i] * other + result.digits[i + j] + carry;
            result.digits[i + j] = static_cast<std::uint32_t>(digit);
            carry = digit >> 32;
        }
    }
    trim(result);
    return result;
}

// Of all numbers below: small and large ones are that far apart that products of three neither
// overflow nor underflow, which is what the predicates ask for.
constexpr int kLeastExponent = -240;
constexpr int kMostExponent = 240;
constexpr int kUnitExponent = kLeastExponent - 53;

/// `value` in units of 2^kUnitExponent.
Whole whole_of(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    auto bits = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    const int shift = exponent - 53 - kUnitExponent;
    Whole result;
    result.is_negative = value < 0;
    if (bits == 0) return result;
    result.digits.assign(static_cast<std::size_t>(shift) / 32, 0);
    const Whole unit{{std::uint32_t{1} << (shift % 32)}};
    const Whole whole{{static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)}};
    for (const std::uint32_t digit : (whole * unit).digits)
        result.digits.push_back(digit);
    return result;
}

using Point = std::array<Whole, 3>;

Point difference(const glm::dvec3& a, const glm::dvec3& b) {
    return {whole_of(a.x) - whole_of(b.x),
            whole_of(a.y) - whole_of(b.y),
            whole_of(a.z) - whole_of(b.z)};
}

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// |a-d, b-d, c-d| in units of 2^(3 kUnitExponent).
Whole volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const Point u = difference(a, d);
    const Point normal = cross(difference(b, d), difference(c, d));
    return u[0] * normal[0] + u[1] * normal[1] + u[2] * normal[2];
}

/// Its highest 96 bits.
long double rounded(const Whole& a, int unit_exponent) {
    long double sum = 0;
    const std::size_t n = a.digits.size();
    for (std::size_t i = n; i-- > 0 && i + 3 >= n;)
        sum += std::ldexp(static_cast<long double>(a.digits[i]),
                          static_cast<int>(32 * i) + unit_exponent);
    return a.is_negative ? -sum : sum;
}

/// Held to the exponents above; what is smaller becomes 0.
double within_range(double value) {
    if (!std::isfinite(value) || value == 0) return 0;
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    if (exponent < kLeastExponent) return 0;
    return std::ldexp(mantissa, std::min(exponent, kMostExponent));
}

double number(Feed& feed) {
    switch (feed.whole(0, 3)) {
        case 0:  // of all sizes
            return within_range(feed.raw<double>());
        case 1:  // of one size, with all its digits
            return feed.real(-1, 1);
        case 2:  // few digits
            return feed.raw<std::int8_t>() / 8.0;
        default:  // a float, as vertices are
            return within_range(static_cast<double>(feed.raw<float>()));
    }
}

glm::dvec3 point(Feed& feed) {
    const double x = number(feed);
    const double y = number(feed);
    return {x, y, number(feed)};
}

double nudged(double value, int ulps) {
    for (int i = 0; i < std::abs(ulps); ++i)
        value = std::nextafter(value, ulps > 0 ? 1e300 : -1e300);
    return within_range(value);
}

/// A point of the plane of the first three, or of the line of the first two, but for rounding and a
/// nudge.
glm::dvec3 near_plane(const std::array<glm::dvec3, 4>& p, bool is_on_line, Feed& feed) {
    const double s = feed.raw<std::int8_t>() / 16.0;
    const double t = is_on_line ? 0 : feed.raw<std::int8_t>() / 16.0;
    const glm::dvec3 q = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    const int nudges = feed.whole(0, 255);
    return {nudged(q.x, nudges % 5 - 2),
            nudged(q.y, nudges / 5 % 5 - 2),
            nudged(q.z, nudges / 25 % 5 - 2)};
}

int sign(double value) {
    return (value > 0) - (value < 0);
}

void check_orient3d(const std::array<glm::dvec3, 4>& p) {
    const Whole exact = volume(p[0], p[1], p[2], p[3]);
    expect(scene::orient3d(p[0], p[1], p[2], p[3]) == exact.sign(), "orient3d has the exact sign");
    expect(scene::facing(p[0], p[1], p[2], p[3]) == -exact.sign(), "facing is its opposite");
    const double value = scene::orient3d_value(p[0], p[1], p[2], p[3]);
    expect(sign(value) == exact.sign(), "orient3d_value has the exact sign");
    const long double expected = rounded(exact, 3 * kUnitExponent);
    expect(std::abs(value - expected) <= 1e-13L * std::abs(expected),
           "orient3d_value has a relative error below 1e-13");
}

void check_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const Point normal = cross(difference(b, a), difference(c, a));
    const bool is_exact = normal[0].sign() == 0 && normal[1].sign() == 0 && normal[2].sign() == 0;
    expect(scene::is_collinear(a, b, c) == is_exact, "is_collinear is exact");
}

}  // namespace

void check_predicates(Bytes bytes) {
    Feed feed(bytes);
    const int kind = feed.whole(0, 3);
    std::array<glm::dvec3, 4> p{};
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = point(feed);
    if (kind == 3) p[2] = near_plane(p, true, feed);
    p[3] = kind == 0 ? point(feed) : near_plane(p, kind == 2, feed);
    check_orient3d(p);
    check_orient3d({p[3], p[2], p[1], p[0]});
    check_collinear(p[0], p[1], p[2]);
    check_collinear(p[0], p[1], p[3]);
}

}  // namespace ink::fuzz
