#include "import/gltf/motion.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

namespace ink::import {
namespace {

constexpr AccessorRule kTimes{"key times", "SCALAR", kFloat};
constexpr AccessorRule kVectors{"keys", "VEC3", kFloat};
constexpr AccessorRule kRotations{"rotation keys", "VEC4", kFloat | kSmall, true};
constexpr AccessorRule kWeightKeys{"weight keys", "SCALAR", kFloat | kSmall, true};

/// What a channel moves.
struct Target {
    std::size_t node = 0;
    std::string path;
    [[nodiscard]] auto operator<=>(const Target&) const = default;
};

scene::Interpolation interpolation_of(const JsonObject& sampler) {
    const std::string name = sampler.text("interpolation");
    if (name.empty() || name == "LINEAR") return scene::Interpolation::linear;
    if (name == "STEP") return scene::Interpolation::step;
    if (name == "CUBICSPLINE") return scene::Interpolation::cubic;
    sampler.refuse("the interpolation " + name + " is not read", "LINEAR, STEP or CUBICSPLINE");
}

using Sampler = GltfSampler;

Sampler read_sampler(const JsonObject& json, const AccessorRule& rule, GltfAccessors& accessors) {
    const std::size_t input = json.index("input", accessors.size());
    Sampler sampler{.times_s = accessors.numbers(input, kTimes),
                    .values = accessors.numbers(json.index("output", accessors.size()), rule),
                    .interpolation = interpolation_of(json)};
    for (std::size_t k = 0; k < sampler.times_s.size(); ++k) {
        const bool is_good =
            sampler.times_s[k] >= 0 && (k == 0 || sampler.times_s[k - 1] <= sampler.times_s[k]);
        if (!is_good) {
            accessors.json(input).fail(
                "time " + std::to_string(k) + " is " + std::to_string(sampler.times_s[k]),
                "0 or more, in order");
        }
    }
    if (sampler.times_s.empty()) accessors.json(input).fail("it has no key", "at least one");
    return sampler;
}

void check_width(const Sampler& sampler, std::size_t width, const JsonObject& channel) {
    const std::size_t expected = sampler.times_s.size() * width * (sampler.is_cubic() ? 3 : 1);
    if (sampler.values.size() == expected) return;
    channel.fail("its keys have " + std::to_string(sampler.values.size()) + " numbers",
                 std::to_string(expected));
}

/// The keys of a sampler, each value made by `make` of its first number.
template <class Key, class Value, class Make>
void take_keys(const Sampler& sampler,
               std::size_t width,
               Make make,
               std::vector<Key>& keys,
               scene::Course<Value>& course) {
    course.interpolation = sampler.interpolation;
    const std::size_t step = width * (sampler.is_cubic() ? 3 : 1);
    for (std::size_t k = 0; k < sampler.times_s.size(); ++k) {
        const double* first = sampler.values.data() + k * step;
        keys.push_back({sampler.times_s[k], make(sampler.is_cubic() ? first + width : first)});
        if (sampler.is_cubic()) course.tangents.push_back({make(first), make(first + 2 * width)});
    }
}

glm::dvec3 to_vector(const double* v) {
    return {v[0], v[1], v[2]};
}

glm::dquat to_rotation(const double* v) {
    return {v[3], v[0], v[1], v[2]};
}

/// What a kind without keys keeps.
void fill_from_rest(const JsonObject& json, scene::AnimatedNode& node) {
    const GltfPlace rest = place_of(json);
    if (node.translations.empty()) node.translations.push_back({0, rest.translation});
    if (node.rotations.empty()) node.rotations.push_back({0, rest.rotation});
    if (node.scales.empty()) node.scales.push_back({0, rest.scale});
}

void move_node(const Sampler& sampler,
               const std::string& path,
               const JsonObject& channel,
               scene::AnimatedNode& node) {
    if (path == "translation") {
        check_width(sampler, 3, channel);
        take_keys(sampler, 3, to_vector, node.translations, node.translation_course);
    } else if (path == "scale") {
        check_width(sampler, 3, channel);
        take_keys(sampler, 3, to_vector, node.scales, node.scale_course);
    } else {
        check_width(sampler, 4, channel);
        take_keys(sampler, 4, to_rotation, node.rotations, node.rotation_course);
        for (scene::RotationKey& key : node.rotations) {
            const glm::dquat unit = unit_rotation(key.value, channel);
            if (!sampler.is_cubic()) key.value = unit;  // the others are made so when blended
        }
    }
}

bool is_required(const GltfDocument& document, const std::string& extension) {
    const auto required = document.root().texts("extensionsRequired");
    return std::find(required.begin(), required.end(), extension) != required.end();
}

/// A node's member that a pointer of KHR_animation_pointer names: "/nodes/3/scale".
std::optional<Target> pointed_at(const std::string& pointer, std::size_t node_count) {
    constexpr std::string_view kNodes = "/nodes/";
    if (!pointer.starts_with(kNodes)) return std::nullopt;
    Target target;
    const char* last = pointer.data() + pointer.size();
    const auto [end, failure] = std::from_chars(pointer.data() + kNodes.size(), last, target.node);
    if (failure != std::errc{} || end == last || *end != '/' || target.node >= node_count)
        return std::nullopt;
    target.path.assign(end + 1, last);
    const bool is_member = target.path == "translation" || target.path == "rotation" ||
                           target.path == "scale" || target.path == "weights";
    return is_member ? std::optional(target) : std::nullopt;
}

/// What a channel moves; nothing if that is no node.
std::optional<Target> target_of(const GltfDocument& document,
                                const JsonObject& channel,
                                GltfMotion& motion) {
    constexpr const char* kPointer = "KHR_animation_pointer";
    const JsonObject json = channel.at("target");
    const std::string path = json.text("path");
    if (path == "pointer") {
        const auto extension = json.extension(kPointer);
        const std::string pointer = extension ? extension->text("pointer") : "";
        if (auto target = pointed_at(pointer, document.nodes.size())) return target;
        const bool moves_shapes = pointer.starts_with("/nodes/") || pointer.starts_with("/meshes/");
        if (moves_shapes && is_required(document, kPointer))
            channel.refuse(std::string(kPointer) + " at " + pointer + " is not read");
        ++motion.ignored_pointers;
        return std::nullopt;
    }
    const auto node = json.find_index("node", document.nodes.size());
    if (!node) return std::nullopt;  // as the specification has it
    return Target{*node, path};
}

}  // namespace

void GltfWeightKeys::share_out(std::vector<scene::Morph::Target>& targets) const {
    const std::size_t count = targets.size();
    check_width(keys, count, channel);
    for (std::size_t t = 0; t < count; ++t) {
        Sampler one{keys.times_s, {}, keys.interpolation};
        for (std::size_t i = t; i < keys.values.size(); i += count)
            one.values.push_back(keys.values[i]);
        take_keys(
            one, 1, [](const double* v) { return *v; }, targets[t].weights, targets[t].course);
    }
}

GltfMotion read_motion(const GltfDocument& document,
                       std::size_t animation,
                       GltfAccessors& accessors,
                       GltfTree& tree) {
    GltfMotion motion;
    const std::vector<JsonObject> samplers =
        document.animations[animation].list("samplers", "sampler");
    std::set<Target> moved;
    for (const JsonObject& channel : document.animations[animation].list("channels", "channel")) {
        const auto target = target_of(document, channel, motion);
        if (!target) continue;
        if (!moved.insert(*target).second) {
            channel.fail("node " + std::to_string(target->node) + " has a second channel for its " +
                             target->path,
                         "one");
        }
        const JsonObject& json = samplers[channel.index("sampler", samplers.size())];
        const JsonObject& node = document.nodes[target->node];
        const AccessorRule* rule = target->path == "rotation"  ? &kRotations
                                   : target->path == "weights" ? &kWeightKeys
                                                               : &kVectors;
        if (rule == &kVectors && target->path != "translation" && target->path != "scale")
            channel.refuse("the path " + target->path + " is not read");
        Sampler sampler = read_sampler(json, *rule, accessors);
        motion.duration_s = std::max(motion.duration_s, sampler.times_s.back());
        if (rule == &kWeightKeys) {
            if (!node.has("mesh"))
                channel.fail("node " + std::to_string(target->node) + " has no mesh");
            motion.weights.emplace(target->node, GltfWeightKeys{channel, std::move(sampler)});
            continue;
        }
        if (node.has("matrix")) node.fail("it has a matrix and moves", "a place in three parts");
        move_node(sampler, target->path, channel, tree.nodes[tree.number_of[target->node]]);
    }
    for (const Target& target : moved)
        if (target.path != "weights")
            fill_from_rest(document.nodes[target.node], tree.nodes[tree.number_of[target.node]]);
    return motion;
}

}  // namespace ink::import
