#include "entrants/view_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include <set>
#include <span>
#include <string>

#include "core/whole_file.h"
#include "import/gltf/document.h"

namespace ink::entrants {
namespace {

using Json = nlohmann::ordered_json;

std::uint32_t material_of(const scene::Mesh& mesh, std::size_t triangle) {
    return mesh.materials.empty() ? 0 : mesh.materials[triangle];
}

/// A name that stays one word in an OBJ.
std::string one_word(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= ' ' || c == 127; }, '_');
    return name.empty() ? "object" : name;
}

/// The binary chunk of a GLB and what describes it.
class GlbBuffer {
  public:
    static constexpr int kFloat = 5126;
    static constexpr int kUint32 = 5125;
    static constexpr int kVertices = 34962;
    static constexpr int kIndices = 34963;

    /// Adds values and an accessor to them; returns its index.
    template <class T>
    int add(std::span<const T> values, const char* type, int component, int target) {
        static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
        const std::size_t offset = bytes_.size();
        const auto* data = reinterpret_cast<const char*>(values.data());
        bytes_.append(data, values.size_bytes());  // all types are of whole words: aligned
        views_.push_back({{"buffer", 0},
                          {"byteOffset", offset},
                          {"byteLength", values.size_bytes()},
                          {"target", target}});
        accessors_.push_back({{"bufferView", views_.size() - 1},
                              {"componentType", component},
                              {"count", values.size()},
                              {"type", type}});
        return static_cast<int>(accessors_.size()) - 1;
    }

    int add_positions(const std::vector<glm::vec3>& positions) {
        const int index = add(std::span(positions), "VEC3", kFloat, kVertices);
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 most(std::numeric_limits<float>::lowest());
        for (const glm::vec3& p : positions) {
            least = glm::min(least, p);
            most = glm::max(most, p);
        }
        accessors_.back()["min"] = {least.x, least.y, least.z};
        accessors_.back()["max"] = {most.x, most.y, most.z};
        return index;
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    void describe(Json& gltf) const {
        gltf["accessors"] = accessors_;
        gltf["bufferViews"] = views_;
        gltf["buffers"] = {{{"byteLength", bytes_.size()}}};
    }

  private:
    std::string bytes_;
    Json views_ = Json::array();
    Json accessors_ = Json::array();
};

/// Triangles by material, each in the order of the mesh.
std::map<std::uint32_t, std::vector<std::uint32_t>> indices_by_material(const scene::Mesh& mesh) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> indices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const scene::Triangle& triangle = mesh.triangles[t];
        auto& of_material = indices[material_of(mesh, t)];
        of_material.insert(of_material.end(), triangle.begin(), triangle.end());
    }
    return indices;
}

Json mesh_json(const scene::Mesh& mesh,
               std::span<const glm::vec2> texcoords,
               const std::map<std::uint32_t, int>& materials,
               GlbBuffer& buffer) {
    Json attributes = {{"POSITION", buffer.add_positions(mesh.positions)}};
    if (!mesh.normals.empty()) {
        attributes["NORMAL"] =
            buffer.add(std::span(mesh.normals), "VEC3", GlbBuffer::kFloat, GlbBuffer::kVertices);
    }
    if (!texcoords.empty()) {
        attributes["TEXCOORD_0"] =
            buffer.add(texcoords, "VEC2", GlbBuffer::kFloat, GlbBuffer::kVertices);
    }
    Json primitives = Json::array();
    for (const auto& [material, indices] : indices_by_material(mesh)) {
        primitives.push_back({{"attributes", attributes},
                              {"indices",
                               buffer.add(std::span<const std::uint32_t>(indices),
                                          "SCALAR",
                                          GlbBuffer::kUint32,
                                          GlbBuffer::kIndices)},
                              {"material", materials.at(material)}});
    }
    return {{"name", mesh.name}, {"primitives", primitives}};
}

/// Dull, of that colour: metal is black where a scene has nothing round it. Nothing is wholly
/// clear: a file that says so means the opposite.
void set_color(const glm::vec4& color, Json& material) {
    const float opacity = color.a > 0 ? color.a : 1;
    material["pbrMetallicRoughness"] = {
        {"baseColorFactor", {color.r, color.g, color.b, opacity}},
        {"metallicFactor", 0},
    };
    if (opacity < 1) material["alphaMode"] = "BLEND";
}

/// Numbers of materials -> their places in the file.
std::map<std::uint32_t, int> material_places(const scene::Scene& scene) {
    std::set<std::uint32_t> numbers;
    for (const scene::Mesh& mesh : scene.meshes) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            numbers.insert(material_of(mesh, t));
    }
    std::map<std::uint32_t, int> places;
    for (const std::uint32_t number : numbers)
        places.emplace(number, static_cast<int>(places.size()));
    return places;
}

