#include "truth/crossings/seen_contacts.h"

#include <algorithm>
#include <tuple>

namespace ink::truth {
namespace {

/// Joins the stretches of one edge in one face that overlap, and sorts all as Crossings has them.
void join_stretches(std::vector<Contact>& contacts) {
    std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
        return std::tie(x.edge, x.face, x.t_begin) < std::tie(y.edge, y.face, y.t_begin);
    });
    std::size_t kept = 0;
    for (const Contact& next : contacts) {
        if (kept > 0) {
            Contact& last = contacts[kept - 1];
            if (last.edge == next.edge && last.face == next.face && next.t_begin <= last.t_end) {
                last.t_end = std::max(last.t_end, next.t_end);
                continue;
            }
        }
        contacts[kept++] = next;
    }
    contacts.resize(kept);
    std::sort(contacts.begin(), contacts.end(), [](const Contact& x, const Contact& y) {
        return std::tie(x.edge, x.t_begin, x.face) < std::tie(y.edge, y.t_begin, y.face);
    });
}

void sort_once(std::vector<CoplanarPair>& pairs) {
    const auto key = [](const CoplanarPair& pair) { return std::tie(pair.face, pair.lower_face); };
    // clang 14, the fuzzers' compiler, takes no views of Debian 12's library: no
    // std::ranges::unique.
    std::sort(
        pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
    const auto twice = std::unique(
        pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); });
    pairs.erase(twice, pairs.end());
}

}  // namespace

bool SeenContacts::is_contact(std::uint32_t face0, std::uint32_t face1) const {
    return std::binary_search(by_digits.begin(), by_digits.end(), std::pair(face0, face1));
}

std::optional<SeenContacts> find_seen_contacts(
    const Crossings& crossings,
    std::size_t edge_count,
    const std::function<bool(const WrittenContact&)>& is_unseen) {
    SeenContacts seen;
    Crossings& all = seen.all;
    for (const WrittenContact& c : crossings.written.contacts) {
        if (!is_unseen(c)) continue;
        seen.by_digits.emplace_back(c.face0, c.face1);
        all.contacts.insert(
            all.contacts.end(),
            c.touching.contacts.begin(),
            c.touching.contacts.begin() + static_cast<std::ptrdiff_t>(c.touching.contact_count));
        if (c.touching.is_coplanar) all.coplanar.push_back({c.face1, c.face0});
    }
    if (seen.by_digits.empty()) return std::nullopt;
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(all.contacts, crossings.contacts);
    append(all.coplanar, crossings.coplanar);
    join_stretches(all.contacts);
    sort_once(all.coplanar);
    seen.is_touched.assign(edge_count, 0);
    for (const Contact& contact : all.contacts)
        seen.is_touched[contact.edge] = 1;
    return seen;
}

}  // namespace ink::truth
