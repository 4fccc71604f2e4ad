#include "bake/code_attributes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <set>

#include "bake/flat_codes.h"
#include "core/disjoint_sets.h"
#include "core/error.h"

namespace ink::bake {
namespace {

using Group = std::vector<BakedPrimitive*>;

constexpr std::size_t kWord_bytes = 4;  // at a multiple of which every vertex begins
constexpr int kUnsignedByte = 5121, kUnsignedShort = 5123, kUnsignedInt = 5125;

/// The attributes that an earlier run wrote: _INK and what lies on the same bytes.
std::set<std::string> own_attributes(const GltfEdit& edit, const BakedPrimitive& primitive) {
    std::set<std::string> own;
    if (!primitive.source.has(kInk)) return own;
    const auto& accessors = edit.document().accessors;
    const import::JsonObject& ink = accessors[primitive.source.accessor(kInk)];
    own.insert(kInk);
    for (int n = 0; n < 3; ++n) {
        const std::string name = fmt::format("TEXCOORD_{}", n);
        if (primitive.source.has(name.c_str()) &&
            ink.is_same("bufferView", accessors[primitive.source.accessor(name.c_str())]))
            own.insert(name);
    }
    return own;
}

/// Takes away what an earlier run wrote; throws if another program did.
void clear_own(GltfEdit& edit, const BakedPrimitive& primitive, bool is_ours) {
    Json& attributes = primitive.json(edit)["attributes"];
    for (const std::string& name : own_attributes(edit, primitive)) {
        if (!is_ours) {
            throw core::Error(primitive.place(),
                              primitive.place() + ": it has an attribute _INK of its own",
                              "a model without, or one that inkbench has baked");
        }
        attributes.erase(name);
    }
}

/// Primitives that share a vertex attribute: what one splits, all do.
std::vector<Group> groups_of(GltfEdit& edit, std::vector<BakedPrimitive>& primitives) {
    // Sets of primitives; an accessor, or Draco's stream, joins those that have it.
    core::DisjointSets sets(primitives.size());
    std::map<std::pair<bool, std::size_t>, std::uint32_t> first;
    for (std::uint32_t i = 0; i < primitives.size(); ++i) {
        const import::GltfPrimitive& source = primitives[i].source;
        const auto join = [&](bool is_draco, std::size_t number) {
            const auto [known, is_new] = first.try_emplace({is_draco, number}, i);
            if (!is_new) sets.join(i, known->second);
        };
        if (const auto packed = source.json().extension(import::kDracoMesh)) {
            join(true, packed->index("bufferView", edit.document().buffer_views.size()));
            continue;
        }
        for (const auto& [name, value] : primitives[i].json(edit)["attributes"].items())
            join(false, source.accessor(name.c_str()));
    }
    std::map<std::uint32_t, Group> groups;
    for (std::uint32_t i = 0; i < primitives.size(); ++i)
        groups[sets.root(i)].push_back(&primitives[i]);
    std::vector<Group> list;
    for (auto& [root, group] : groups) {
        for (const BakedPrimitive* primitive : group) {
            if (primitive->source.vertices() == group[0]->source.vertices()) continue;
            throw core::Error(
                primitive->place(),
                fmt::format(
                    "{}: it has {} vertices", primitive->place(), primitive->source.vertices()),
                fmt::format("{}, as {} with the same attributes",
                            group[0]->source.vertices(),
                            group[0]->place()));
        }
        list.push_back(std::move(group));
    }
    return list;
}

FlatCodes flat_codes_of(const Group& group, std::span<const std::uint32_t> codes) {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint64_t> of_triangles;
    for (const BakedPrimitive* primitive : group) {
        for (const scene::Triangle& triangle : primitive->triangles)
            indices.insert(indices.end(), triangle.begin(), triangle.end());
        const auto first = codes.begin() + static_cast<std::ptrdiff_t>(primitive->first_triangle);
        of_triangles.insert(of_triangles.end(),
                            first,
                            first + static_cast<std::ptrdiff_t>(primitive->triangles.size()));
    }
    return flat_codes(indices, group[0]->source.vertices(), of_triangles);
}

/// Elements of so many bytes, each at a multiple of 4: the vertices of the result.
std::vector<std::byte> spread_out(const std::vector<std::byte>& elements,
                                  std::size_t element_bytes,
                                  const std::vector<std::uint32_t>& source_vertex) {
    const std::size_t stride = (element_bytes + kWord_bytes - 1) / kWord_bytes * kWord_bytes;
    std::vector<std::byte> result(stride * source_vertex.size());
    for (std::size_t v = 0; v < source_vertex.size(); ++v)
        std::memcpy(
            &result[v * stride], &elements[source_vertex[v] * element_bytes], element_bytes);
    return result;
}

/// Attributes of a group on the way to their new vertices.
class Splitter {
  public:
    Splitter(GltfEdit& edit, const Group& group, const std::vector<std::uint32_t>& source_vertex)
        : edit_(edit),
          source_vertex_(source_vertex),
          vertices_before_(group[0]->source.vertices()) {
        for (const BakedPrimitive* primitive : group) {
            for (const auto& [name, accessor] : primitive->json(edit)["attributes"].items())
                ++uses_[primitive->source.accessor(name.c_str())];
            const auto targets = primitive->source.json().list("targets", "target");
            for (std::size_t t = 0; t < targets.size(); ++t)
                for (const auto& [name, accessor] : primitive->json(edit)["targets"][t].items())
                    ++uses_[targets[t].index(name.c_str(), edit.accessors().size())];
        }
    }

