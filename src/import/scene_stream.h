#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/byte_stream.h"
#include "scene/animation.h"
#include "scene/scene.h"

namespace ink::import {

/// How the import child fared.
enum class ImportStatus : std::uint32_t {
    scene,           ///< the rest of the reply holds
    not_readable,    ///< no reader takes it; `reason` is the library's own
    wrong_content,   ///< no reader recognises it, though its extension is known
    unknown_format,  ///< no reader takes it, and its extension is not known either
    damaged,         ///< a reader of ours found a fault; `reason` says where and what
    out_of_memory,
};

/// A camera as a file gives it, made world space.
struct ImportedCamera {
    std::string name;
    glm::dvec3 eye_world{0};
    glm::dvec3 target_world{0};
    glm::dvec3 up_world{0};
    double fov_y_rad = 0;
    scene::CameraMotion motion{};  ///< the same by the reply's nodes
};

/// What the import child hands back. Nothing in it is checked: whoever reads it must not trust it.
struct ImportReply {
    ImportStatus status = ImportStatus::scene;
    std::string reason;
    std::uint64_t faces_read = 0;  ///< of any number of corners, before triangulation
    std::uint64_t vertices_read = 0;
    std::vector<scene::Mesh> meshes;  ///< each of one material
    std::vector<scene::Instance> instances;
    std::vector<ImportedCamera> cameras;
    std::optional<scene::Animation> animation{};
};

/// Writes `reply` as one binary stream: magic, version, counts, arrays, end mark; native byte
/// order, for it never leaves the machine.
void write_reply(const ImportReply& reply, const core::ByteSink& sink);

/// The reply in `stream`, or nothing if that is not exactly one whole reply.
///
/// Allocates no more than a small multiple of the stream's size, whatever counts it claims. Indices
/// and numbers come as they stand.
[[nodiscard]] std::optional<ImportReply> read_reply(std::span<const std::byte> stream);

}  // namespace ink::import
