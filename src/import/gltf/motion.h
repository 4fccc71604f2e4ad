#pragma once

#include <map>

#include "import/gltf/accessors.h"
#include "import/gltf/tree.h"

namespace ink::import {

/// A sampler's numbers: those of a key come together.
struct GltfSampler {
    std::vector<double> times_s;
    std::vector<double> values;  ///< of cubic ones: in-tangents, values, out-tangents, key by key
    scene::Interpolation interpolation = scene::Interpolation::linear;

    [[nodiscard]] bool is_cubic() const { return interpolation == scene::Interpolation::cubic; }
};

/// How the shares of a node's morph targets move: for each key one value per target.
struct GltfWeightKeys {
    JsonObject channel;  ///< for messages
    GltfSampler keys;

    /// Gives the targets their keys; fails unless there is a value for each.
    void share_out(std::vector<scene::Morph::Target>& targets) const;
};

struct GltfMotion {
    double duration_s = 0;
    std::map<std::size_t, GltfWeightKeys> weights;  ///< by the file's number of the node
    std::size_t ignored_pointers = 0;  ///< channels of KHR_animation_pointer that move no node
};

/// Gives the tree's nodes the keys of an animation, and returns what else moves.
[[nodiscard]] GltfMotion read_motion(const GltfDocument& document,
                                     std::size_t animation,
                                     GltfAccessors& accessors,
                                     GltfTree& tree);

}  // namespace ink::import
