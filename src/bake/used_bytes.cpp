#include "bake/used_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ink::bake {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMost = std::size_t{1} << 40;

/// A whole number; nothing for what is none.
std::optional<std::size_t> whole(const Json& number) {
    if (!number.is_number_integer()) return std::nullopt;
    const bool is_good = number.is_number_unsigned() || number.get<std::int64_t>() >= 0;
    if (!is_good || number.get<std::size_t>() > kMost) return std::nullopt;
    return number.get<std::size_t>();
}

/// A whole number, `fallback` where there is none; nothing for what is no such number.
std::optional<std::size_t> whole(const Json& owner, const char* key, std::size_t fallback) {
    if (!owner.is_object()) return std::nullopt;
    const auto found = owner.find(key);
    if (found == owner.end()) return fallback;
    return whole(*found);
}

/// Bytes of an element; nothing for a type that is not known.
std::optional<std::size_t> element_bytes(const Json& accessor) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 4> kWidths{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}}};
    const auto type = accessor.find("type");
    const auto component = whole(accessor, "componentType", 0);
    if (type == accessor.end() || !component) return std::nullopt;
    for (const auto& [name, width] : kWidths) {
        if (*type != name) continue;
        const bool is_byte = *component == 5120 || *component == 5121;
        const bool is_short = *component == 5122 || *component == 5123;
        return width * (is_byte ? 1 : is_short ? 2 : 4);
    }
    return std::nullopt;
}

/// What uses a buffer, piece by piece.
class Uses {
  public:
    Uses(const Json& gltf, std::size_t buffer, const std::set<std::size_t>& left_out)
        : buffer_(buffer), left_out_(left_out) {
        const auto views = gltf.find("bufferViews");
        if (views != gltf.end()) views_ = &*views;
        for (const auto& [key, value] : gltf.items()) {
            if (key == "bufferViews") {
                for (const Json& view : value)
                    add_packed(view);
            } else if (key == "accessors") {
                for (const Json& accessor : value)
                    add_accessor(accessor);
            } else {
                add_views_in(value);
            }
        }
    }

    [[nodiscard]] bool is_sound() const { return is_sound_; }
    [[nodiscard]] std::vector<ByteRange> merged() {
        std::ranges::sort(ranges_, {}, &ByteRange::first);
        std::vector<ByteRange> merged;
        for (const ByteRange& range : ranges_) {
            if (!merged.empty() && range.first <= merged.back().end)
                merged.back().end = std::max(merged.back().end, range.end);
            else
                merged.push_back(range);
        }
        return merged;
    }

  private:
    /// The range of a view, or of what packs one; nothing if it is of another buffer.
    std::optional<ByteRange> range_of(const Json& part) {
        const auto of = whole(part, "buffer", kMost);
        const auto first = whole(part, "byteOffset", 0);
        const auto size = whole(part, "byteLength", 0);
        if (!of || !first || !size) {
            is_sound_ = false;
            return std::nullopt;
        }
        if (*of != buffer_) return std::nullopt;
        return ByteRange{*first, *first + *size};
    }

    void add_packed(const Json& view) {
        if (!view.is_object() || !view.contains("extensions")) return;
        for (const Json& extension : view["extensions"]) {
            if (!extension.is_object() || !extension.contains("buffer")) continue;
            if (const auto range = range_of(extension)) ranges_.push_back(*range);
        }
    }

    [[nodiscard]] const Json* view_of(const Json& owner) {
        const auto number = whole(owner, "bufferView", kMost);
        is_sound_ = is_sound_ && number && views_ != nullptr && *number < views_->size();
        return !is_sound_ || left_out_.contains(*number) ? nullptr : &(*views_)[*number];
    }

    void add_views_in(const Json& json) {
        if (json.is_object() && json.contains("bufferView")) {
            if (const Json* view = view_of(json))
                if (const auto range = range_of(*view)) ranges_.push_back(*range);
        }
        if (!json.is_structured()) return;
        for (const Json& value : json)
            add_views_in(value);
    }

