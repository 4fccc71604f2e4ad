#include "truth/crossings/written_contacts.h"

#include <algorithm>
#include <map>
#include <utility>

namespace ink::truth {
namespace {

/// Whether one meeting has a contact of an edge and a face, over all of another's stretch.
bool has_contact(const Meeting& meeting, const Contact& contact) {
    const auto* end = meeting.contacts.data() + meeting.contact_count;
    return std::any_of(meeting.contacts.data(), end, [&](const Contact& c) {
        return c.edge == contact.edge && c.face == contact.face && c.t_begin <= contact.t_begin &&
               c.t_end >= contact.t_end;
    });
}

bool is_same(const Meeting& as_given, const Meeting& as_written) {
    if (as_given.crossing || as_given.is_coplanar != as_written.is_coplanar) return false;
    const auto* end = as_written.contacts.data() + as_written.contact_count;
    return std::all_of(as_written.contacts.data(), end, [&](const Contact& c) {
        return has_contact(as_given, c);
    });
}

/// Per face 1 if it is wound as the first face of its patch is, and -1 if the other way round.
std::vector<std::int8_t> windings(const scene::Topology& topology, const SmoothFaces& smooth) {
    std::vector<std::int8_t> winding(topology.faces.size(), 0);
    std::vector<std::uint32_t> open;
    for (std::uint32_t first = 0; first < winding.size(); ++first) {
        if (winding[first] != 0) continue;
        winding[first] = 1;
        open.push_back(first);
        while (!open.empty()) {
            const std::uint32_t f = open.back();
            open.pop_back();
            for (const std::uint32_t e : topology.faces[f].edges) {
                if (smooth.is_smooth[e] == 0) continue;
                const scene::Edge& edge = topology.edges[e];
                const auto faces = topology.faces_of(edge);
                const std::uint32_t next = faces[0] == f ? faces[1] : faces[0];
                if (winding[next] != 0) continue;
                // Two faces that run along an edge in opposite directions are wound alike.
                const bool is_alike =
                    smooth.runs[edge.first_face] != smooth.runs[edge.first_face + 1];
                winding[next] = static_cast<std::int8_t>(is_alike ? winding[f] : -winding[f]);
                open.push_back(next);
            }
        }
    }
    return winding;
}

void add(const Sides& sides, std::int8_t winding, Sides& sum) {
    sum.has_above = sum.has_above || (winding > 0 ? sides.has_above : sides.has_below);
    sum.has_below = sum.has_below || (winding > 0 ? sides.has_below : sides.has_above);
}

bool has_both(const Sides& sides) {
    return sides.has_above && sides.has_below;
}

}  // namespace

std::optional<WrittenContact> find_written_contact(const scene::Topology& topology,
                                                   const Meeting& as_given,
                                                   std::uint32_t f,
                                                   std::uint32_t g) {
    const auto [face0, face1] = std::minmax(f, g);
    const auto met = meet_as_written(topology, face0, face1);
    if (!met || met->meeting.crossing || is_same(as_given, met->meeting)) return std::nullopt;
    WrittenContact contact{face0, face1, 0, met->meeting, as_given.crossing, met->of_f, met->of_g};
    for (const std::uint32_t face : {face0, face1}) {
        for (const std::uint32_t v : topology.faces[face].vertices) {
            contact.rounding_world =
                std::max(contact.rounding_world, topology.written_rounding_world[v]);
        }
    }
    return contact;
}

void keep_one_sided(const scene::Topology& topology,
                    const SmoothFaces& smooth,
                    std::vector<WrittenContact>& contacts) {
    if (contacts.empty()) return;
    const std::vector<std::int8_t> winding = windings(topology, smooth);
    struct Beside {
        Sides of_lower, of_higher;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Beside> beside;
    const auto key = [&](const WrittenContact& c) {
        return std::minmax(smooth.patch[c.face0], smooth.patch[c.face1]);
    };
    for (const WrittenContact& c : contacts) {
        const auto [lower, higher] = key(c);
        Beside& sum = beside[{lower, higher}];
        const bool is_swapped = smooth.patch[c.face0] != lower;
        add(c.of_face0, winding[c.face1], is_swapped ? sum.of_higher : sum.of_lower);
        add(c.of_face1, winding[c.face0], is_swapped ? sum.of_lower : sum.of_higher);
    }
    std::erase_if(contacts, [&](const WrittenContact& c) {
        const auto [lower, higher] = key(c);
        const Beside& sum = beside[{lower, higher}];
        return has_both(sum.of_lower) && has_both(sum.of_higher);
    });
}

}  // namespace ink::truth
