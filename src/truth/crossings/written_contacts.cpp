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

bool share_vertex(const scene::Face& f, const scene::Face& g) {
    return std::any_of(f.vertices.begin(), f.vertices.end(), [&](std::uint32_t v) {
        return std::find(g.vertices.begin(), g.vertices.end(), v) != g.vertices.end();
    });
}

bool has_any(const Sides& sides) {
    return sides.has_above || sides.has_below;
}

double most_written(const scene::Topology& topology, std::uint32_t f, std::uint32_t g) {
    double most = 0;
    for (const std::uint32_t face : {f, g}) {
        for (const std::uint32_t v : topology.faces[face].vertices)
            most = std::max(most, topology.written_rounding_world[v]);
    }
    return most;
}

}  // namespace

void WrittenPairs::add(const scene::Topology& topology,
                       const Meeting& as_given,
                       std::uint32_t f,
                       std::uint32_t g) {
    const std::uint32_t face0 = std::min(f, g), face1 = std::max(f, g);
    const WrittenMeeting met = meet_as_written(topology, face0, face1);
    const bool is_beside = has_any(met.of_f) || has_any(met.of_g);
    if (is_beside && !share_vertex(topology.faces[f], topology.faces[g]))
        sides.push_back({face0, face1, met.of_f, met.of_g});
    if (!met.meeting || met.meeting->crossing || is_same(as_given, *met.meeting)) return;
    contacts.push_back(
        {face0, face1, most_written(topology, f, g), *met.meeting, as_given.crossing});
}

void keep_one_sided(const scene::Topology& topology,
                    const SmoothFaces& smooth,
                    WrittenPairs& pairs) {
    if (pairs.contacts.empty()) return;
    const std::vector<std::int8_t> winding = windings(topology, smooth);
    struct Beside {
        Sides of_lower, of_higher;
    };
    using Patches = std::pair<std::uint32_t, std::uint32_t>;
    const auto patches_of = [&](std::uint32_t f, std::uint32_t g) -> Patches {
        return std::minmax(smooth.patch[f], smooth.patch[g]);
    };
    std::map<Patches, Beside> beside;
    for (const WrittenSides& s : pairs.sides) {
        const Patches patches = patches_of(s.face0, s.face1);
        Beside& sum = beside[patches];
        const bool is_swapped = smooth.patch[s.face0] != patches.first;
        add(s.of_face0, winding[s.face1], is_swapped ? sum.of_higher : sum.of_lower);
        add(s.of_face1, winding[s.face0], is_swapped ? sum.of_lower : sum.of_higher);
    }
    std::erase_if(pairs.contacts, [&](const WrittenContact& c) {
        const auto at = beside.find(patches_of(c.face0, c.face1));
        return at != beside.end() && has_both(at->second.of_lower) &&
               has_both(at->second.of_higher);
    });
}

}  // namespace ink::truth
