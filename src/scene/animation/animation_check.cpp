#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "core/error.h"
#include "scene/animation.h"
#include "scene/animation/animation_reach.h"
#include "scene/box.h"

namespace ink::scene {
namespace {

using scene::is_finite;

// Positions are floats, and products of three of them are formed in double.
constexpr double kMostReach = 1e30;
constexpr double kUnitSlack = 1e-6;

/// Throws about the motion of one scene.
class Complaint {
  public:
    explicit Complaint(const Scene& scene) : where_(scene.name + ", animation") {}
    void unless(bool is_good, const std::string& what, const std::string& accepted = {}) const {
        if (!is_good) throw core::Error(where_, what, accepted);
    }
    /// Unless `number` is one of so many `things`; `what` says who has it, and ends before it.
    void unless_one_of(std::size_t count,
                       std::size_t number,
                       const std::string& what,
                       const char* things) const {
        unless(number < count,
               fmt::format("{} {}", what, number),
               fmt::format("one of {} {}", count, things));
    }

  private:
    std::string where_;
};

/// Finite, with the last row 0 0 0 1: any other would scale what stands to its left in a product.
bool is_affine(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        if (!is_finite(glm::dvec3(m[column])) || m[column].w != (column < 3 ? 0 : 1)) return false;
    }
    return true;
}

bool is_finite(double value) {
    return std::isfinite(value);
}

bool is_finite(const glm::dquat& q) {
    return std::isfinite(glm::dot(q, q));
}

template <class Value>
bool is_good_value(const Value& value, const Course<Value>& /*course*/) {
    return is_finite(value);
}

/// Of length 1, or about that where it is made so after blending.
bool is_good_value(const glm::dquat& q, const Course<glm::dquat>& course) {
    const double square = glm::dot(q, q);
    if (course.interpolation == Interpolation::cubic) return square > 0.25 && square < 4;
    return std::abs(square - 1) < kUnitSlack;
}

template <class Value>
void check_keys(const std::vector<Key<Value>>& keys,
                const Course<Value>& course,
                const std::string& name,
                const Complaint& complain) {
    for (std::size_t k = 0; k < keys.size(); ++k) {
        complain.unless(std::isfinite(keys[k].time_s) && is_good_value(keys[k].value, course),
                        fmt::format("{}, key {} is not finite or no rotation", name, k),
                        "finite times and values, rotations of length 1");
        complain.unless(k == 0 || keys[k - 1].time_s <= keys[k].time_s,
                        fmt::format("{}, key {} goes back in time", name, k),
                        "times in order");
    }
    complain.unless(course.interpolation <= Interpolation::cubic,
                    fmt::format("{} has keys that are blended in no known way", name),
                    "linear, step or cubic ones");
    const bool is_cubic = course.interpolation == Interpolation::cubic;
    complain.unless(course.tangents.size() == (is_cubic ? keys.size() : 0),
                    fmt::format("{} has {} tangents", name, course.tangents.size()),
                    "one pair per cubic key");
    for (const auto& tangents : course.tangents) {
        complain.unless(is_finite(tangents.in) && is_finite(tangents.out),
                        fmt::format("{} has a tangent that is not finite", name),
                        "finite numbers");
    }
}

void check_nodes(const Animation& animation, const Complaint& complain) {
    for (std::size_t n = 0; n < animation.nodes.size(); ++n) {
        const AnimatedNode& node = animation.nodes[n];
        const std::string name = fmt::format("node {}", n);
        complain.unless(node.parent == kNoNode || node.parent < n,
                        fmt::format("{} has the parent {}", name, node.parent),
                        "an earlier node");
        complain.unless(is_affine(node.parent_from_node),
                        name + " has a transform that is not affine",
                        "finite numbers, and 0 0 0 1 in the last row");
        const bool is_moving = node.has_keys();
        complain.unless(node.rotations.empty() != is_moving && node.scales.empty() != is_moving,
                        name + " has keys of one kind only",
                        "translations, rotations and scales");
        check_keys(node.translations, node.translation_course, name, complain);
        check_keys(node.rotations, node.rotation_course, name, complain);
        check_keys(node.scales, node.scale_course, name, complain);
    }
}

void check_vectors(const std::vector<glm::vec3>& vectors,
                   const std::string& name,
                   const Complaint& complain) {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        complain.unless(is_finite(glm::dvec3(vectors[i])),
                        fmt::format("{}, vector {} is not finite", name, i),
                        "finite numbers");
    }
}

