#include "truth/crossings/crossings.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "truth/crossings/apart.h"
#include "truth/crossings/pair_tree.h"
#include "truth/pilots.h"

namespace ink::truth {
namespace {

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
    std::sort(all.segments.begin(), all.segments.end(), [](const Crossing& x, const Crossing& y) {
        return std::tie(x.face0, x.face1) < std::tie(y.face0, y.face1);
    });
    std::sort(
        all.coplanar.begin(), all.coplanar.end(), [](const CoplanarPair& x, const CoplanarPair& y) {
            return std::tie(x.face, x.lower_face) < std::tie(y.face, y.lower_face);
        });
    auto& contacts = all.contacts;
    std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
        return std::tie(x.edge, x.face, x.t_begin, x.t_end) <
               std::tie(y.edge, y.face, y.t_begin, y.t_end);
    });
    const auto is_same = [](const Contact& x, const Contact& y) {
        return x.edge == y.edge && x.face == y.face;
    };
    contacts.erase(std::unique(contacts.begin(), contacts.end(), is_same), contacts.end());
    std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
        return std::tie(x.edge, x.t_begin, x.face) < std::tie(y.edge, y.t_begin, y.face);
    });
}

/// Those of `things`, which are sorted by it, whose `key` is `wanted`.
template <class T>
std::span<const T> with_key(const std::vector<T>& things,
                            std::uint32_t T::*key,
                            std::uint32_t wanted) {
    const auto begin = std::partition_point(
        things.begin(), things.end(), [&](const T& thing) { return thing.*key < wanted; });
    const auto end = std::partition_point(
        begin, things.end(), [&](const T& thing) { return thing.*key == wanted; });
    return {begin, end};
}

}  // namespace

std::span<const Contact> Crossings::contacts_of(std::uint32_t edge) const {
    return with_key(contacts, &Contact::edge, edge);
}

std::span<const CoplanarPair> Crossings::coplanar_with(std::uint32_t face) const {
    return with_key(coplanar, &CoplanarPair::face, face);
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
