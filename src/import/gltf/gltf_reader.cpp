#include "import/gltf/gltf_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "import/gltf/document.h"
#include "import/gltf/meshes.h"
#include "import/gltf/motion.h"
#include "import/gltf/tree.h"
#include "import/meshes/polygons.h"
#include "import/scene_stream.h"

namespace ink::import {
namespace {

enum class Heeded {
    read,
    needless,  ///< moves no triangle: looks, sounds, physics, notes of other programs
    visible,   ///< moves no triangle, but draws something that is left out here
};

struct Extension {
    std::string_view name;  ///< or how it begins, before a *
    Heeded heeded;
};

/// All that may be required of us. Others are refused by name.
constexpr std::array kExtensions{
    Extension{"EXT_mesh_gpu_instancing", Heeded::read},
    Extension{"EXT_mesh_primitive_edge_visibility", Heeded::read},
    Extension{"EXT_meshopt_compression", Heeded::read},
    Extension{"KHR_animation_pointer", Heeded::read},
    Extension{"KHR_draco_mesh_compression", Heeded::read},
    Extension{"KHR_lights_punctual", Heeded::read},
    Extension{"KHR_mesh_quantization", Heeded::read},
    Extension{"KHR_meshopt_compression", Heeded::read},
    Extension{"KHR_node_visibility", Heeded::read},
    Extension{"KHR_materials_*", Heeded::needless},
    Extension{"KHR_texture_*", Heeded::needless},
    Extension{"KHR_audio*", Heeded::needless},
    Extension{"KHR_node_hoverability", Heeded::needless},
    Extension{"KHR_node_selectability", Heeded::needless},
    Extension{"KHR_physics_*", Heeded::needless},
    Extension{"KHR_technique*", Heeded::needless},
    Extension{"KHR_xmp*", Heeded::needless},
    Extension{"EXT_instance_features", Heeded::needless},
    Extension{"EXT_lights_*", Heeded::needless},
    Extension{"EXT_mesh_features", Heeded::needless},
    Extension{"EXT_mesh_manifold", Heeded::needless},
    Extension{"EXT_structural_metadata", Heeded::needless},
    Extension{"EXT_texture_*", Heeded::needless},
    Extension{"ADOBE_materials_*", Heeded::needless},
    Extension{"AGI_stk_metadata", Heeded::needless},
    Extension{"FB_ngon_encoding", Heeded::needless},
    Extension{"GODOT_single_root", Heeded::needless},
    Extension{"MSFT_lod", Heeded::needless},
    Extension{"MSFT_packing_*", Heeded::needless},
    Extension{"MSFT_screencoverage", Heeded::needless},
    Extension{"MSFT_texture_dds", Heeded::needless},
    Extension{"CESIUM_primitive_outline", Heeded::visible},
};

const Extension* find_extension(std::string_view name) {
    const auto* found = std::find_if(kExtensions.begin(), kExtensions.end(), [&](auto& extension) {
        const std::string_view known = extension.name;
        return known.ends_with('*') ? name.starts_with(known.substr(0, known.size() - 1))
                                    : name == known;
    });
    return found == kExtensions.end() ? nullptr : found;
}

/// "2 further animations: Run, Jump", of all but number `own`; nameless ones by number.
void note_further(const std::vector<JsonObject>& all,
                  std::size_t own,
                  const std::string& thing,
                  std::vector<std::string>& notes) {
    std::string names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == own) continue;
        const std::string name = all[i].text("name");
        names += (names.empty() ? "" : ", ") + (name.empty() ? std::to_string(i) : name);
    }
    if (!names.empty()) notes.push_back(counted(all.size() - 1, "further " + thing) + ": " + names);
}

/// Throws Refusal, by name, if the file needs an extension that is not read. Notes those that it
/// uses, could be seen by, and are ignored.
void check_extensions(const GltfDocument& document, std::vector<std::string>& notes) {
    const JsonObject root = document.root();
    for (const std::string& name : root.texts("extensionsRequired")) {
        if (find_extension(name) == nullptr)
            root.refuse("it needs the extension " + name + ", which is not read");
    }
    std::string ignored;
    for (const std::string& name : root.texts("extensionsUsed")) {
        const Extension* known = find_extension(name);
        if (known != nullptr && known->heeded != Heeded::visible) continue;
        ignored += (ignored.empty() ? "" : ", ") + name;
    }
    if (!ignored.empty()) notes.push_back("not read: " + ignored);
}

/// The animations beside the one with number `animation`, and the scenes beside the one shown.
void note_choices(const GltfDocument& document,
                  std::size_t animation,
                  std::vector<std::string>& notes) {
    note_further(document.animations, animation, "animation", notes);
    const std::size_t scenes = document.scenes.size();
    if (scenes == 0) return;
    note_further(
        document.scenes, document.root().find_index("scene", scenes).value_or(0), "scene", notes);
}

