#include "truth/model.h"

#include <algorithm>

#include "core/disjoint_sets.h"
#include "core/parallel.h"
#include "scene/precision/weld_tolerance.h"
#include "truth/crossings/crossings.h"

namespace ink::truth {
namespace {

constexpr std::size_t kChunk = 4096;  ///< edges a task

void classify_edges(Model& model, int threads) {
    const scene::Topology& topology = model.topology;
    const std::size_t count = topology.edges.size();
    model.runs.resize(topology.edge_faces.size());
    model.flat_class.assign(count, LineClass::none);
    core::parallel_for_chunks(count, kChunk, threads, [&](std::size_t e) {
        const scene::Edge& edge = topology.edges[e];
        const auto faces = topology.faces_of(edge);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const bool is_forward = runs_forward(topology.faces[faces[i]], edge);
            model.runs[edge.first_face + i] = is_forward ? std::int8_t{1} : std::int8_t{-1};
        }
        if (faces.size() == 2) model.flat_class[e] = model.class_across(edge, faces[0], faces[1]);
    });
}

/// Whether a patch goes on over the edge.
bool is_smooth_edge(const Model& model, std::size_t e) {
    return model.topology.edges[e].face_count == 2 && model.flat_class[e] == LineClass::none;
}

void join_patches(Model& model) {
    const scene::Topology& topology = model.topology;
    core::DisjointSets patches(topology.faces.size());
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
        if (!is_smooth_edge(model, e)) continue;
        const auto faces = topology.faces_of(topology.edges[e]);
        patches.join(faces[0], faces[1]);
    }
    model.patch = patches.numbers().first;
}

std::size_t count_defects(const Model& model) {
    std::size_t count = 0;
    std::uint32_t last = 0xffffffffU;
    for (const Continuation& c : model.continuations) {
        const std::uint32_t own = model.topology.faces_of(model.topology.edges[c.edge])[0];
        if (c.edge == last || model.is_seam(own, c.face)) continue;
        last = c.edge;
        ++count;
    }
    return count;
}

}  // namespace

std::span<const Continuation> Model::continuations_of(std::uint32_t edge) const {
    return truth::continuations_of(continuations, edge);
}

LineClass Model::class_across(const scene::Edge& edge,
                              std::uint32_t face0,
                              std::uint32_t face1) const {
    if (scene::is_crease(topology, edge, face0, face1, {crease_rad, creases}))
        return LineClass::crease;
    return is_seam(face0, face1) ? LineClass::seam : LineClass::none;
}

Model build_model(const scene::Scene& scene, const TruthOptions& options) {
    check_memory(scene, options.limits);
    Model model;
    model.topology = scene::weld(scene, {.epsilon = options.weld_epsilon});
    model.crossings = find_crossings(model.topology, {.threads = options.threads});
    if (model.crossings.is_too_many) return model;  // no view of it is traced
    model.crease_rad = options.crease_rad;
    model.creases = options.creases;
    const auto& faces = model.topology.faces;
    model.is_one_object = std::ranges::all_of(
        faces, [&](const scene::Face& f) { return f.object == faces.front().object; });
    model.tolerances = scene::weld_tolerances(model.topology);
    classify_edges(model, options.threads);
    join_patches(model);
    model.continuations = find_continuations(model.topology,
                                             {.tolerances = model.tolerances,
                                              .crease_rad = options.crease_rad,
                                              .threads = options.threads});
    mark_slit_crossings(
        model.topology, model.continuations, model.tolerances, model.crossings.segments);
    model.is_touched.assign(model.topology.edges.size(), 0);
    for (const Contact& contact : model.crossings.contacts)
        model.is_touched[contact.edge] = 1;
    model.defect_edges = count_defects(model);
    return model;
}

}  // namespace ink::truth
