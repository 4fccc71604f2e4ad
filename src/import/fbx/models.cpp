#include "import/fbx/models.h"

#include <array>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <set>

#include "import/model_bytes.h"

namespace ink::import {
namespace {

enum InheritType { kRrSs = 0, kRSrs = 1, kRrs = 2 };
constexpr int kSpheric = 6;

[[noreturn]] void refuse_model(const FbxObject& object,
                               const std::string& what,
                               const char* accepted) {
    throw Refusal("", "model \"" + object.name + "\": " + what, accepted);
}

glm::dmat4 turned(const glm::dvec3& degrees, const std::array<int, 3>& axes) {
    glm::dmat4 turn(1);
    for (const int axis : axes) {  // the first is applied first
        glm::dvec3 about{0};
        about[axis] = 1;
        const double angle_rad = degrees[axis] * std::numbers::pi / 180;
        turn = glm::rotate(glm::dmat4(1), angle_rad, about) * turn;
    }
    return turn;
}

glm::dmat4 turned_in_order(const FbxObject& object) {
    static constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}, {2, 1, 0}}};
    const glm::dvec3 degrees = object.properties.vector("Lcl Rotation", glm::dvec3(0));
    const int order = object.properties.whole("RotationOrder", 0);
    const int angles = (degrees.x != 0) + (degrees.y != 0) + (degrees.z != 0);
    if (order >= 0 && order < kSpheric) return turned(degrees, kOrders[order]);
    if (angles > 1) {
        refuse_model(object,
                     "RotationOrder " + std::to_string(order) +
                         (order == kSpheric ? " (SphericXYZ)" : "") + " is not read",
                     "0..5, Euler angles");
    }
    return turned(degrees, kOrders[0]);
}

glm::dmat4 moved(const glm::dvec3& by) {
    return glm::translate(glm::dmat4(1), by);
}

/// A model's own transform, and its rotation alone.
struct Local {
    glm::dmat4 parent_from_model;
    glm::dmat3 turn;
};

Local local_of(const FbxObject& object, const glm::dvec3& scale) {
    const auto vector = [&](const char* name) {
        return object.properties.vector(name, glm::dvec3(0));
    };
    static constexpr std::array<int, 3> kXyz{0, 1, 2};
    const glm::dmat4 turn = turned(vector("PreRotation"), kXyz) * turned_in_order(object) *
                            glm::transpose(turned(vector("PostRotation"), kXyz));
    const glm::dvec3 turn_pivot = vector("RotationPivot"), scale_pivot = vector("ScalingPivot");
    return {moved(vector("Lcl Translation") + vector("RotationOffset") + turn_pivot) * turn *
                moved(vector("ScalingOffset") + scale_pivot - turn_pivot) *
                glm::scale(glm::dmat4(1), scale) * moved(-scale_pivot),
            glm::dmat3(turn)};
}

glm::dmat3 scaled(const glm::dvec3& scale) {
    return {{scale.x, 0, 0}, {0, scale.y, 0}, {0, 0, scale.z}};
}

/// Sets where the model stands below `parent`.
void place(FbxModel& model, const FbxModel& parent) {
    model.scale = model.object->properties.vector("Lcl Scaling", glm::dvec3(1));
    const Local local = local_of(*model.object, model.scale);
    model.turn = parent.turn * local.turn;
    model.world_from_model = parent.world_from_model * local.parent_from_model;
    const int inherit = model.object->properties.whole("InheritType", kRrSs);
    if (inherit == kRSrs) return;
    // The scales above, as the parent has them in its own axes.
    glm::dmat3 scales = glm::transpose(parent.turn) * glm::dmat3(parent.world_from_model);
    if (inherit == kRrs) {
        if (parent.scale.x * parent.scale.y * parent.scale.z == 0)
            refuse_model(
                *model.object, "InheritType 2 below a scale of 0 is not read", "other scales");
        scales = scales * scaled(1.0 / parent.scale);
    }
    const glm::dmat3 axes = model.turn * scales * scaled(model.scale);
    for (int axis = 0; axis < 3; ++axis)
        model.world_from_model[axis] = glm::dvec4(axes[axis], 0);
}

glm::dmat4 geometric(const FbxObject& object) {
    return moved(object.properties.vector("GeometricTranslation", glm::dvec3(0))) *
           turned(object.properties.vector("GeometricRotation", glm::dvec3(0)), {0, 1, 2}) *
           glm::scale(glm::dmat4(1), object.properties.vector("GeometricScaling", glm::dvec3(1)));
}

}  // namespace

// No recursion: a hostile tree is deep, or goes round.
std::vector<FbxModel> read_fbx_models(const FbxDocument& document,
                                      const glm::dmat4& world_from_file) {
    struct Open {
        const FbxObject* object;
        std::size_t parent;
        bool is_hidden;  ///< from above
    };
    // The world is a model, too: the file's axes are its rotation, its unit and hand scales.
    FbxModel world{.world_from_model = world_from_file};
    for (int axis = 0; axis < 3; ++axis)
        world.turn[axis] = glm::sign(glm::dvec3(world_from_file[axis]));
    world.turn *= glm::determinant(world.turn);
    std::vector<FbxModel> models{world};
    std::vector<Open> open;
    std::set<const FbxObject*> known;
    const auto open_children = [&](const FbxObject& of, std::size_t parent, bool is_hidden) {
        const auto children = children_of(of, "Model");
        for (std::size_t c = children.size(); c-- > 0;)
            open.push_back({children[c], parent, is_hidden});
    };
    open_children(document.scene(), 0, false);
    while (!open.empty()) {
        const Open current = open.back();
        open.pop_back();
        if (!known.insert(current.object).second) continue;
        const FbxProperties& properties = current.object->properties;
        const bool inherits = properties.whole("Visibility Inheritance", 1) != 0;
        const bool is_seen =
            properties.real("Visibility", 1) > 0 && !(inherits && current.is_hidden);
        FbxModel model{.object = current.object, .model_from_mesh = geometric(*current.object)};
        model.is_hidden = !is_seen || properties.whole("Show", 1) == 0;
        place(model, models[current.parent]);
        models.push_back(model);
        open_children(*current.object, models.size() - 1, !is_seen);
    }
    models.erase(models.begin());
    return models;
}

}  // namespace ink::import