/// Primitives of points or lines, those of triangles without any, and channels of animation that
/// move no node.
void note_left_out(std::size_t lines,
                   std::size_t empty_parts,
                   std::size_t pointers,
                   std::vector<std::string>& notes) {
    if (lines > 0) notes.push_back(counted(lines, "part") + " of points or lines left out");
    if (empty_parts > 0) notes.push_back(counted(empty_parts, "part") + " without a triangle");
    if (pointers > 0)
        notes.push_back(counted(pointers, "channel") + " of the animation at no node");
}

/// Materials through which one would see.
void note_materials(const GltfDocument& document,
                    const std::vector<ImportedMesh>& meshes,
                    std::vector<std::string>& notes) {
    std::set<std::uint32_t> used;
    for (const ImportedMesh& mesh : meshes)
        for (const MeshPart& part : mesh.parts)
            used.insert(part.material);
    for (const char* mode : {"BLEND", "MASK"}) {
        std::size_t count = 0;
        for (const std::uint32_t material : used)
            if (material < document.materials.size() &&
                document.materials[material].text("alphaMode") == mode)
                ++count;
        if (count > 0)
            notes.push_back(counted(count, "material") + " of " + mode + " drawn opaque");
    }
}

constexpr unsigned kSmallSigned = kByte | kShort;

/// A glTF file on its way into a reply.
class GltfReader {
  public:
    GltfReader(const GltfDocument& document,
               const ModelChoice& choice,
               std::vector<std::string> notes)
        : document_(document),
          buffers_(document),
          accessors_(document, buffers_),
          meshes_(document, buffers_, accessors_),
          tree_(read_tree(document)) {
        for (const JsonObject& one : document.animations)
            reply_.animation_names.push_back(one.text("name"));
        const std::size_t animation = choose_animation(reply_.animation_names, choice.animation);
        if (!document.animations.empty())
            moves_ = read_motion(document, animation, accessors_, tree_);
        reply_.notes = std::move(notes);
        note_choices(document, animation, reply_.notes);
    }

    [[nodiscard]] ImportReply read();

  private:
    struct Use;
    [[nodiscard]] std::string name_of(std::size_t node) const;
    [[nodiscard]] const GltfMesh& mesh(std::size_t index, bool has_bones);
    [[nodiscard]] std::optional<std::uint32_t> mesh_for(const Use& use);
    void take_shape(const Use& use, const GltfMesh& from, std::uint32_t number);
    void take_skin(const Use& use, const GltfMesh& from, std::uint32_t number);
    void place(const Use& use, std::uint32_t mesh);
    void take_camera(std::size_t node);
    [[nodiscard]] std::vector<glm::dmat4> instance_places(const JsonObject& attributes);

    const GltfDocument& document_;
    GltfBuffers buffers_;
    GltfAccessors accessors_;
    GltfMeshReader meshes_;
    GltfTree tree_;
    GltfMotion moves_;
    ImportReply reply_;
    scene::Animation motion_;
    std::map<std::pair<std::size_t, bool>, GltfMesh> read_meshes_;
    /// The reply's meshes that several nodes may share, by the file's and the shares of its
    /// targets.
    std::map<std::pair<std::size_t, std::vector<double>>, std::uint32_t> shared_;
};

/// A node's use of a mesh.
struct GltfReader::Use {
    std::size_t node = 0;  ///< of the file
    std::size_t mesh = 0;  ///< likewise
    std::optional<std::size_t> skin;
    std::vector<double> weights;  ///< of the mesh's targets, at rest
};

std::string GltfReader::name_of(std::size_t node) const {
    const std::string name = document_.nodes[node].text("name");
    return name.empty() ? "node " + std::to_string(node) : name;
}

const GltfMesh& GltfReader::mesh(std::size_t index, bool has_bones) {
    const auto [place, is_new] = read_meshes_.try_emplace({index, has_bones});
    if (!is_new) return place->second;
    place->second = meshes_.read_mesh(index, has_bones);
    return place->second;
}