glm::dmat4 world_from_view(const scene::Camera& camera) {
    glm::dmat4 matrix(glm::transpose(camera.view_from_world));
    matrix[3] = glm::dvec4(camera.eye_world, 1);
    return matrix;
}

/// glTF 2.0, section 3.10: magnifications are half of what is seen.
Json camera_json(const scene::View& view) {
    const scene::Camera& camera = view.camera;
    const double aspect = static_cast<double>(view.width_px) / view.height_px;
    Json lens = {{"znear", camera.near}, {"zfar", camera.far}};
    if (camera.is_parallel()) {
        lens["xmag"] = camera.height_world / 2 * aspect;
        lens["ymag"] = camera.height_world / 2;
    } else {
        lens["yfov"] = camera.fov_y_rad;
        lens["aspectRatio"] = aspect;
    }
    const char* type = camera.is_parallel() ? "orthographic" : "perspective";
    return {{"type", type}, {type, lens}};
}

}  // namespace

void write_obj(const scene::Scene& scene, const std::filesystem::path& path) {
    std::string text =
        fmt::format("# {}: world space, y up; objects in the order of their ids\n", scene.name);
    const auto out = std::back_inserter(text);
    const glm::dvec3& o = scene.origin;
    if (o != glm::dvec3(0))
        fmt::format_to(out, "# origin {} {} {}: to be added to every place\n", o.x, o.y, o.z);
    std::size_t first = 1;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        fmt::format_to(out, "o {}\n", one_word(instance.name));
        for (const glm::vec3& p_object : mesh.positions) {
            const glm::dvec3 p = scene::to_world(instance, p_object);
            fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
        }
        const bool is_mirrored = scene::is_mirrored(instance);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (t == 0 || material_of(mesh, t) != material_of(mesh, t - 1))
                fmt::format_to(out, "usemtl material_{}\n", material_of(mesh, t));
            auto [a, b, c] = mesh.triangles[t];
            if (is_mirrored) std::swap(b, c);
            fmt::format_to(out, "f {} {} {}\n", first + a, first + b, first + c);
        }
        first += mesh.positions.size();
    }
    core::write_whole_file(path, text);
}

void write_glb(const scene::Scene& scene,
               std::span<const scene::View> views,
               const std::filesystem::path& path,
               std::span<const glm::vec4> base_colors,
               std::span<const std::vector<glm::vec2>> texcoords) {
    GlbBuffer buffer;
    Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "inkbench"}}}, {"scene", 0}};
    const auto places = material_places(scene);
    const glm::dvec3& o = scene.origin;
    if (o != glm::dvec3(0)) gltf["asset"]["extras"] = {{"origin", {o.x, o.y, o.z}}};
    Json materials = Json::array();
    for (const auto& [number, place] : places) {
        materials.push_back({{"name", fmt::format("material_{}", number)},
                             {"doubleSided", true},
                             {"extras", {{"material", number}}}});
        const bool has_color = number < base_colors.size();
        set_color(has_color ? base_colors[number] : glm::vec4(1), materials.back());
    }
    Json meshes = Json::array();
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        const auto own = texcoords.empty() ? std::span<const glm::vec2>() : texcoords[m];
        meshes.push_back(mesh_json(scene.meshes[m], own, places, buffer));
    }
    Json nodes = Json::array();
    Json roots = Json::array();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const double* matrix = glm::value_ptr(instance.world_from_object);
        nodes.push_back({{"name", instance.name},
                         {"mesh", instance.mesh},
                         {"matrix", std::vector<double>(matrix, matrix + 16)},
                         {"extras", {{"object", i}}}});
        roots.push_back(i);
    }
    Json cameras = Json::array();
    for (const scene::View& view : views) {
        const glm::dmat4 matrix = world_from_view(view.camera);
        nodes.push_back(
            {{"name", view.camera.name},
             {"camera", cameras.size()},
             {"matrix", std::vector<double>(glm::value_ptr(matrix), glm::value_ptr(matrix) + 16)}});
        roots.push_back(nodes.size() - 1);
        cameras.push_back(camera_json(view));
    }
    if (!cameras.empty()) gltf["cameras"] = cameras;
    gltf["scenes"] = {{{"name", scene.name}, {"nodes", roots}}};
    gltf["nodes"] = nodes;
    gltf["meshes"] = meshes;
    gltf["materials"] = materials;
    buffer.describe(gltf);

    const std::string json = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
    core::write_whole_file(path, import::glb_bytes(json, buffer.bytes(), path));
}

}  // namespace ink::entrants