    void add_accessor(const Json& accessor) {
        if (!accessor.is_object()) {
            is_sound_ = false;
            return;
        }
        for (const auto& [key, value] : accessor.items())
            add_views_in(value);  // of sparse ones
        if (!accessor.contains("bufferView")) return;
        const Json* view = view_of(accessor);
        if (view == nullptr) return;
        const auto range = range_of(*view);
        if (!range) return;
        const auto size = element_bytes(accessor);
        const auto stride = whole(*view, "byteStride", size.value_or(0));
        const auto offset = whole(accessor, "byteOffset", 0);
        const auto count = whole(accessor, "count", 0);
        if (!size || !stride || !offset || !count || *count == 0) {
            ranges_.push_back(*range);
            return;
        }
        const std::size_t first = range->first + *offset;
        ranges_.push_back({first, first + (*count - 1) * *stride + *size});
    }

    std::size_t buffer_;
    const std::set<std::size_t>& left_out_;
    const Json* views_ = nullptr;
    std::vector<ByteRange> ranges_;
    bool is_sound_ = true;
};

}  // namespace

bool knows_all_references(const Json& gltf) {
    constexpr std::array<std::string_view, 8> kKnown{"EXT_mesh_gpu_instancing",
                                                     "EXT_mesh_primitive_edge_visibility",
                                                     "EXT_meshopt_compression",
                                                     "EXT_texture_avif",
                                                     "EXT_texture_webp",
                                                     "EXT_mesh_features",
                                                     "MSFT_texture_dds",
                                                     "FB_ngon_encoding"};
    const auto used = gltf.find("extensionsUsed");
    return used == gltf.end() || std::ranges::all_of(*used, [&](const Json& name) {
               const bool is_khronos =
                   name.is_string() && name.get_ref<const std::string&>().starts_with("KHR_");
               return is_khronos ||
                      std::ranges::any_of(kKnown, [&](auto known) { return name == known; });
           });
}

std::vector<ByteRange> used_bytes(const Json& gltf,
                                  std::size_t buffer,
                                  std::size_t size,
                                  const std::set<std::size_t>& left_out) {
    Uses uses(gltf, buffer, left_out);
    if (!uses.is_sound()) return {{0, size}};
    return uses.merged();
}

std::vector<ByteRange> without(const std::vector<ByteRange>& all,
                               const std::vector<ByteRange>& taken) {
    std::vector<ByteRange> left;
    auto next = taken.begin();
    for (ByteRange range : all) {
        while (next != taken.end() && next->end <= range.first)
            ++next;
        for (auto cut = next; cut != taken.end() && cut->first < range.end; ++cut) {
            if (cut->first > range.first) left.push_back({range.first, cut->first});
            range.first = std::max(range.first, cut->end);
        }
        if (range.first < range.end) left.push_back(range);
    }
    return left;
}

std::vector<std::size_t> accessor_uses(const Json& gltf) {
    const auto accessors = gltf.find("accessors");
    std::vector<std::size_t> uses(accessors == gltf.end() ? 0 : accessors->size(), 0);
    const auto count = [&](const Json& number) {
        const auto accessor = whole(number);
        if (accessor && *accessor < uses.size()) ++uses[*accessor];
    };
    const auto count_all = [&](const Json& owner, const char* key) {
        if (!owner.is_object() || !owner.contains(key)) return;
        const Json& numbers = owner[key];
        if (!numbers.is_structured()) return count(numbers);
        for (const Json& number : numbers)
            count(number);
    };
    const auto each = [](const Json& owner, const char* key, const auto& visit) {
        if (!owner.is_object() || !owner.contains(key)) return;
        for (const Json& one : owner[key])
            visit(one);
    };
    each(gltf, "meshes", [&](const Json& mesh) {
        each(mesh, "primitives", [&](const Json& primitive) {
            count_all(primitive, "attributes");
            count_all(primitive, "indices");
            each(primitive, "targets", [&](const Json& target) {
                for (const Json& number : target)
                    count(number);
            });
            each(primitive, "extensions", [&](const Json& extension) {
                for (const Json& number : extension)
                    count(number);
                each(extension, "lineStrings", [&](const Json& line) {
                    count_all(line, "indices");
                });
            });
        });
    });
    each(gltf, "skins", [&](const Json& skin) { count_all(skin, "inverseBindMatrices"); });
    each(gltf, "animations", [&](const Json& animation) {
        each(animation, "samplers", [&](const Json& sampler) {
            count_all(sampler, "input");
            count_all(sampler, "output");
        });
    });
    each(gltf, "nodes", [&](const Json& node) {
        each(
            node, "extensions", [&](const Json& extension) { count_all(extension, "attributes"); });
    });
    return uses;
}

}  // namespace ink::bake