    void split(const BakedPrimitive& primitive) {
        Json& json = primitive.json(edit_);
        import::GltfPrimitive source = primitive.source;
        for (auto& [name, accessor] : json["attributes"].items()) {
            const std::size_t from = source.accessor(name.c_str());
            if (!known_.contains(from)) known_[from] = add(from, source.components(name.c_str()));
            accessor = known_[from];
        }
        const auto targets = source.json().list("targets", "target");
        for (std::size_t t = 0; t < targets.size(); ++t) {
            for (auto& [name, accessor] : json["targets"][t].items()) {
                const std::size_t from = targets[t].index(name.c_str(), edit_.accessors().size());
                if (!known_.contains(from)) known_[from] = add_target(targets[t], name, from);
                accessor = known_[from];
            }
        }
    }

  private:
    std::size_t add_target(const import::JsonObject& target,
                           const std::string& name,
                           std::size_t from) {
        const std::size_t count = edit_.accessors().count(from);
        if (count != vertices_before_)
            target.fail(fmt::format("{} has {} elements", name, count),
                        fmt::format("{}, as the primitive", vertices_before_));
        return add(from, edit_.accessors().components(from));
    }

    /// What came out of a stream is not to the digit what its accessor said of it.
    static void set_bounds(const std::vector<double>& components,
                           std::size_t width,
                           Json& accessor) {
        if (!accessor.contains("min") && !accessor.contains("max")) return;
        std::vector<double> low(width, std::numeric_limits<double>::infinity()), high(width);
        std::transform(low.begin(), low.end(), high.begin(), std::negate<>());
        for (std::size_t i = 0; i < components.size(); ++i) {
            low[i % width] = std::min(low[i % width], components[i]);
            high[i % width] = std::max(high[i % width], components[i]);
        }
        accessor["min"] = low;
        accessor["max"] = high;
    }

    std::size_t add(std::size_t from, const std::vector<double>& components) {
        const std::size_t size = edit_.accessors().element_bytes(from);
        const auto bytes =
            spread_out(edit_.accessors().packed(from, components), size, source_vertex_);
        const bool is_in_buffer = edit_.accessors().json(from).has("bufferView");
        const bool has_gaps = size % kWord_bytes != 0;
        const std::size_t view =
            edit_.add_view(bytes,
                           has_gaps ? (size + kWord_bytes - 1) / kWord_bytes * kWord_bytes : 0,
                           GltfEdit::Use::vertices);
        Json accessor = edit_.json()["accessors"][from];
        accessor.erase("sparse");
        accessor.erase("byteOffset");
        accessor["bufferView"] = view;
        accessor["count"] = source_vertex_.size();
        if (!is_in_buffer) set_bounds(components, edit_.accessors().width(from), accessor);
        return edit_.replace_accessor(from, uses_.at(from), std::move(accessor));
    }

