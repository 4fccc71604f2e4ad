#include "scene/predicates.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace ink::scene {
namespace {

constexpr double kHalfUlp =
    std::numeric_limits<double>::epsilon() / 2;  // 2^-53, Shewchuk's epsilon

/// A sum of doubles that do not overlap, smallest first: exact arithmetic as Shewchuk 1997 has it.
///
/// 192 terms hold the largest sum that orient3d needs: six products of three two-term differences.
struct Expansion {
    std::array<double, 192> terms;
    int size = 0;

    void push(double term) {
        if (term == 0) return;
        assert(size < static_cast<int>(terms.size()));
        terms[static_cast<std::size_t>(size++)] = term;
    }
    /// The largest term outweighs the rest, so it carries the sign.
    [[nodiscard]] int sign() const {
        if (size == 0) return 0;
        return terms[static_cast<std::size_t>(size - 1)] > 0 ? 1 : -1;
    }
    /// Summed from the smallest on, so that rounding keeps the sign and all but the last bits.
    [[nodiscard]] double rounded() const {
        double sum = 0;
        for (int i = 0; i < size; ++i)
            sum += terms[static_cast<std::size_t>(i)];
        return sum;
    }
};

struct Halves {
    double high;
    double low;
};

/// a + b = high + low exactly (Knuth; Shewchuk, theorem 7).
Halves two_sum(double a, double b) {
    const double high = a + b;
    const double b_virtual = high - a;
    const double a_virtual = high - b_virtual;
    return {high, (a - a_virtual) + (b - b_virtual)};
}

/// a * b = high + low exactly.
Halves two_product(double a, double b) {
    const double high = a * b;
    return {high, std::fma(a, b, -high)};
}

/// Adds one double to an expansion in place (Shewchuk, grow-expansion, theorem 10): what is written
/// never overtakes what is still to be read.
void grow(Expansion& e, double b) {
    double q = b;
    const int size = std::exchange(e.size, 0);
    for (int i = 0; i < size; ++i) {
        const Halves s = two_sum(q, e.terms[static_cast<std::size_t>(i)]);
        e.push(s.low);
        q = s.high;
    }
    e.push(q);
}

Expansion difference(double a, double b) {
    const Halves s = two_sum(a, -b);
    Expansion e;
    e.push(s.low);
    e.push(s.high);
    return e;
}

/// Term by term: short expansions only, so the plain double loop is good enough.
Expansion product(const Expansion& a, const Expansion& b) {
    Expansion result;
    for (int i = 0; i < a.size; ++i) {
        for (int j = 0; j < b.size; ++j) {
            const Halves p = two_product(a.terms[static_cast<std::size_t>(i)],
                                         b.terms[static_cast<std::size_t>(j)]);
            grow(result, p.low);
            grow(result, p.high);
        }
    }
    return result;
}

void add(Expansion& sum, const Expansion& e, double factor) {
    for (int i = 0; i < e.size; ++i)
        grow(sum, factor * e.terms[static_cast<std::size_t>(i)]);
}

/// a*d - b*c of exact differences.
Expansion minor_of(const Expansion& a, const Expansion& b, const Expansion& c, const Expansion& d) {
    Expansion result = product(a, d);
    add(result, product(b, c), -1.0);
    return result;
}

struct Row {
    Expansion x, y, z;
};

Row exact_row(const glm::dvec3& p, const glm::dvec3& origin) {
    return {difference(p.x, origin.x), difference(p.y, origin.y), difference(p.z, origin.z)};
}

/// The determinant of three rows.
Expansion exact_determinant(const Row& a, const Row& b, const Row& c) {
    Expansion det = product(a.z, minor_of(b.x, b.y, c.x, c.y));
    add(det, product(b.z, minor_of(c.x, c.y, a.x, a.y)), 1.0);
    add(det, product(c.z, minor_of(a.x, a.y, b.x, b.y)), 1.0);
    return det;
}

Expansion orient3d_exact(const glm::dvec3& a,
                         const glm::dvec3& b,
                         const glm::dvec3& c,
                         const glm::dvec3& d) {
    return exact_determinant(exact_row(a, d), exact_row(b, d), exact_row(c, d));
}

/// A determinant in plain double, and the sum of what its products would be without signs, which
/// bounds its error.
struct Determinant {
    double value;
    double permanent;

    /// Shewchuk, o3derrboundA: above it the rounded determinant has the right sign.
    [[nodiscard]] bool is_sure() const {
        return std::abs(value) > (7 + 56 * kHalfUlp) * kHalfUlp * permanent;
    }
    [[nodiscard]] int sign() const { return value > 0 ? 1 : -1; }
};

Determinant plain_determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double bxcy = b.x * c.y, cxby = c.x * b.y;
    const double cxay = c.x * a.y, axcy = a.x * c.y;
    const double axby = a.x * b.y, bxay = b.x * a.y;
    return {a.z * (bxcy - cxby) + b.z * (cxay - axcy) + c.z * (axby - bxay),
            (std::abs(bxcy) + std::abs(cxby)) * std::abs(a.z) +
                (std::abs(cxay) + std::abs(axcy)) * std::abs(b.z) +
                (std::abs(axby) + std::abs(bxay)) * std::abs(c.z)};
}

/// The exact sign of (bx-ax)(cy-ay) - (by-ay)(cx-ax) in one coordinate plane.
int orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
    const double left = (bx - ax) * (cy - ay);
    const double right = (by - ay) * (cx - ax);
    const double det = left - right;
    // Shewchuk, ccwerrboundA.
    const double bound = (3 + 16 * kHalfUlp) * kHalfUlp * (std::abs(left) + std::abs(right));
    if (std::abs(det) > bound) return det > 0 ? 1 : -1;
    const Expansion exact =
        minor_of(difference(bx, ax), difference(by, ay), difference(cx, ax), difference(cy, ay));
    return exact.sign();
}

}  // namespace

int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const Determinant det = plain_determinant(a - d, b - d, c - d);
    return det.is_sure() ? det.sign() : orient3d_exact(a, b, c, d).sign();
}

int orient3d(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const Viewpoint& eye) {
    if (!eye.is_direction) return orient3d(a, b, c, eye.at_world);
    // |a-e, b-e, c-e| = |a-e, b-a, c-a|, and a - e comes ever nearer to the direction.
    const Determinant det = plain_determinant(eye.exact(), b - a, c - a);
    if (det.is_sure()) return det.sign();
    const Row sight = exact_row(eye.exact(), glm::dvec3(0));
    return exact_determinant(sight, exact_row(b, a), exact_row(c, a)).sign();
}

double orient3d_value(const glm::dvec3& a,
                      const glm::dvec3& b,
                      const glm::dvec3& c,
                      const glm::dvec3& d) {
    const Determinant det = plain_determinant(a - d, b - d, c - d);
    // The bound is 8e-16 of the permanent, so a hundredth of that is good to 1e-13.
    if (std::abs(det.value) > 0.01 * det.permanent) return det.value;
    return orient3d_exact(a, b, c, d).rounded();
}

bool is_collinear(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return orient2d(a.x, a.y, b.x, b.y, c.x, c.y) == 0 &&
           orient2d(a.y, a.z, b.y, b.z, c.y, c.z) == 0 &&
           orient2d(a.z, a.x, b.z, b.x, c.z, c.x) == 0;
}

}  // namespace ink::scene