void check_frames(const Scene& scene, const Animation& animation, const Complaint& complain) {
    const auto& all = animation.vertex_frames;
    complain.unless(
        all.empty() || all.size() == scene.meshes.size(),
        fmt::format("{} lists of frames for {} meshes", all.size(), scene.meshes.size()),
        "none, or one per mesh");
    for (std::size_t m = 0; m < all.size(); ++m) {
        const std::size_t vertices = scene.meshes[m].positions.size();
        const std::size_t frames = all[m].frame_count;
        const std::string name = fmt::format("the frames of mesh {}", m);
        // Division, for the product may be more than a number holds.
        const bool fits = frames == 0 || vertices == 0
                              ? all[m].positions.empty()
                              : all[m].positions.size() / vertices == frames &&
                                    all[m].positions.size() % vertices == 0;
        complain.unless(fits,
                        fmt::format("{}: {} positions for {} frames of {} vertices",
                                    name,
                                    all[m].positions.size(),
                                    frames,
                                    vertices),
                        "one per vertex and frame");
        const bool has_normals = !scene.meshes[m].normals.empty();
        complain.unless(all[m].normals.empty() ||
                            (has_normals && all[m].normals.size() == all[m].positions.size()),
                        fmt::format("{}: {} normals", name, all[m].normals.size()),
                        "none, or one per position of a mesh with normals");
        check_vectors(all[m].positions, name, complain);
        check_vectors(all[m].normals, name, complain);
    }
    complain.unless(animation.frame_count() == 0 ||
                        (std::isfinite(animation.frames_per_s) && animation.frames_per_s > 0),
                    fmt::format("{:g} frames a second", animation.frames_per_s),
                    "more than 0");
}

void check_weights(const Skin& skin, const std::string& name, const Complaint& complain) {
    const auto& first = skin.first_weight;
    complain.unless(first.size() == skin.positions.size() + 1 && first.front() == 0 &&
                        std::ranges::is_sorted(first) && first.back() == skin.weights.size(),
                    name + " does not say which weights are whose",
                    "a place in the list for every vertex");
    for (const BoneWeight& weight : skin.weights) {
        complain.unless_one_of(skin.bones.size(), weight.bone, name + " follows bone", "bones");
        complain.unless(std::isfinite(weight.weight) && weight.weight >= 0 && weight.weight <= 1e6F,
                        fmt::format("{} has the weight {:g}", name, weight.weight),
                        "0 or more");
    }
}

/// That what moves a mesh is of one that nothing else of its kind moves, and no frames.
template <class Motion>
void check_meshes(const std::vector<Motion>& motions,
                  const std::string& kind,
                  const Scene& scene,
                  const Animation& animation,
                  const Complaint& complain) {
    std::vector<bool> is_taken(scene.meshes.size(), false);
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const std::uint32_t mesh = motions[i].mesh;
        const std::string name = fmt::format("{} {}", kind, i);
        complain.unless(mesh < scene.meshes.size() && !is_taken[mesh],
                        fmt::format("{} is of mesh {}", name, mesh),
                        "a mesh without another " + kind);
        is_taken[mesh] = true;
        complain.unless(
            animation.vertex_frames.empty() || animation.vertex_frames[mesh].frame_count == 0,
            name + " is of a mesh that has frames, too");
    }
}

void check_skins(const Scene& scene, const Animation& animation, const Complaint& complain) {
    check_meshes(animation.skins, "skin", scene, animation, complain);
    for (std::size_t s = 0; s < animation.skins.size(); ++s) {
        const Skin& skin = animation.skins[s];
        const std::string name = fmt::format("skin {}", s);
        const std::size_t vertices = scene.meshes[skin.mesh].positions.size();
        complain.unless(skin.positions.size() == vertices &&
                            (skin.normals.empty() || skin.normals.size() == vertices),
                        fmt::format("{} has {} positions and {} normals",
                                    name,
                                    skin.positions.size(),
                                    skin.normals.size()),
                        fmt::format("{} each", vertices));
        check_vectors(skin.positions, name, complain);
        check_vectors(skin.normals, name, complain);
        for (const Skin::Bone& bone : skin.bones) {
            complain.unless_one_of(
                animation.nodes.size(), bone.node, name + " has a bone at node", "nodes");
            complain.unless(is_affine(bone.node_from_mesh),
                            name + " has a bone whose transform is not affine",
                            "finite numbers, and 0 0 0 1 in the last row");
        }
        check_weights(skin, name, complain);
    }
}

