#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/mesh.h"

// Meshes made by code. All of them are indexed (a shared corner is one vertex, a pole is one
// vertex, a ring closes by index), and run counter-clockwise seen from outside. Positions are
// multiples of 2^-20 as long as they are below 16: the last bits of a machine's sine never reach a
// mesh.

namespace ink::catalogue {

/// `p` rounded to multiples of 2^-20, never -0.
[[nodiscard]] glm::dvec3 snapped(const glm::dvec3& p);

/// Adds the triangles of `part` to `whole`; nothing is welded.
void append(scene::Mesh& whole, const scene::Mesh& part);

/// `mesh` with `world_from_object` baked into its positions; mirroring keeps the outside outside.
/// Materials stay; normals are dropped.
[[nodiscard]] scene::Mesh moved(const scene::Mesh& mesh, const glm::dmat4& world_from_object);

/// A row of points that `loft` joins to the next row. One point alone is a pole.
using Ring = std::vector<glm::dvec3>;

/// Which ways a loft closes on itself.
struct LoftEnds {
    bool around = true;  ///< the last point of each ring joins its first
    bool along = false;  ///< the last ring joins the first
};

/// The surface through `rings`, each of n points or one pole; two poles must not be neighbours.
///
/// Fronts face (next point) x (next ring): rings that run counter-clockwise seen from above and
/// climb show their fronts outwards. A quad is split from its first corner to its third.
[[nodiscard]] scene::Mesh loft(std::span<const Ring> rings, LoftEnds ends = {});

/// `count` points of the unit circle in the plane y = 0, counter-clockwise seen from above, from
/// +x.
[[nodiscard]] Ring unit_circle(int count);

/// The box between two corners, two triangles a side.
[[nodiscard]] scene::Mesh make_box(const glm::dvec3& low, const glm::dvec3& high);

/// A sheet of `count` quads over a unit square, each of its points put in place by `surface(u, v)`;
/// fronts face d/du x d/dv.
[[nodiscard]] scene::Mesh make_sheet(glm::ivec2 count,
                                     const std::function<glm::dvec3(double u, double v)>& surface);

/// The parallelogram from `corner` along `u` and `v`, cut into `count.x` by `count.y` quads; its
/// front faces u x v.
[[nodiscard]] scene::Mesh make_sheet(const glm::dvec3& corner,
                                     const glm::dvec3& u,
                                     const glm::dvec3& v,
                                     glm::ivec2 count = {1, 1});

/// The surface of revolution of `profile`, points (radius, height), about the y axis.
///
/// A profile that climbs shows its front outwards; radius 0 makes a pole; a profile whose last
/// point equals its first makes a closed ring (counter-clockwise in the plane of radius and
/// height).
[[nodiscard]] scene::Mesh revolve(std::span<const glm::dvec2> profile, int segments);

/// A ball of `stacks` rings of quads, `segments` round, poles up and down.
[[nodiscard]] scene::Mesh make_sphere(double radius, int segments, int stacks);

/// A ball of 20 * 4^levels triangles: an icosahedron, each triangle cut in four.
[[nodiscard]] scene::Mesh make_icosphere(double radius, int levels);

/// A ring about the y axis; `radii` are (of the ring, of the tube), `counts` (round it, round the
/// tube).
[[nodiscard]] scene::Mesh make_torus(glm::dvec2 radii, glm::ivec2 counts);

/// A closed prism of `sides` on the circle of `radius`, from y = 0 to `height`.
[[nodiscard]] scene::Mesh make_cylinder(double radius, double height, int sides);

/// A closed pyramid of `sides` on the circle of `radius`, from y = 0 to its tip at `height`.
[[nodiscard]] scene::Mesh make_cone(double radius, double height, int sides);

/// The closed solid over a simple polygon in the plane z = `z.x`, up to `z.y`. `outline` runs
/// counter-clockwise seen from +z; it need not be convex.
[[nodiscard]] scene::Mesh extrude(std::span<const glm::dvec2> outline, glm::dvec2 z);

/// A station of a tube.
struct TubeNode {
    glm::dvec3 center;
    double radius;
};

/// `path` with `cuts` stations for each stretch between two of its nodes, on the uniform
/// Catmull-Rom curve through them (Catmull and Rom 1974), radii included.
[[nodiscard]] std::vector<TubeNode> smoothed(std::span<const TubeNode> path, int cuts);

/// The round tube through `path`, its rings carried along without twist (Bloomenthal 1990,
/// "Calculation of reference frames along a space curve"). Ends are capped flat.
[[nodiscard]] scene::Mesh make_tube(std::span<const TubeNode> path, int segments);

/// The same, its last station joined to its first; what twist is left is spread over all rings.
[[nodiscard]] scene::Mesh make_closed_tube(std::span<const TubeNode> path, int segments);

/// The four pieces of the teapot that Martin Newell made of 32 Bezier patches in 1975, in his scale
/// (3.15 high), y up, spout along +x.
struct Teapot {
    scene::Mesh body;  ///< with rim and bottom; open at the top
    scene::Mesh lid;
    scene::Mesh handle;  ///< its ends reach into the body
    scene::Mesh spout;   ///< likewise; open at the mouth
};

/// The teapot with `cuts` quads along each side of a patch.
[[nodiscard]] Teapot make_teapot(int cuts);

}  // namespace ink::catalogue