/// Gives a mesh its targets if their shares move; else adds these here and now, in double.
void GltfReader::take_shape(const Use& use, const GltfMesh& from, std::uint32_t number) {
    const auto moving = moves_.weights.find(use.node);
    if (moving != moves_.weights.end()) {
        scene::Morph morph;
        morph.mesh = number;
        morph.targets = from.targets;
        for (std::size_t t = 0; t < morph.targets.size(); ++t)
            morph.targets[t].weight = use.weights[t];
        moving->second.share_out(morph.targets);
        motion_.morphs.push_back(std::move(morph));
        return;
    }
    ImportedMesh& to = reply_.meshes[number];
    std::vector<glm::dvec3> normals(to.normals.begin(), to.normals.end());
    for (std::size_t t = 0; t < from.targets.size(); ++t) {
        const scene::Morph::Target& target = from.targets[t];
        if (use.weights[t] == 0) continue;
        for (std::size_t v = 0; v < target.positions.size(); ++v)
            to.positions[v] += glm::dvec3(target.positions[v]) * use.weights[t];
        for (std::size_t v = 0; v < target.normals.size(); ++v)
            normals[v] += glm::dvec3(target.normals[v]) * use.weights[t];
    }
    to.normals.assign(normals.begin(), normals.end());
}

void GltfReader::take_skin(const Use& use, const GltfMesh& from, std::uint32_t number) {
    const JsonObject& json = document_.skins[*use.skin];
    const std::vector<std::size_t> joints = json.indices("joints", document_.nodes.size());
    scene::Skin skin;
    skin.mesh = number;
    for (const std::size_t joint : joints)
        skin.bones.push_back({tree_.number_of[joint], glm::dmat4(1)});
    if (const auto binds = json.find_index("inverseBindMatrices", accessors_.size())) {
        const std::vector<double> numbers =
            accessors_.numbers(*binds, {"inverseBindMatrices", "MAT4", kFloat});
        if (numbers.size() < 16 * joints.size()) {
            json.fail(
                "inverseBindMatrices has " + std::to_string(numbers.size() / 16) + " matrices",
                std::to_string(joints.size()) + ", one per joint");
        }
        for (std::size_t j = 0; j < joints.size(); ++j) {
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(16 * j);
            skin.bones[j].node_from_mesh = affine_matrix({first, first + 16}, json);
        }
    }
    for (const auto& weights : from.influences)
        for (const scene::BoneWeight& weight : weights) {
            if (weight.bone < joints.size()) continue;
            json.fail("mesh " + std::to_string(use.mesh) + " follows joint " +
                          std::to_string(weight.bone),
                      "one of " + std::to_string(joints.size()));
        }
    scene::set_weights(from.influences, skin);
    motion_.skins.push_back(std::move(skin));
}

/// The reply's mesh for a use; nothing if it has no triangle.
std::optional<std::uint32_t> GltfReader::mesh_for(const Use& use) {
    const GltfMesh& from = mesh(use.mesh, use.skin.has_value());
    if (from.mesh.triangles.empty()) return std::nullopt;
    const bool is_shared = !use.skin && !moves_.weights.contains(use.node);
    const std::pair key{use.mesh, use.weights};
    if (is_shared && shared_.contains(key)) return shared_[key];
    const auto number = static_cast<std::uint32_t>(reply_.meshes.size());
    reply_.meshes.push_back(from.mesh);
    take_shape(use, from, number);
    if (use.skin) take_skin(use, from, number);
    if (is_shared) shared_[key] = number;
    return number;
}

/// Where EXT_mesh_gpu_instancing puts the copies of a mesh, in its node.
std::vector<glm::dmat4> GltfReader::instance_places(const JsonObject& attributes) {
    struct Kind {
        AccessorRule rule;
        std::vector<double> fallback;
        std::vector<double> numbers;
    };
    std::array kinds{Kind{{"TRANSLATION", "VEC3", kFloat}, {0, 0, 0}, {}},
                     Kind{{"ROTATION", "VEC4", kFloat | kSmallSigned, true}, {0, 0, 0, 1}, {}},
                     Kind{{"SCALE", "VEC3", kFloat}, {1, 1, 1}, {}}};
    std::optional<std::size_t> count;
    for (Kind& kind : kinds) {
        const auto accessor = attributes.find_index(kind.rule.use, accessors_.size());
        if (!accessor) continue;
        kind.numbers = accessors_.numbers(*accessor, kind.rule);
        const std::size_t found = kind.numbers.size() / kind.fallback.size();
        if (count.value_or(found) != found) {
            attributes.fail(
                std::string(kind.rule.use) + " has " + std::to_string(found) + " elements",
                std::to_string(*count) + ", as the others");
        }
        count = found;
    }
    if (!count) attributes.fail("it places nothing", "TRANSLATION, ROTATION or SCALE");
    std::vector<glm::dmat4> places;
    for (std::size_t i = 0; i < *count; ++i) {
        const auto part = [&](const Kind& kind) {
            return kind.numbers.empty() ? kind.fallback.data()
                                        : kind.numbers.data() + i * kind.fallback.size();
        };
        const double *t = part(kinds[0]), *r = part(kinds[1]), *s = part(kinds[2]);
        const GltfPlace place{{t[0], t[1], t[2]},
                              unit_rotation({r[3], r[0], r[1], r[2]}, attributes),
                              {s[0], s[1], s[2]}};
        places.push_back(place.matrix());
    }
    return places;
}

