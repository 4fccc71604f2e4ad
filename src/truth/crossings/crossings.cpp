#include "truth/crossings/crossings.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <tuple>

#include "core/equal_rows.h"
#include "truth/crossings/pair_tree.h"
#include "truth/pilots.h"

namespace ink::truth {
namespace {

/// A triangle laid out for the quick tests, and its index among the faces.
struct Flat {
    std::array<glm::dvec3, 3> p;
    glm::dvec3 normal;    ///< cross product of two sides
    double size = 0;      ///< largest component of its sides
    double rounding = 0;  ///< the most of its vertices, world units
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t face = 0;
};

// Bounds on the error of the products below, in units of the products of the largest components:
// three subtractions, three products and their sums, each off by at most half an ulp (54 and 320
// halves counted term by term), rounded up.
constexpr double kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
constexpr double kPlaneError = 64 * kHalfUlp;
constexpr double kSideError = 512 * kHalfUlp;

double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The corners of one triangle that the other does not share.
struct Loose {
    std::array<std::size_t, 4> corners{};  ///< one more than can be, so that all may be written
    std::size_t count = 0;
};

Loose loose_corners(const Flat& f, const Flat& g) {
    Loose loose;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = f.vertices[i];
        loose.corners[loose.count] = i;  // no branch: which corner is shared cannot be foreseen
        loose.count += static_cast<std::size_t>((v != g.vertices[0]) & (v != g.vertices[1]) &
                                                (v != g.vertices[2]));
    }
    return loose;
}

/// Whether all loose corners of `g` certainly lie on one side of f's plane, farther from it than
/// rounding may have moved both. Then what they have in common is what they share. From a shared
/// corner g leaves the plane by degrees, so the farther its corners, the higher they must lie.
bool is_beside_plane(const Flat& f, const Flat& g, const Loose& loose, double rounding) {
    const double scale = kPlaneError * f.size * f.size;
    const double touching = rounding * glm::length(f.normal);
    const bool has_shared = loose.count < 3;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t i = 0; i < loose.count; ++i) {
        const glm::dvec3 d = g.p[loose.corners[i]] - f.p[0];
        const double height = glm::dot(f.normal, d);
        const double reach = has_shared ? std::max(1.0, 2 * largest(d) / f.size) : 1;
        const double error = scale * largest(d) + reach * touching;
        lowest = std::min(lowest, height - error);
        highest = std::max(highest, height + error);
    }
    return lowest > 0 || highest < 0;
}

/// Whether all loose corners of `g` certainly lie outwards of one side of `f`, seen along f's
/// normal, by more than rounding may have moved both. Then they have nothing in common but shared
/// corners on that side.
bool is_beside_side(
    const Flat& f, const Loose& of_f, const Flat& g, const Loose& loose, double rounding) {
    const bool has_shared = loose.count < 3;
    std::array<bool, 3> is_shared = {true, true, true};
    for (std::size_t i = 0; i < of_f.count; ++i)
        is_shared[of_f.corners[i]] = false;
    const double scale = kSideError * f.size * f.size * f.size;
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_shared[(i + 2) % 3]) continue;  // from there g may run through f
        const glm::dvec3 inward = glm::cross(f.normal, f.p[(i + 1) % 3] - f.p[i]);
        const double touching = rounding * glm::length(inward);
        const double side = largest(f.p[(i + 1) % 3] - f.p[i]);
        const bool is_outside = std::all_of(
            loose.corners.begin(),
            loose.corners.begin() + static_cast<std::ptrdiff_t>(loose.count),
            [&](std::size_t corner) {
                const glm::dvec3 d = g.p[corner] - f.p[i];
                const double reach = has_shared ? std::max(1.0, 2 * largest(d) / side) : 1;
                return glm::dot(inward, d) < -scale * largest(d) - reach * touching;
            });
        if (is_outside) return true;
    }
    return false;
}

