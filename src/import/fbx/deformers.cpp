#include "import/fbx/deformers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "import/model_bytes.h"

namespace ink::import {
namespace {

std::string called(const FbxObject& object) {
    return object.element->name + " \"" + object.name + "\": ";
}

[[noreturn]] void fail(const FbxObject& object, const std::string& what) {
    throw core::Error("", called(object) + what, "a whole, valid FBX file");
}

[[noreturn]] void refuse(const FbxObject& object, const std::string& what, const char* accepted) {
    throw Refusal("", called(object) + what, accepted);
}

/// The points that an object speaks of, each of which there is.
std::vector<std::size_t> indices_of(const FbxObject& object, std::size_t points) {
    std::vector<std::size_t> indices;
    for (const double index : object.element->list("Indexes")) {
        if (!(index >= 0 && index < static_cast<double>(points)))
            fail(object, "it has a point that is not there");
        indices.push_back(static_cast<std::size_t>(index));
    }
    return indices;
}

void add_shape(const FbxObject& shape, double share, std::vector<glm::dvec3>& points) {
    const std::vector<std::size_t> indices = indices_of(shape, points.size());
    const std::vector<double> ways = shape.element->list("Vertices");
    if (ways.size() != 3 * indices.size()) fail(shape, "its Vertices are not those of its Indexes");
    for (std::size_t i = 0; i < indices.size(); ++i)
        points[indices[i]] += share * glm::dvec3(ways[3 * i], ways[3 * i + 1], ways[3 * i + 2]);
}

double percent_of(const FbxObject& channel) {
    const FbxElement* own = channel.element->child("DeformPercent");
    return channel.properties.real("DeformPercent", own == nullptr ? 0 : own->real(0));
}

/// The share of each shape of a channel. The first is whole at full[0] per cent, from where the way
/// goes on to the next; one alone goes on beyond.
std::vector<double> shares_of(const FbxObject& channel, std::size_t shapes) {
    const double percent = percent_of(channel);
    std::vector<double> full = channel.element->list("FullWeights");
    full.resize(std::max(shapes, full.size()), 100);
    std::vector<double> shares(shapes, 0);
    const bool is_rising = std::is_sorted(full.begin(),
                                          full.begin() + static_cast<long>(shapes),
                                          [](double a, double b) { return a <= b; }) &&
                           full[0] > 0;
    const bool is_between = percent >= 0 && percent <= full[shapes - 1];
    if (!is_rising || (shapes > 1 && !is_between)) {
        refuse(channel,
               "DeformPercent " + std::to_string(percent) + " of " + std::to_string(shapes) +
                   " shapes is not read",
               "FullWeights that rise from 0, and a percentage between 0 and the last");
    }
    std::size_t next = 0;
    while (next + 1 < shapes && percent > full[next])
        ++next;
    const double before = next == 0 ? 0 : full[next - 1];
    shares[next] = (percent - before) / (full[next] - before);
    if (next > 0) shares[next - 1] = 1 - shares[next];
    return shares;
}

glm::dmat4 matrix_of(const FbxObject& cluster, const char* name) {
    const std::vector<double> numbers = cluster.element->list(name);
    if (numbers.size() != 16) fail(cluster, std::string(name) + " is no matrix of 16 numbers");
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i)
        matrix[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return matrix;
}

struct Bone {
    const FbxObject* cluster;
    glm::dmat4 world_from_mesh;
};

/// The clusters that have a bone. Transform leads from the mesh to the bone as they were bound.
std::vector<Bone> bones_of(const FbxObject& skin,
                           const FbxModel& model,
                           const std::vector<FbxModel>& models) {
    std::vector<Bone> bones;
    for (const FbxObject* cluster : children_of(skin, "Deformer", "Cluster")) {
        const auto of = children_of(*cluster, "Model");
        const auto bone = std::ranges::find_if(
            models, [&](const FbxModel& one) { return !of.empty() && one.object == of.front(); });
        if (bone == models.end()) continue;
        if (cluster->element->word("Mode") == "Additive")
            refuse(*cluster, "the link mode Additive is not read", "Normalize, Total1");
        bones.push_back(
            {cluster,
             bone->world_from_model * matrix_of(*cluster, "Transform") * model.model_from_mesh});
    }
    return bones;
}

double difference(const glm::dmat4& a, const glm::dmat4& b) {
    double most = 0;
    double size = 0;
    for (int i = 0; i < 16; ++i) {
        most = std::max(most, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
        size = std::max(size, std::abs(a[i / 4][i % 4]));
    }
    return size > 0 ? most / size : most;
}

/// Dual quaternions are as good as matrices while all bones do the same, such as stand as bound.
void check_blending(const FbxObject& skin, const std::vector<Bone>& bones) {
    constexpr double kSame = 1e-5;
    const std::string type = skin.element->word("SkinningType");
    if (type.empty() || type == "Linear" || type == "Rigid") return;
    for (const Bone& bone : bones)
        if (difference(bones.front().world_from_mesh, bone.world_from_mesh) > kSame)
            refuse(skin, "SkinningType " + type + " in a pose is not read", "Linear");
}

}  // namespace

bool add_blend_shapes(const FbxObject& geometry, std::vector<glm::dvec3>& points) {
    bool is_moved = false;
    for (const FbxObject* blend : children_of(geometry, "Deformer", "BlendShape"))
        for (const FbxObject* channel : children_of(*blend, "Deformer", "BlendShapeChannel")) {
            const auto shapes = children_of(*channel, "Geometry", "Shape");
            if (shapes.empty() || percent_of(*channel) == 0) continue;
            const std::vector<double> shares = shares_of(*channel, shapes.size());
            for (std::size_t s = 0; s < shapes.size(); ++s)
                if (shares[s] != 0) add_shape(*shapes[s], shares[s], points);
            is_moved = true;
        }
    return is_moved;
}

std::optional<std::vector<glm::dmat4>> world_from_points(const FbxObject& geometry,
                                                         const FbxModel& model,
                                                         const std::vector<FbxModel>& models,
                                                         std::size_t points) {
    const auto skins = children_of(geometry, "Deformer", "Skin");
    if (skins.empty()) return std::nullopt;
    if (skins.size() > 1) refuse(*skins[1], "a second skin of one mesh is not read", "one skin");
    const std::vector<Bone> bones = bones_of(*skins[0], model, models);
    if (bones.empty()) return std::nullopt;
    check_blending(*skins[0], bones);
    std::vector<glm::dmat4> sums(points, glm::dmat4(0));
    std::vector<double> totals(points, 0);
    std::vector<bool> is_total(points, false);  // what the weights lack of 1 follows the mesh
    for (const Bone& bone : bones) {
        const std::vector<std::size_t> indices = indices_of(*bone.cluster, points);
        const std::vector<double> weights = bone.cluster->element->list("Weights");
        if (weights.size() != indices.size())
            fail(*bone.cluster, "its Weights are not those of its Indexes");
        const bool is_share = bone.cluster->element->word("Mode") == "Total1";
        for (std::size_t i = 0; i < indices.size(); ++i) {
            sums[indices[i]] += weights[i] * bone.world_from_mesh;
            totals[indices[i]] += weights[i];
            if (is_share) is_total[indices[i]] = true;
        }
    }
    const glm::dmat4 own = model.world_from_model * model.model_from_mesh;
    for (std::size_t p = 0; p < points; ++p) {
        if (is_total[p] && totals[p] < 1) {
            sums[p] += (1 - totals[p]) * own;
        } else {
            sums[p] = totals[p] > 0 ? sums[p] / totals[p] : own;
        }
    }
    return sums;
}

}  // namespace ink::import
