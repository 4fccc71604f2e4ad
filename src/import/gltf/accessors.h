#pragma once

#include <cstdint>
#include <vector>

#include "import/gltf/buffers.h"

namespace ink::import {

/// The component types of glTF, as bits.
enum GltfComponents : unsigned {
    kByte = 1,
    kUnsignedByte = 2,
    kShort = 4,
    kUnsignedShort = 8,
    kUnsignedInt = 16,
    kFloat = 32,
};
/// Those beside floats of KHR_mesh_quantization.
inline constexpr unsigned kSmall = kByte | kUnsignedByte | kShort | kUnsignedShort;
/// Those of indices.
inline constexpr unsigned kIndex = kUnsignedByte | kUnsignedShort | kUnsignedInt;

/// What an accessor may be where it is used.
struct AccessorRule {
    const char* use;         ///< "POSITION", for messages
    const char* type;        ///< "VEC3"
    unsigned components;     ///< any of GltfComponents
    bool are_units = false;  ///< integers only if normalised
};

/// Numbers of accessors: of any component type, normalised, strided, sparse. Borrows document and
/// buffers.
class GltfAccessors {
  public:
    GltfAccessors(const GltfDocument& document, GltfBuffers& buffers)
        : document_(document), buffers_(buffers) {}

    [[nodiscard]] std::size_t size() const { return document_.accessors.size(); }
    [[nodiscard]] const JsonObject& json(std::size_t accessor) const {
        return document_.accessors[accessor];
    }
    [[nodiscard]] std::size_t count(std::size_t accessor) const;
    /// Whether its components are floats.
    [[nodiscard]] bool is_float(std::size_t accessor) const;
    /// Whether its integers stand for numbers of -1..1 or 0..1.
    [[nodiscard]] bool is_normalised(std::size_t accessor) const;
    /// Makes those numbers of its integers, if they do.
    void normalise(std::size_t accessor, std::vector<double>& numbers) const;

    /// Fails unless it is as `rule` has it.
    void check(std::size_t accessor, const AccessorRule& rule) const;
    /// All components of all elements, one behind the other.
    [[nodiscard]] std::vector<double> numbers(std::size_t accessor, const AccessorRule& rule);
    /// The same as they stand: of any type, integers not normalised, floats not looked at.
    [[nodiscard]] std::vector<double> components(std::size_t accessor);
    /// Components of elements in an accessor's own component type, little-endian, without gaps.
    [[nodiscard]] std::vector<std::byte> packed(std::size_t accessor,
                                                const std::vector<double>& components) const;
    /// How many components an element has, and how many bytes.
    [[nodiscard]] std::size_t width(std::size_t accessor) const;
    [[nodiscard]] std::size_t element_bytes(std::size_t accessor) const;
    /// Elements of one unsigned integer.
    [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t accessor);

  private:
    struct Layout;
    [[nodiscard]] Layout layout_of(std::size_t accessor) const;
    template <class Out>
    [[nodiscard]] std::vector<Out> read(std::size_t accessor);
    template <class Out>
    [[nodiscard]] std::vector<Out> zeros(const JsonObject& owner, const Layout& layout) const;
    template <class Out>
    void read_sparse(const JsonObject& sparse, const Layout& layout, std::vector<Out>& values);
    template <class Out>
    [[nodiscard]] std::vector<Out> read_view(const JsonObject& owner, const Layout& layout);

    const GltfDocument& document_;
    GltfBuffers& buffers_;
};

}  // namespace ink::import