    GltfEdit& edit_;
    std::map<std::size_t, std::size_t> uses_;  ///< of accessors, in the group
    const std::vector<std::uint32_t>& source_vertex_;
    std::size_t vertices_before_;
    std::map<std::size_t, std::size_t> known_;
};

template <class T>
std::vector<std::byte> bytes_of(const std::vector<scene::Triangle>& triangles) {
    std::vector<T> indices;
    for (const scene::Triangle& triangle : triangles)
        for (const std::uint32_t vertex : triangle)
            indices.push_back(static_cast<T>(vertex));
    const auto bytes = std::as_bytes(std::span(indices));
    return {bytes.begin(), bytes.end()};
}

/// The smallest type from `least` on that holds the indices; its highest number means no vertex.
int index_type(const std::vector<scene::Triangle>& triangles, int least) {
    std::uint32_t highest = 0;
    for (const scene::Triangle& triangle : triangles)
        highest = std::max(highest, *std::max_element(triangle.begin(), triangle.end()));
    if (highest >= std::numeric_limits<std::uint16_t>::max()) return kUnsignedInt;
    if (highest >= std::numeric_limits<std::uint8_t>::max()) return std::max(least, kUnsignedShort);
    return least;
}

/// Writes the primitive's triangles as mode 4.
void write_indices(GltfEdit& edit, const BakedPrimitive& primitive) {
    const import::JsonObject& source = primitive.source.json();
    int least = kUnsignedShort;  // bytes are slow on GPUs
    if (const auto before = source.find_index("indices", edit.accessors().size())) {
        const auto type = edit.accessors().json(*before).whole("componentType", kUnsignedInt);
        least = static_cast<int>(type);
    }
    const int type = index_type(primitive.triangles, least);
    const std::vector<std::byte> bytes =
        type == kUnsignedByte    ? bytes_of<std::uint8_t>(primitive.triangles)
        : type == kUnsignedShort ? bytes_of<std::uint16_t>(primitive.triangles)
                                 : bytes_of<std::uint32_t>(primitive.triangles);
    Json& json = primitive.json(edit);
    Json accessor = {{"bufferView", edit.add_view(bytes, 0, GltfEdit::Use::indices)},
                     {"componentType", type},
                     {"count", 3 * primitive.triangles.size()},
                     {"type", "SCALAR"}};
    const auto old = source.find_index("indices", edit.accessors().size());
    json["indices"] = old ? edit.replace_accessor(*old, 1, std::move(accessor))
                          : edit.add_accessor(std::move(accessor));
    if (json.contains("mode")) json["mode"] = 4;
}

/// Gives a primitive its triangles of the result; whether these are others than it had.
bool take_triangles(BakedPrimitive& primitive, std::span<const std::uint32_t> indices) {
    bool is_changed = false;
    for (std::size_t t = 0; t < primitive.triangles.size(); ++t) {
        const scene::Triangle before = primitive.triangles[t];
        scene::Triangle& after = primitive.triangles[t];
        std::copy_n(indices.begin() + static_cast<std::ptrdiff_t>(3 * t), 3, after.begin());
        is_changed |= after != before;
    }
    return is_changed;
}

/// Puts the codes on the primitive, by accessors on one bufferView.
void put_codes(GltfEdit& edit,
               const BakedPrimitive& primitive,
               std::size_t ink,
               std::optional<std::size_t> texcoord,
               int channel,
               CodeCounts& counts) {
    Json& attributes = primitive.json(edit)["attributes"];
    attributes[kInk] = ink;
    if (!texcoord) return;
    const std::string name = fmt::format("TEXCOORD_{}", channel);
    if (attributes.contains(name)) {
        throw core::Error(primitive.place(),
                          fmt::format("{}: {} is taken", primitive.place(), name),
                          channel == 1 ? "--channel texcoord2, or none" : "no --channel");
    }
    bool is_filled = false;
    for (int n = 0; n < channel; ++n)
        is_filled |= attributes.emplace(fmt::format("TEXCOORD_{}", n), *texcoord).second;
    attributes[name] = *texcoord;
    counts.filled += is_filled;
}

void bake_group(GltfEdit& edit,
                const Group& group,
                std::span<const std::uint32_t> codes,
                int channel,
                CodeCounts& counts) {
    const FlatCodes flat = flat_codes_of(group, codes);
    const std::size_t before = group[0]->source.vertices();
    const bool is_draco = group[0]->source.is_packed();
    counts.vertices += before;
    counts.added += flat.added_count(before);

    Splitter splitter(edit, group, flat.source_vertex);
    std::span<const std::uint32_t> indices(flat.indices);
    for (BakedPrimitive* primitive : group) {
        if (is_draco || flat.added_count(before) > 0) splitter.split(*primitive);
        const std::size_t count = 3 * primitive->triangles.size();
        Json& json = primitive->json(edit);
        const bool is_strip = !is_draco && json.value("mode", 4) != 4;
        const auto own = indices.first(count);
        for (std::size_t t = 0; t < primitive->triangles.size(); ++t) {
            // The first corner's old vertex says how the triangle was turned.
            const auto& old = primitive->triangles[t];
            for (std::uint8_t turn = 0; turn < 3; ++turn) {
                bool is_it = true;
                for (std::size_t i = 0; i < 3; ++i)
                    is_it &= old[(i + turn) % 3] == flat.source_vertex[own[3 * t + i]];
                if (!is_it) continue;
                primitive->turns[t] = turn;
                break;
            }
        }
        if (take_triangles(*primitive, own) || is_draco || is_strip)
            write_indices(edit, *primitive);
        indices = indices.subspan(count);
        counts.unstripped += is_strip;
        counts.undraco += is_draco;
        if (!is_draco) continue;
        json["extensions"].erase(import::kDracoMesh);
        if (json["extensions"].empty()) json.erase("extensions");
    }

    std::vector<std::byte> bytes(kWord_bytes * flat.codes.size(), std::byte{0});
    for (std::size_t v = 0; v < flat.codes.size(); ++v)
        bytes[kWord_bytes * v] = static_cast<std::byte>(flat.codes[v]);
    const std::size_t view = edit.add_view(bytes, kWord_bytes, GltfEdit::Use::vertices);
    const std::size_t ink = edit.add_accessor({{"bufferView", view},
                                               {"componentType", kUnsignedByte},
                                               {"count", flat.codes.size()},
                                               {"type", "SCALAR"}});
    std::optional<std::size_t> texcoord;
    if (channel > 0)
        texcoord = edit.add_accessor({{"bufferView", view},
                                      {"componentType", kUnsignedByte},
                                      {"normalized", true},
                                      {"count", flat.codes.size()},
                                      {"type", "VEC2"}});
    for (const BakedPrimitive* primitive : group)
        put_codes(edit, *primitive, ink, texcoord, channel, counts);
}

/// Whether any primitive of the file is still packed by Draco: those of meshes in no scene.
bool has_draco(const Json& gltf) {
    for (const Json& mesh : gltf.value("meshes", Json::array()))
        for (const Json& primitive : mesh.value("primitives", Json::array()))
            if (primitive.contains("extensions") &&
                primitive["extensions"].contains(import::kDracoMesh))
                return true;
    return false;
}

}  // namespace

CodeCounts add_codes(GltfEdit& edit,
                     std::vector<BakedPrimitive>& primitives,
                     std::span<const std::uint32_t> codes,
                     const CodeChannel& channel) {
    CodeCounts counts;
    for (const BakedPrimitive& primitive : primitives)
        clear_own(edit, primitive, channel.is_again);
    for (const Group& group : groups_of(edit, primitives))
        bake_group(edit, group, codes, channel.texcoord, counts);
    if (counts.undraco > 0 && !has_draco(edit.json())) edit.drop_extension(import::kDracoMesh);
    return counts;
}

}  // namespace ink::bake