/// Whether a plane through the corner they share, halfway between the middles of their angles
/// there, certainly has one triangle on either side: by more than rounding may have turned sides.
bool is_parted_at_corner(
    const Flat& f, const Loose& of_f, const Flat& g, const Loose& of_g, double rounding) {
    const glm::dvec3& shared = f.p[3 - of_f.corners[0] - of_f.corners[1]];
    std::array<glm::dvec3, 4> out;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
        out[i] = f.p[of_f.corners[i]] - shared;
        out[2 + i] = g.p[of_g.corners[i]] - shared;
    }
    for (glm::dvec3& side : out) {
        const double length = glm::length(side);
        shortest = std::min(shortest, length);
        side /= length;
    }
    const glm::dvec3 normal = glm::normalize(out[0] + out[1]) - glm::normalize(out[2] + out[3]);
    // Far above what double does to unit vectors, and what rounding may have turned two of them.
    const double sure = 1e-9 + 4 * rounding / shortest;
    return glm::dot(normal, out[0]) > sure && glm::dot(normal, out[1]) > sure &&
           glm::dot(normal, out[2]) < -sure && glm::dot(normal, out[3]) < -sure;
}

/// Whether two triangles with a common side certainly do not lie folded on each other.
bool is_unfolded(const Flat& f, const Flat& g, const Loose& of_f, const Loose& of_g) {
    const std::size_t i = of_f.corners[0];
    const glm::dvec3& base = f.p[(i + 1) % 3];
    const glm::dvec3 along = glm::normalize(f.p[(i + 2) % 3] - base);
    const glm::dvec3 a = f.p[i] - base, b = g.p[of_g.corners[0]] - base;
    const glm::dvec3 into_f = a - along * glm::dot(along, a);
    const glm::dvec3 into_g = b - along * glm::dot(along, b);
    return glm::dot(into_f, into_g) < -1e-9 * glm::length(a) * glm::length(b);
}

/// The triangle of a face.
Flat flat(const scene::Topology& topology, std::uint32_t f) {
    Flat result;
    result.vertices = topology.faces[f].vertices;
    result.face = f;
    for (std::size_t i = 0; i < 3; ++i)
        result.p[i] = topology.p_world[result.vertices[i]];
    result.rounding = topology.rounding_of(f);
    const glm::dvec3 u = result.p[1] - result.p[0], v = result.p[2] - result.p[0];
    result.normal = glm::cross(u, v);
    result.size = std::max({largest(u), largest(v), largest(v - u)});
    return result;
}

/// Whether two triangles whose boxes touch certainly have nothing in common but what they share,
/// though rounding may have moved them.
bool is_apart(const Flat& f, const Flat& g) {
    const Loose of_f = loose_corners(f, g), of_g = loose_corners(g, f);
    const double rounding = f.rounding + g.rounding;
    if (is_beside_plane(f, g, of_g, rounding) || is_beside_plane(g, f, of_f, rounding)) return true;
    if (of_f.count == 1) return is_unfolded(f, g, of_f, of_g);
    if (of_f.count == 2 && is_parted_at_corner(f, of_f, g, of_g, rounding)) return true;
    return is_beside_side(f, of_f, g, of_g, rounding) || is_beside_side(g, of_g, f, of_f, rounding);
}

/// What the tasks have found together: once over a budget, always over it.
class Budget {
  public:
    explicit Budget(const CrossingOptions& options) : options_(options) {}
    void add(std::size_t pairs, std::size_t found) {
        pairs_ += pairs;
        found_ += found;
    }
    [[nodiscard]] std::size_t pairs() const { return pairs_; }
    [[nodiscard]] bool is_spent() const {
        return pairs_ > options_.most_pairs || found_ > options_.most_found;
    }

  private:
    const CrossingOptions& options_;
    std::atomic<std::size_t> pairs_{0}, found_{0};
};

/// Segments and contacts.
std::size_t found_in(const Crossings& part) {
    return part.segments.size() + part.contacts.size();
}

/// Tests the pairs of one task after another and keeps what they have in common.
class PairTester {
  public:
    PairTester(const scene::Topology& topology, const std::vector<Flat>& flats, Budget& budget)
        : topology_(topology), flats_(flats), budget_(budget) {}

    /// False once the budget is spent.
    bool test(std::uint32_t place0, std::uint32_t place1, Crossings& out) {
        if (++pairs_ == kReport && !report(out)) return false;
        const Flat& f = flats_[place0];
        const Flat& g = flats_[place1];
        if (!is_apart(f, g)) keep(meet(topology_, f.face, g.face), f.face, g.face, out);
        return true;
    }

    bool report(Crossings& out) {
        const std::size_t found = found_in(out);
        budget_.add(pairs_, found - found_before_);
        out.pairs_tested += pairs_;
        found_before_ = found;
        pairs_ = 0;
        return !budget_.is_spent();
    }

