#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace ink::scene {

inline constexpr std::uint32_t kNoNode = ~0U;

/// A value that is reached at a time. Times of a list never fall.
template <class Value>
struct Key {
    double time_s = 0;
    Value value{};
};
using VectorKey = Key<glm::dvec3>;
using RotationKey = Key<glm::dquat>;  ///< of length 1; of cubic ones about that
using WeightKey = Key<double>;

/// What lies between two keys.
enum class Interpolation : std::uint32_t {
    linear,  ///< the straight way; of rotations the shorter arc
    step,    ///< the first of them
    cubic,   ///< Hermite's curve along their tangents; of rotations made unit
};

/// How a list of keys is blended.
template <class Value>
struct Course {
    struct Tangents {
        Value in{};   ///< per second, where the curve reaches the key
        Value out{};  ///< and where it leaves it
    };
    Interpolation interpolation = Interpolation::linear;
    std::vector<Tangents> tangents{};  ///< of cubic ones: per key; else empty
};

/// A node of the tree that carries instances and bones.
struct AnimatedNode {
    std::uint32_t parent = kNoNode;  ///< an earlier node
    glm::dmat4 parent_from_node{1};  ///< at rest; the whole truth of a node without keys
    /// Keys of moving nodes, none of the three lists empty: scaled, then turned, then moved.
    std::vector<VectorKey> translations;
    std::vector<RotationKey> rotations;
    std::vector<VectorKey> scales;
    Course<glm::dvec3> translation_course{};
    Course<glm::dquat> rotation_course{};
    Course<glm::dvec3> scale_course{};

    [[nodiscard]] bool has_keys() const { return !translations.empty(); }
    /// parent_from_node at a time; before the first key as there, after the last likewise.
    [[nodiscard]] glm::dmat4 at(double time_s) const;
};

/// All places of a mesh's vertices, as Quake's models store motion.
struct VertexFrames {
    std::size_t frame_count = 0;       ///< 0: the mesh keeps its shape
    std::vector<glm::vec3> positions;  ///< frame after frame, each with all vertices
    std::vector<glm::vec3> normals;    ///< likewise, unit; or empty
};

/// A mesh that is a base and a share of each of some targets. Bones come after that.
struct Morph {
    struct Target {
        std::vector<glm::vec3> positions;  ///< what is added to the base's, or empty
        std::vector<glm::vec3> normals;    ///< likewise
        double weight = 0;                 ///< the share at rest
        std::vector<WeightKey> weights;    ///< the moving share, or empty
        Course<double> course{};

        /// The share at a time, at rest without one.
        [[nodiscard]] double at(std::optional<double> time_s) const;
    };
    std::uint32_t mesh = 0;
    std::vector<glm::vec3> positions{};  ///< the base, mesh space
    std::vector<glm::vec3> normals{};    ///< likewise, or empty
    std::vector<Target> targets{};
};

/// How much of a vertex follows a bone.
struct BoneWeight {
    std::uint32_t bone = 0;
    float weight = 0;
};

/// A mesh whose vertices follow nodes. Posed, its vertices are in world space. Where a Morph shapes
/// the mesh, what comes of that is bound instead of `positions` and `normals`.
struct Skin {
    struct Bone {
        std::uint32_t node = 0;
        glm::dmat4 node_from_mesh{1};  ///< as they were bound
    };
    std::uint32_t mesh = 0;
    std::vector<glm::vec3> positions;  ///< as bound, mesh space
    std::vector<glm::vec3> normals;    ///< likewise, or empty
    std::vector<Bone> bones;
    /// Vertex v follows weights[first_weight[v] .. first_weight[v + 1]); none: it stays as bound.
    std::vector<std::uint32_t> first_weight;
    std::vector<BoneWeight> weights;
};

/// How a lamp goes with a node.
struct LightMotion {
    std::uint32_t node = kNoNode;  ///< kNoNode: it stands still
    glm::dvec3 p_node{0};          ///< in the node
};

/// Writes what each vertex follows into `skin`.
void set_weights(const std::vector<std::vector<BoneWeight>>& of_vertex, Skin& skin);

/// How a scene moves: its instances with their nodes, its vertices by frames, by shares of targets
/// or with bones. The topology stays.
struct Animation {
    double duration_s = 0;
    double frames_per_s = 0;                      ///< of stored vertex frames; 0 without any
    std::vector<AnimatedNode> nodes;              ///< parents first
    std::vector<std::uint32_t> node_of_instance;  ///< per instance; kNoNode: it stands still
    std::vector<VertexFrames> vertex_frames;      ///< per mesh, or empty
    std::vector<Skin> skins;
    /// Per camera of the scene, or empty; kNoNode: it stands still. A camera stands in its node's
    /// zero, looks along -z, and has y up.
    std::vector<std::uint32_t> node_of_camera{};
    std::vector<Morph> morphs{};        ///< at most one of a mesh
    std::vector<LightMotion> lights{};  ///< per light of the scene, or empty

    /// The most frames that a mesh stores; 0 where motion is by keys alone.
    [[nodiscard]] std::size_t frame_count() const;
    /// When stored frame `frame` is shown, exactly.
    [[nodiscard]] double frame_time_s(std::size_t frame) const;
    /// Whether keys move a node, its own or those of one above it.
    [[nodiscard]] bool is_moving(std::uint32_t node) const;
};

/// Sets the instances' transforms, the meshes' vertices, the moving cameras and lights to those at
/// `time_s`, held to 0 .. duration_s. At a key or a stored frame they equal it bit for bit; a part
/// with fewer frames than others keeps its last. Same bits on every machine. A scene without
/// animation stays as it is. Cameras keep angle, near and far: fitting these to what has moved is
/// the caller's part (fit_clip_range).
void pose_scene(Scene& scene, double time_s);

/// Each node's place in the world at a time; without one, at rest.
[[nodiscard]] std::vector<glm::dmat4> world_from_nodes(const Animation& animation,
                                                       std::optional<double> time_s);

/// Sets it as the file has it without its motion: every node at rest, vertices in their first
/// frame, colours of lights at their first key.
void rest_scene(Scene& scene);

/// A ball that holds the scene, posed as it is and at each of `times_s`.
[[nodiscard]] Sphere bounds_of_poses(Scene scene, std::span<const double> times_s);

/// The rotation a share `share` (0..1) of the way from `from` to `to` along the shorter arc at even
/// speed (Shoemake 1985), both of length 1. By halving the arc, so that only square roots are
/// taken.
[[nodiscard]] glm::dquat slerp(const glm::dquat& from, const glm::dquat& to, double share);

/// Throws Error (where = the scene's name) unless `animation` fits the scene: indices and lengths,
/// finite numbers, affine transforms, parents before children, times in order, rotations of length
/// 1, and no pose that could reach out of all bounds.
void check_animation(const Scene& scene, const Animation& animation);

}  // namespace ink::scene
