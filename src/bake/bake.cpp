#include "bake/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "bake/baked_primitives.h"
#include "bake/code_attributes.h"
#include "bake/edge_visibility.h"
#include "bake/mark.h"
#include "core/error.h"
#include "core/provenance.h"
#include "import/model_bytes.h"

namespace ink::bake {
namespace {

namespace fs = std::filesystem;
using methods::BakedMethod;

/// "1 vertex", "2 vertices".
std::string counted(std::size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// What the file is to say of itself: what was asked for, and of an earlier run what stays.
Mark wanted_mark(const BakeOptions& options,
                 const std::optional<Mark>& before,
                 const scene::Scene& scene) {
    Mark mark{core::provenance().version, mesh_hash(scene), options.pose, {}, {}};
    if (options.codes) {
        mark.codes = {{"method", name(*options.codes)}, {"crease_deg", options.crease_deg}};
        if (options.texcoord > 0)
            mark.codes["channel"] = fmt::format("texcoord{}", options.texcoord);
        if (options.repair) mark.codes["repaired"] = true;
        if (!options.motions.empty()) mark.codes["animation"] = options.animation;
    } else if (before) {
        mark.codes = before->codes;
    }
    if (options.edges) {
        mark.edges = {{"crease_deg", options.crease_deg}};
    } else if (before) {
        mark.edges = before->edges;
    }
    return mark;
}

/// What a mark's parts ask for. Throws core::Error if an earlier version wrote what is not known.
BakeOptions options_of(const Mark& mark) {
    BakeOptions options;
    if (!mark.codes.is_null()) {
        const Json method = mark.codes.value("method", Json());
        for (const BakedMethod one : {BakedMethod::surface8, BakedMethod::label8})
            if (method == name(one)) options.codes = one;
        if (!options.codes)
            throw core::Error(
                "extras", "extras.inkbench has codes of an unknown method", "surface8, label8");
        const Json channel = mark.codes.value("channel", Json());
        options.texcoord = channel == "texcoord1" ? 1 : channel == "texcoord2" ? 2 : 0;
        options.repair = mark.codes.value("repaired", false);
    }
    options.edges = !mark.edges.is_null();
    return options;
}

double crease_deg_of(const Json& part) {
    const Json crease = part.value("crease_deg", Json());
    return crease.is_number() ? crease.get<double>() : BakeOptions{}.crease_deg;
}

/// What is to be done, so that a file that has `before` has `after`.
struct Work {
    bool codes = false;
    bool edges = false;
};

Work work_for(const std::optional<Mark>& before,
              const Mark& after,
              const std::vector<BakedPrimitive>& primitives) {
    const bool is_stale = !before || before->version != after.version ||
                          before->mesh != after.mesh || before->pose != after.pose;
    const bool has_codes =
        std::ranges::all_of(primitives, [](auto& primitive) { return primitive.source.has(kInk); });
    Work work;
    work.codes = !after.codes.is_null() && (is_stale || before->codes != after.codes || !has_codes);
    // Edges stand in the order of triangles and corners, which codes change.
    work.edges = !after.edges.is_null() && (is_stale || before->edges != after.edges || work.codes);
    return work;
}

/// Edges of another program are in an order that turned triangles have no more.
void check_foreign_edges(const std::vector<BakedPrimitive>& primitives) {
    for (const BakedPrimitive& primitive : primitives) {
        const bool is_turned =
            std::ranges::any_of(primitive.turns, [](int turn) { return turn != 0; });
        if (!is_turned || !has_edges(primitive)) continue;
        throw core::Error(primitive.place(),
                          primitive.place() + ": codes would change the order of its edges (" +
                              import::kEdgeVisibility + ")",
                          "a model without them");
    }
}

class Baking {
  public:
    Baking(import::GltfDocument document, const import::ImportedModel& model)
        : edit_(std::move(document)),
          primitives_(find_primitives(edit_, model)),
          prepared_(model.scene) {}

    BakedFile run(const BakeOptions& options, const fs::path& from, const fs::path& to) {
        const std::optional<Mark> before = read_mark(edit_.json());
        const Mark after = wanted_mark(options, before, prepared_);
        const Work work = work_for(before, after, primitives_.list);
        const BakeOptions all = options_of(after);
        if (!work.codes && !work.edges && is_glb(from) == is_glb(to)) {
            return {.bytes = std::string(import::text_of(edit_.document().bytes)),
                    .lines = {"all of it is there already: nothing is changed"},
                    .is_unchanged = true};
        }
        if (work.codes) {
            if (after.codes.contains("animation") && options.motions.empty())
                throw core::Error("extras",
                                  "its codes are of an animation, and have to be made anew",
                                  "--codes surface8 --animation NAME");
            bake_codes(all, options.motions, crease_deg_of(after.codes), before.has_value());
        }
        if (work.codes && !work.edges) check_foreign_edges(primitives_.list);
        const bool has_own_edges = before && !before->edges.is_null();
        if (work.edges) bake_edges(crease_deg_of(after.edges), has_own_edges);
        if (!options.pose.empty()) say("it moves: what is put in is of its pose {}", options.pose);
        say_what_is_left();
        write_mark(edit_.json(), after);
        std::vector<std::string> notes;
        file_.bytes = edit_.bytes_for(to, notes);
        if (edit_.idle_bytes() > 0)
            say("{:.1f} kB of it were vertices and indices, and nothing uses them now",
                static_cast<double>(edit_.idle_bytes()) / 1e3);
        file_.lines.insert(file_.lines.end(), notes.begin(), notes.end());
        return std::move(file_);
    }

  private:
    static bool is_glb(const fs::path& path) {
        return import::lower_case(path.extension().string()) == ".glb";
    }

    void bake_codes(const BakeOptions& options,
                    const std::vector<scene::Scene>& motions,
                    double crease_deg,
                    bool is_again) {
        if (const std::size_t views = edit_.unpack_views())
            say("{} of meshopt {} unpacked", views, views == 1 ? "is" : "are");
        const auto codes = options.repair
                               ? methods::repaired_codes(prepared_, crease_deg, motions)
                               : methods::baked_codes(prepared_, *options.codes, crease_deg);
        const CodeCounts counts = add_codes(
            edit_, primitives_.list, codes, {.texcoord = options.texcoord, .is_again = is_again});
        std::size_t triangles = 0;
        for (const BakedPrimitive& primitive : primitives_.list)
            triangles += primitive.triangles.size();
        file_.vertices = counts.vertices;
        file_.added_vertices = counts.added;
        say("codes of {} on {}: {} to {} that there were",
            name(*options.codes),
            counted(triangles, "triangle", "triangles"),
            counted(counts.added, "vertex is added", "vertices are added"),
            counts.vertices);
        if (options.repair)
            say("they are repaired by views of the model{}",
                motions.empty() ? ""
                                : " and of " + counted(motions.size(), "animation", "animations"));
        if (counts.unstripped > 0)
            say("{} became plain triangles",
                counted(counts.unstripped, "strip or fan", "strips or fans"));
        if (counts.undraco > 0)
            say("{} of Draco {} unpacked", counts.undraco, counts.undraco == 1 ? "is" : "are");
        if (counts.filled > 0)
            say("TEXCOORDs below the channel were missing and hold the same, in {}",
                counted(counts.filled, "primitive", "primitives"));
    }

    void bake_edges(double crease_deg, bool is_again) {
        const auto mesh = methods::baked_mesh(prepared_, crease_deg);
        const EdgeCounts counts =
            add_edges(edit_, primitives_.list, find_edges(prepared_, *mesh), is_again);
        say("edges: {} and {}",
            counted(counts.hard, "hard one", "hard ones"),
            counted(counts.silhouettes, "that may be a silhouette", "that may be silhouettes"));
    }

    void say_what_is_left() {
        if (primitives_.repeated_meshes > 0)
            say("{} used by several nodes: the first one's place gives codes and edges",
                counted(primitives_.repeated_meshes, "mesh is", "meshes are"));
        if (primitives_.absent_meshes > 0)
            say("{} in no scene and stays as it is",
                counted(primitives_.absent_meshes, "mesh is", "meshes are"));
    }

    template <class... Words>
    void say(fmt::format_string<Words...> format, Words&&... words) {
        file_.lines.push_back(fmt::format(format, std::forward<Words>(words)...));
    }

    GltfEdit edit_;
    BakedPrimitives primitives_;
    scene::PreparedScene prepared_;
    BakedFile file_;
};

}  // namespace

std::string name(BakedMethod method) {
    return method == BakedMethod::surface8 ? "surface8" : "label8";
}

bool is_gltf(const import::ImportedModel& model) {
    const auto& nodes = model.places.node_of_instance;
    return std::ranges::none_of(nodes, [](std::uint32_t node) { return node == scene::kNoNode; });
}

BakedFile bake(const fs::path& from,
               const import::ImportedModel& model,
               const BakeOptions& options,
               const fs::path& to) {
    try {
        auto document = import::open_gltf(from);
        if (!document) throw core::Error("", "is no glTF file", ".gltf, .glb");
        return Baking(std::move(*document), model).run(options, from, to);
    } catch (const core::Error& error) {
        if (error.where() == to.string()) throw;
        throw core::Error(from.string(), error.what_happened(), error.accepted());
    } catch (const nlohmann::json::exception&) {
        throw core::Error(from.string(), "its JSON has a value where glTF has none of its type");
    }
}

}  // namespace ink::bake