  private:
    static constexpr std::size_t kReport = 4096;  ///< pairs between looks at the budget

    static void keep(const Meeting& meeting, std::uint32_t f, std::uint32_t g, Crossings& out) {
        if (meeting.crossing) out.segments.push_back(*meeting.crossing);
        out.contacts.insert(
            out.contacts.end(),
            meeting.contacts.begin(),
            meeting.contacts.begin() + static_cast<std::ptrdiff_t>(meeting.contact_count));
        if (meeting.is_coplanar) out.coplanar.push_back({std::max(f, g), std::min(f, g)});
    }

    const scene::Topology& topology_;
    const std::vector<Flat>& flats_;
    Budget& budget_;
    std::size_t pairs_ = 0;
    std::size_t found_before_ = 0;
};

PairTree tree_of(const scene::Topology& topology) {
    std::vector<scene::Box> boxes(topology.faces.size());
    for (std::uint32_t f = 0; f < boxes.size(); ++f) {
        const Flat triangle = flat(topology, f);
        for (const glm::dvec3& p : triangle.p) {
            boxes[f].add(p - triangle.rounding);
            boxes[f].add(p + triangle.rounding);
        }
    }
    return PairTree(boxes);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// Both faces of an edge find the same contact of it with a third; one of the two is enough.
void sort_and_merge(Crossings& all) {
    std::ranges::sort(all.segments, {}, [](const auto& x) { return std::tie(x.face0, x.face1); });
    std::ranges::sort(
        all.coplanar, {}, [](const auto& x) { return std::tie(x.face, x.lower_face); });
    auto& contacts = all.contacts;
    std::ranges::sort(contacts, {}, [](const Contact& x) {
        return std::tie(x.edge, x.face, x.t_begin, x.t_end);
    });
    const auto is_same = [](const Contact& x, const Contact& y) {
        return x.edge == y.edge && x.face == y.face;
    };
    contacts.erase(std::unique(contacts.begin(), contacts.end(), is_same), contacts.end());
    std::ranges::sort(
        contacts, {}, [](const Contact& x) { return std::tie(x.edge, x.t_begin, x.face); });
}

}  // namespace

std::span<const Contact> Crossings::contacts_of(std::uint32_t edge) const {
    return core::equal_rows(std::span(contacts), edge, &Contact::edge);
}

std::span<const CoplanarPair> Crossings::coplanar_with(std::uint32_t face) const {
    return core::equal_rows(std::span(coplanar), face, &CoplanarPair::face);
}

Crossings find_crossings(const scene::Topology& topology, const CrossingOptions& options) {
    if (topology.faces.empty()) return {};
    const PairTree tree = tree_of(topology);
    std::vector<Flat> flats;
    flats.reserve(topology.faces.size());
    for (const std::uint32_t f : tree.order())
        flats.push_back(flat(topology, f));

    const auto tasks = tree.tasks();
    std::vector<Crossings> parts(tasks.size());
    Budget budget(options);
    const auto search = [&](std::size_t i) {
        if (budget.is_spent()) return;
        PairTester tester(topology, flats, budget);
        tree.for_each(tasks[i], [&](std::uint32_t place0, std::uint32_t place1) {
            return tester.test(place0, place1, parts[i]);
        });
        (void)tester.report(parts[i]);
    };
    const std::size_t count = tasks.size();
    const auto pairs_of = [&](std::size_t i) { return parts[i].pairs_tested; };
    const auto finds_of = [&](std::size_t i) { return found_in(parts[i]); };
    const bool is_whole = run_pilots_first(count, options.threads, search, [&](std::size_t stride) {
        return will_exceed(count, stride, options.most_pairs, pairs_of) ||
               will_exceed(count, stride, options.most_found, finds_of);
    });

    Crossings all;
    all.is_too_many = !is_whole || budget.is_spent();
    all.pairs_tested = all.is_too_many ? options.most_pairs : budget.pairs();
    if (all.is_too_many) return all;
    for (const Crossings& part : parts) {
        append(all.segments, part.segments);
        append(all.contacts, part.contacts);
        append(all.coplanar, part.coplanar);
    }
    sort_and_merge(all);
    return all;
}

}  // namespace ink::truth
