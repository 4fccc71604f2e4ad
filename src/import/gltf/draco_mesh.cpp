// The only file that includes Draco.

#include "import/gltf/draco_mesh.h"

#include <draco/compression/decode.h>

#include <utility>

namespace ink::import {
namespace {

/// Draco has bools, doubles and 64 bits as well, which no accessor of glTF can stand for.
bool is_gltf_type(draco::DataType type) {
    return (type >= draco::DT_INT8 && type <= draco::DT_UINT32) || type == draco::DT_FLOAT32;
}

template <class Number>
bool take(const draco::PointAttribute& attribute,
          std::size_t vertices,
          std::size_t width,
          std::vector<double>& numbers) {
    std::vector<Number> values(width);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const auto index = attribute.mapped_index(draco::PointIndex(v));
        if (index.value() >= attribute.size()) return false;
        if (!attribute.ConvertValue(index, static_cast<std::int8_t>(width), values.data()))
            return false;
        numbers.insert(numbers.end(), values.begin(), values.end());
    }
    return true;
}

}  // namespace

DracoMesh::DracoMesh(std::span<const std::byte> packed, const JsonObject& json) : json_(json) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok()) {
        json_.fail("its stream cannot be unpacked: " + decoded.status().error_msg_string());
    }
    mesh_ = std::move(decoded).value();
}

std::size_t DracoMesh::vertex_count() const {
    return mesh_->num_points();
}

std::vector<std::uint32_t> DracoMesh::indices() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t f = 0; f < mesh_->num_faces(); ++f)
        for (const draco::PointIndex& corner : mesh_->face(draco::FaceIndex(f))) {
            if (corner.value() >= mesh_->num_points())
                json_.fail("its stream uses vertex " + std::to_string(corner.value()),
                           "0.." + std::to_string(mesh_->num_points()));
            all.push_back(corner.value());
        }
    return all;
}

std::vector<double> DracoMesh::numbers(std::uint32_t unique_id, std::size_t width) const {
    const draco::PointAttribute* attribute = mesh_->GetAttributeByUniqueId(unique_id);
    if (attribute == nullptr)
        json_.fail("its stream has no attribute " + std::to_string(unique_id));
    if (attribute->num_components() != static_cast<std::int8_t>(width)) {
        json_.fail("attribute " + std::to_string(unique_id) + " of its stream has " +
                       std::to_string(attribute->num_components()) + " components",
                   std::to_string(width));
    }
    if (!is_gltf_type(attribute->data_type())) {
        json_.fail("attribute " + std::to_string(unique_id) + " of its stream is of type " +
                       std::to_string(attribute->data_type()) + " of Draco's",
                   "integers of 8 to 32 bits, or floats");
    }
    std::vector<double> numbers;
    const bool is_float = attribute->data_type() == draco::DT_FLOAT32;
    // As integers, for as numbers Draco would divide them by its own idea of normalisation.
    const bool is_good = is_float ? take<double>(*attribute, vertex_count(), width, numbers)
                                  : take<std::int32_t>(*attribute, vertex_count(), width, numbers);
    if (!is_good) json_.fail("attribute " + std::to_string(unique_id) + " cannot be unpacked");
    return numbers;
}

}  // namespace ink::import
