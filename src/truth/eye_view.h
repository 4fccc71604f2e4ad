#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "scene/camera.h"
#include "scene/precision/weld_tolerance.h"
#include "truth/model.h"

namespace ink::truth {

inline constexpr std::uint32_t kNoFace = 0xffffffffU;

/// The faces of an edge that the eye sees to either side of it, kNoFace where there is none.
struct SeenFaces {
    std::uint32_t left = kNoFace;
    std::uint32_t right = kNoFace;
};

/// What one eye makes of a model: the exact facing of faces and class of edges, and where vertices
/// are on the image. Borrows the model.
struct EyeView {
    const Model& model;
    scene::Projection projection;
    glm::dmat3 view_from_world;
    int width_px = 0;
    int height_px = 0;
    double near = 0;
    std::vector<glm::dvec4> p_clip;     ///< per vertex, as Projection::to_homogeneous has it
    std::vector<std::int8_t> facing;    ///< per face: 1 front, -1 back, 0 edge-on, exact
    std::vector<LineClass> edge_class;  ///< per edge, by its own faces; class_at has the rest

    EyeView(const Model& model, const scene::View& view, int threads);

    [[nodiscard]] const scene::Viewpoint& eye() const { return projection.viewpoint(); }

    /// On which side of the plane through the eye and the edge its i-th face lies: 1, -1, or 0 for
    /// a face in that plane. Exact.
    [[nodiscard]] int side(const scene::Edge& edge, std::size_t i) const {
        return facing[model.topology.edge_faces[edge.first_face + i]] *
               model.runs[edge.first_face + i];
    }

    /// Of several faces on one side only the one nearest the eye is seen; ties go to the lowest.
    [[nodiscard]] SeenFaces seen_faces(const scene::Edge& edge) const;

    /// Whether the surface goes on before the eye at the point t of a boundary edge: the edge's
    /// face and what continues it lie on different sides of it (else the surface folds there, and
    /// the eye sees its rim), and the gap between them is too small for the image.
    [[nodiscard]] bool goes_on(const Continuation& continuation, double t) const;

    /// The point t of an edge.
    [[nodiscard]] glm::dvec4 clip_at(const scene::Edge& edge, double t) const {
        return p_clip[edge.a] + t * (p_clip[edge.b] - p_clip[edge.a]);
    }
    /// Whether a point lies before the near plane, by a function that is linear along lines.
    [[nodiscard]] bool is_before_near(const glm::dvec4& p) const { return behind_near(p) < 0; }
    [[nodiscard]] double behind_near(const glm::dvec4& p) const { return p.z - near * p.w; }

    /// Whether the image is too coarse to show a length at a point: it takes less than 1/64 px
    /// there.
    [[nodiscard]] bool is_unseen(double length_world, const glm::dvec4& p) const {
        return length_world * projection.focal_px() < scene::kUnseen_px * std::max(p.z, near * p.w);
    }

    /// The class of a point of an edge: edge_class, save that a stretch of boundary across which
    /// the surface goes on is a `seam` if another object goes on and else `none`: a defect, not
    /// drawn; and that where the edge lies in other faces the rule of touching.h holds.
    [[nodiscard]] LineClass class_at(std::uint32_t edge, double t) const;
};

/// A stretch of an edge that has one class.
struct ClassStretch {
    LineClass line_class = LineClass::none;
    double t_begin = 0;
    double t_end = 1;
};

/// The stretches of an edge that are lines, ascending; slits shorter than a few weld tolerances
/// go to the stretch after them.
[[nodiscard]] std::vector<ClassStretch> line_stretches(const EyeView& eye, std::uint32_t edge);

}  // namespace ink::truth