void GltfReader::place(const Use& use, std::uint32_t mesh) {
    const JsonObject& json = document_.nodes[use.node];
    const auto add = [&](const glm::dmat4& world_from_object, std::uint32_t node) {
        reply_.instances.push_back({.mesh = mesh,
                                    .world_from_object = world_from_object,
                                    .name = name_of(use.node),
                                    .file_node = static_cast<std::uint32_t>(use.node)});
        motion_.node_of_instance.push_back(node);
    };
    const std::uint32_t number = tree_.number_of[use.node];
    if (const auto instancing = json.extension("EXT_mesh_gpu_instancing")) {
        if (use.skin) json.refuse("EXT_mesh_gpu_instancing of a mesh with a skin is not read");
        for (const glm::dmat4& node_from_object : instance_places(instancing->at("attributes"))) {
            const std::uint32_t own = tree_.add(number, node_from_object);
            add(tree_.world_from_node[own], own);
        }
    } else if (use.skin) {
        add(glm::dmat4(1), scene::kNoNode);  // its vertices are placed by the bones
    } else {
        add(tree_.world_from_node[number], number);
    }
}

namespace {

/// What an orthographic camera sees: ymag is half of it (glTF 2.0, section 3.10.3).
double height_of(const JsonObject& orthographic) {
    const double height = 2 * std::abs(orthographic.number("ymag"));
    if (!(height > 0)) orthographic.fail("ymag is 0", "a height above 0");
    return height;
}

}  // namespace

void GltfReader::take_camera(std::size_t node) {
    const auto number = document_.nodes[node].find_index("camera", document_.cameras.size());
    if (!number) return;
    const JsonObject& json = document_.cameras[*number];
    std::string name = document_.nodes[node].text("name");
    if (name.empty()) name = json.text("name");
    const std::string type = json.text("type");
    const bool is_parallel = type == "orthographic";
    if (!is_parallel && type != "perspective")
        json.fail("type is " + type, "perspective or orthographic");
    const std::uint32_t own = tree_.number_of[node];
    const glm::dmat4& world = tree_.world_from_node[own];
    const glm::dvec3 eye_world = world[3];
    reply_.cameras.push_back({.name = name,
                              .eye_world = eye_world,
                              .target_world = eye_world + glm::dmat3(world) * glm::dvec3(0, 0, -1),
                              .up_world = glm::dmat3(world) * glm::dvec3(0, 1, 0),
                              .fov_y_rad = is_parallel ? scene::Camera{}.fov_y_rad
                                                       : json.at("perspective").number("yfov"),
                              .node = own,
                              .height_world = is_parallel ? height_of(json.at(type.c_str())) : 0});
}

ImportReply GltfReader::read() {
    for (const std::size_t node : tree_.in_scene) {
        take_camera(node);
        const JsonObject& json = document_.nodes[node];
        const auto mesh_number = json.find_index("mesh", document_.meshes.size());
        if (!mesh_number || tree_.is_hidden[node]) continue;
        Use use{.node = node,
                .mesh = *mesh_number,
                .skin = json.find_index("skin", document_.skins.size()),
                .weights = {}};
        const GltfMesh& from = mesh(use.mesh, use.skin.has_value());
        const auto own = json.numbers("weights", from.targets.size());
        for (std::size_t t = 0; t < from.targets.size(); ++t)
            use.weights.push_back(own ? (*own)[t] : from.targets[t].weight);
        if (const auto number = mesh_for(use)) place(use, *number);
    }
    std::size_t lines = 0, empty_parts = 0;
    for (const auto& [key, one] : read_meshes_) {
        lines += one.lines_left_out;
        empty_parts += one.empty_parts;
    }
    note_left_out(lines, empty_parts, moves_.ignored_pointers, reply_.notes);
    note_materials(document_, reply_.meshes, reply_.notes);
    reply_.lights = read_lights(document_, tree_, reply_.notes);
    motion_.nodes = std::move(tree_.nodes);
    motion_.duration_s = moves_.duration_s;
    if (motion_.duration_s > 0 || !motion_.skins.empty() || !motion_.morphs.empty())
        reply_.animation = std::move(motion_);
    return std::move(reply_);
}

}  // namespace

ImportReply read_gltf(const GltfDocument& document, const ModelChoice& choice) {
    std::vector<std::string> notes;
    check_extensions(document, notes);
    return GltfReader(document, choice, std::move(notes)).read();
}

std::optional<ImportReply> read_gltf(const std::filesystem::path& path, const ModelChoice& choice) {
    const auto document = open_gltf(path);
    if (!document) return std::nullopt;
    return read_gltf(*document, choice);
}

}  // namespace ink::import
