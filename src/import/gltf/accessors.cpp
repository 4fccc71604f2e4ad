#include "import/gltf/accessors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string_view>

namespace ink::import {
namespace {

constexpr std::uint64_t kMostElements = std::uint64_t{1} << 32;

struct Component {
    std::uint64_t code;
    std::size_t bytes;
    GltfComponents bit;
    double divisor;  ///< of normalised ones
};

constexpr std::array kComponents{Component{5120, 1, kByte, 127},
                                 Component{5121, 1, kUnsignedByte, 255},
                                 Component{5122, 2, kShort, 32767},
                                 Component{5123, 2, kUnsignedShort, 65535},
                                 Component{5125, 4, kUnsignedInt, 4294967295},
                                 Component{5126, 4, kFloat, 1}};

std::string codes_of(unsigned components) {
    std::string codes;
    for (const Component& component : kComponents)
        if ((components & component.bit) != 0)
            codes += (codes.empty() ? "" : ", ") + std::to_string(component.code);
    return codes;
}

Component component_of(const JsonObject& json) {
    const std::uint64_t code = json.whole("componentType", ~std::uint64_t{0});
    for (const Component& component : kComponents)
        if (component.code == code) return component;
    json.fail("componentType is " + std::to_string(code), codes_of(~0U));
}

std::size_t width_of(const JsonObject& json) {
    constexpr std::array<std::pair<std::string_view, std::size_t>, 5> kTypes{
        {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};
    const std::string type = json.text("type");
    for (const auto& [name, width] : kTypes)
        if (name == type) return width;
    json.fail("type is " + type, "SCALAR, VEC2, VEC3, VEC4 or MAT4");
}

/// Calls `use` with a number of the component's type.
template <class Use>
void with_number(GltfComponents type, const Use& use) {
    switch (type) {
        case kByte:
            return use(std::int8_t{});
        case kUnsignedByte:
            return use(std::uint8_t{});
        case kShort:
            return use(std::int16_t{});
        case kUnsignedShort:
            return use(std::uint16_t{});
        case kUnsignedInt:
            return use(std::uint32_t{});
        case kFloat:
            return use(float{});
    }
}

/// Elements of `width` components of a type that begin every `stride` bytes.
template <class Out>
void take(GltfComponents type,
          const std::byte* from,
          std::size_t stride,
          std::size_t width,
          std::vector<Out>& out) {
    with_number(type, [&](auto value) {
        for (std::size_t i = 0; i < out.size(); i += width, from += stride)
            for (std::size_t c = 0; c < width; ++c) {
                std::memcpy(&value, from + c * sizeof value, sizeof value);
                out[i + c] = static_cast<Out>(value);
            }
    });
}

}  // namespace

struct GltfAccessors::Layout {
    std::size_t count = 0;
    std::size_t width = 0;
    Component component{};
    [[nodiscard]] std::size_t element_bytes() const { return width * component.bytes; }
};

GltfAccessors::Layout GltfAccessors::layout_of(std::size_t accessor) const {
    const JsonObject& json = document_.accessors[accessor];
    return {.count = json.whole("count", kMostElements),
            .width = width_of(json),
            .component = component_of(json)};
}

std::size_t GltfAccessors::count(std::size_t accessor) const {
    return document_.accessors[accessor].whole("count", kMostElements);
}

bool GltfAccessors::is_float(std::size_t accessor) const {
    return component_of(document_.accessors[accessor]).bit == kFloat;
}

bool GltfAccessors::is_normalised(std::size_t accessor) const {
    return document_.accessors[accessor].flag_or("normalized", false) && !is_float(accessor);
}

void GltfAccessors::normalise(std::size_t accessor, std::vector<double>& numbers) const {
    if (!is_normalised(accessor)) return;
    const double by = component_of(json(accessor)).divisor;
    for (double& number : numbers)
        number = std::max(number / by, -1.0);
}

void GltfAccessors::check(std::size_t accessor, const AccessorRule& rule) const {
    const JsonObject& json = document_.accessors[accessor];
    const Layout layout = layout_of(accessor);
    if (json.text("type") != rule.type)
        json.fail("type is " + json.text("type"), std::string(rule.type) + " for " + rule.use);
    const GltfComponents bit = layout.component.bit;
    if ((rule.components & bit) == 0) {
        json.fail("componentType is " + std::to_string(layout.component.code),
                  codes_of(rule.components) + " for " + rule.use);
    }
    if (rule.are_units && bit != kFloat && !is_normalised(accessor))
        json.fail("normalized is false", "true, or floats, for " + std::string(rule.use));
}

template <class Out>
std::vector<Out> GltfAccessors::read_view(const JsonObject& owner, const Layout& layout) {
    const std::size_t index = owner.index("bufferView", document_.buffer_views.size());
    const std::span<const std::byte> bytes = buffers_.view(index);
    const std::size_t size = layout.element_bytes();
    const std::size_t stride = document_.buffer_views[index].whole_or("byteStride", 252, size);
    if (stride < size) {
        document_.buffer_views[index].fail("byteStride is " + std::to_string(stride),
                                           std::to_string(size) + " or more for " + owner.place());
    }
    const std::size_t offset = owner.whole_or("byteOffset", bytes.size(), 0);
    const std::size_t left = bytes.size() - offset;
    // The last element need not fill its stride.
    const std::size_t most = left < size ? 0 : (left - size) / stride + 1;
    if (layout.count > most) {
        owner.fail("count is " + std::to_string(layout.count),
                   "0.." + std::to_string(most) + " in bufferView " + std::to_string(index));
    }
    std::vector<Out> values(layout.count * layout.width);
    take(layout.component.bit, bytes.data() + offset, stride, layout.width, values);
    return values;
}

/// Of an accessor without a base only their number stands in the file.
template <class Out>
std::vector<Out> GltfAccessors::zeros(const JsonObject& owner, const Layout& layout) const {
    if (layout.count > buffers_.bytes_known()) {
        owner.fail("count of zeros is " + std::to_string(layout.count),
                   "0.." + std::to_string(buffers_.bytes_known()) + ", the bytes of the file");
    }
    return std::vector<Out>(layout.count * layout.width);
}

template <class Out>
void GltfAccessors::read_sparse(const JsonObject& sparse,
                                const Layout& layout,
                                std::vector<Out>& values) {
    const JsonObject where = sparse.at("indices");
    Layout places{
        .count = sparse.whole("count", layout.count), .width = 1, .component = component_of(where)};
    if ((places.component.bit & kIndex) == 0) {
        where.fail("componentType is " + std::to_string(places.component.code), codes_of(kIndex));
    }
    const auto indices = read_view<std::uint32_t>(where, places);
    Layout parts = layout;
    parts.count = places.count;
    const auto substitutes = read_view<Out>(sparse.at("values"), parts);
    if (values.empty()) values = zeros<Out>(sparse, layout);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const bool is_good = indices[i] < layout.count && (i == 0 || indices[i - 1] < indices[i]);
        if (!is_good) {
            where.fail("index " + std::to_string(i) + " is " + std::to_string(indices[i]),
                       "rising ones, 0.." + std::to_string(layout.count - 1));
        }
        std::copy_n(substitutes.begin() + static_cast<std::ptrdiff_t>(i * layout.width),
                    layout.width,
                    values.begin() + static_cast<std::ptrdiff_t>(indices[i] * layout.width));
    }
}

template <class Out>
std::vector<Out> GltfAccessors::read(std::size_t accessor) {
    const JsonObject& json = document_.accessors[accessor];
    const Layout layout = layout_of(accessor);
    std::vector<Out> values;
    if (json.has("bufferView")) values = read_view<Out>(json, layout);
    if (const auto sparse = json.find("sparse")) read_sparse(*sparse, layout, values);
    if (values.empty()) values = zeros<Out>(json, layout);
    return values;
}

std::vector<double> GltfAccessors::numbers(std::size_t accessor, const AccessorRule& rule) {
    check(accessor, rule);
    std::vector<double> values = read<double>(accessor);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) {
            json(accessor).fail("number " + std::to_string(i) + " is not finite",
                                "finite numbers for " + std::string(rule.use));
        }
    }
    normalise(accessor, values);
    return values;
}

std::vector<double> GltfAccessors::components(std::size_t accessor) {
    return read<double>(accessor);
}

std::vector<std::byte> GltfAccessors::packed(std::size_t accessor,
                                             const std::vector<double>& components) const {
    const Component component = component_of(json(accessor));
    std::vector<std::byte> bytes(components.size() * component.bytes);
    std::byte* to = bytes.data();
    with_number(component.bit, [&](auto number) {
        for (const double value : components) {
            number = static_cast<decltype(number)>(value);
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        }
    });
    return bytes;
}

std::size_t GltfAccessors::width(std::size_t accessor) const {
    return layout_of(accessor).width;
}

std::size_t GltfAccessors::element_bytes(std::size_t accessor) const {
    return layout_of(accessor).element_bytes();
}

std::vector<std::uint32_t> GltfAccessors::indices(std::size_t accessor) {
    check(accessor, {"indices", "SCALAR", kIndex});
    return read<std::uint32_t>(accessor);
}

}  // namespace ink::import