void check_morphs(const Scene& scene, const Animation& animation, const Complaint& complain) {
    check_meshes(animation.morphs, "morph", scene, animation, complain);
    for (std::size_t m = 0; m < animation.morphs.size(); ++m) {
        const Morph& morph = animation.morphs[m];
        const std::string name = fmt::format("morph {}", m);
        const Mesh& mesh = scene.meshes[morph.mesh];
        complain.unless(morph.positions.size() == mesh.positions.size() &&
                            morph.normals.size() == mesh.normals.size(),
                        fmt::format("{} has {} positions and {} normals",
                                    name,
                                    morph.positions.size(),
                                    morph.normals.size()),
                        "as many as its mesh");
        check_vectors(morph.positions, name, complain);
        check_vectors(morph.normals, name, complain);
        for (const Morph::Target& target : morph.targets) {
            const auto fits = [](const auto& more, const auto& base) {
                return more.empty() || more.size() == base.size();
            };
            complain.unless(
                fits(target.positions, morph.positions) && fits(target.normals, morph.normals),
                fmt::format("{} has a target of {} positions and {} normals",
                            name,
                            target.positions.size(),
                            target.normals.size()),
                "none, or as many as its base");
            check_vectors(target.positions, name, complain);
            check_vectors(target.normals, name, complain);
            complain.unless(is_finite(target.weight), name + " has a share that is not finite");
            check_keys(target.weights, target.course, name, complain);
        }
    }
}

void check_cameras(const Scene& scene, const Animation& animation, const Complaint& complain) {
    const auto& node_of = animation.node_of_camera;
    complain.unless(node_of.empty() || node_of.size() == scene.cameras.size(),
                    fmt::format("it moves {} cameras of {}", node_of.size(), scene.cameras.size()),
                    "none, or as many as there are");
    for (const std::uint32_t node : node_of) {
        if (node != kNoNode)
            complain.unless_one_of(animation.nodes.size(), node, "a camera hangs on node", "nodes");
    }
}

void check_lights(const Scene& scene, const Animation& animation, const Complaint& complain) {
    complain.unless(
        animation.lights.empty() || animation.lights.size() == scene.lights.size(),
        fmt::format("it moves {} lights of {}", animation.lights.size(), scene.lights.size()),
        "none, or as many as there are");
    for (const LightMotion& light : animation.lights) {
        if (light.node != kNoNode)
            complain.unless_one_of(
                animation.nodes.size(), light.node, "a light hangs on node", "nodes");
        complain.unless(
            is_finite(light.p_node), "a light has a place that is not finite", "finite numbers");
    }
}

}  // namespace

void check_animation(const Scene& scene, const Animation& animation) {
    const Complaint complain(scene);
    complain.unless(std::isfinite(animation.duration_s) && animation.duration_s >= 0,
                    fmt::format("it lasts {:g} s", animation.duration_s),
                    "0 or more");
    check_nodes(animation, complain);
    const auto& node_of = animation.node_of_instance;
    complain.unless(
        node_of.size() == scene.instances.size(),
        fmt::format("it moves {} instances of {}", node_of.size(), scene.instances.size()),
        "as many as there are");
    for (const std::uint32_t node : node_of)
        if (node != kNoNode)
            complain.unless_one_of(
                animation.nodes.size(), node, "an instance hangs on node", "nodes");
    check_frames(scene, animation, complain);
    check_morphs(scene, animation, complain);
    check_skins(scene, animation, complain);
    check_cameras(scene, animation, complain);
    check_lights(scene, animation, complain);
    const double reach = farthest_reach(scene, animation);
    complain.unless(reach < kMostReach,
                    fmt::format("it may reach {:g}", reach),
                    fmt::format("less than {:g}", kMostReach));
}

}  // namespace ink::scene
