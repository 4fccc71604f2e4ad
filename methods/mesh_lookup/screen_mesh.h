#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "methods/mesh_lookup/lookup_mesh.h"
#include "methods/mesh_lookup/screen_kernel.h"
#include "raster/pass/view_transform.h"
#include "scene/camera.h"

namespace ink::methods {

/// Two neighbouring samples and the faces seen there (kNoNeighbour: sky). `x` and `y` are the first
/// one's place in the view that is drawn; the second is the next to the right, or below.
struct SampleSide {
    int x = 0;
    int y = 0;
    bool is_down = false;
    std::uint32_t first = kNoNeighbour;
    std::uint32_t second = kNoNeighbour;
};

/// The line between two samples, if any, and how far from the first to the second it lies, 0..1.
struct FoundLine {
    LineKind kind = LineKind::none;
    double s = 0.5;
};

/// A line between two samples, and what it is the line of: an edge of a face, or the intersection
/// of two faces.
struct Crossing {
    static constexpr std::uint8_t kIntersection = 3;
    static constexpr std::uint8_t kUnknown = 4;  ///< there is a line, and no more is known

    std::uint32_t face = kNoNeighbour;
    std::uint32_t other = kNoNeighbour;  ///< of an intersection
    std::uint8_t edge = kUnknown;        ///< 0..2 of `face`, or one of the above
    LineKind kind = LineKind::none;
    float s = 0.5F;  ///< 0..1 from the first sample to the second
    float q = 0;     ///< 1/w there; 0 where it is not known
};

/// The lines between two samples, from the first on. Those that find no room are left out.
struct SideLines {
    std::array<Crossing, 8> crossings;
    std::size_t count = 0;

    void add(const Crossing& crossing) {
        if (count < crossings.size()) crossings[count++] = crossing;
    }
    [[nodiscard]] std::span<const Crossing> all() const { return {crossings.data(), count}; }
};

/// How lines are looked for.
struct WalkOptions {
    double crease_rad = 0;
    int most_steps = 64;  ///< faces that a walk may cross
};

/// A LookupMesh as one view sees it, in which lines between samples are looked up.
///
/// Positions are those that the rasterizer covers samples by, snapped to 1/256 px, so that a face
/// which it drew at a sample holds that sample here, too. Any number of threads may ask at once.
class ScreenMesh {
  public:
    /// Takes the vertices to the screen. `mesh` is borrowed until the next call.
    void see(const LookupMesh& mesh,
             const scene::View& view,
             const WalkOptions& options,
             int threads);

    /// Walks over the mesh between two samples that list_sides() lists, from the one and, if that
    /// does not come to the other, from the other back. There is no line if either walk arrives;
    /// else the nearer of the lines that ended them; else the two surfaces cross in between.
    [[nodiscard]] FoundLine line_between(const SampleSide& side) const;

    /// All lines between two samples that differ, those included over which the surface goes on,
    /// and what each is the line of, in `lines`, instead of what these were. line_between() tells
    /// of the same sides whether there is one.
    void lines_between(const SampleSide& side, SideLines& lines) const;

    /// What can be told of a side without depths and classes.
    enum class Glimpse { unknown, none, line };
    /// As line_between() has it, wherever it is not `unknown`; a fraction of its time.
    [[nodiscard]] Glimpse glimpse(const SampleSide& side) const;

    [[nodiscard]] const LookupMesh& mesh() const { return *mesh_; }
    /// Per face, which side of it is seen: 1 and -1, 0 edge-on.
    [[nodiscard]] std::span<const std::int8_t> facing() const { return facing_; }
    /// Per face, whether a corner of it, or of a face beside it, lies before the near plane; empty
    /// if none does.
    [[nodiscard]] std::span<const std::uint8_t> is_cut() const { return is_cut_; }

    /// A vertex as scene::Projection has it: x/w and y/w are px.
    [[nodiscard]] glm::dvec3 p_clip(std::uint32_t vertex) const {
        return transform_.to_clip(mesh_->p_world[vertex]);
    }
    [[nodiscard]] double crease_rad() const { return options_.crease_rad; }
    /// The least w that is drawn.
    [[nodiscard]] double near() const { return near_; }
    [[nodiscard]] const scene::Projection& projection() const { return *projection_; }

  private:
    /// Relative: what the depth test cannot tell apart.
    static constexpr double kSameDepth = 1e-6;

    class Walk;
    class Glance;
    class SideSearch;

    /// A vertex on the screen. What cannot be put there is told by the clip space.
    struct Vertex {
        double q = 0;
        std::int32_t x = kOffScreen;  ///< 1/256 px
        std::int32_t y = kOffScreen;

        [[nodiscard]] bool is_on_screen() const { return x != kOffScreen; }
    };

    void find_cut(int threads);
    [[nodiscard]] Vertex vertex(std::uint32_t i) const {
        return {q_[i], places_[i].x, places_[i].y};
    }
    [[nodiscard]] int side_of(std::uint32_t a, std::uint32_t b, std::uint32_t corner) const;
    [[nodiscard]] bool is_open(std::uint32_t face, Twin twin) const {
        return twin.is_open(facing_[face], facing_[twin.face()]);
    }
    [[nodiscard]] bool covers(const SampleSide& side,
                              bool is_second,
                              std::uint32_t seen,
                              std::uint32_t other) const;
    [[nodiscard]] bool goes_on(const SampleSide& side,
                               const Walk& walk,
                               const Walk& other,
                               bool is_second) const;
    [[nodiscard]] bool is_crack(const Walk& there, const Walk& back) const;
    [[nodiscard]] bool glimpse_lines(const SampleSide& side, SideLines& lines) const;
    [[nodiscard]] FoundLine between_surfaces(const SampleSide& side,
                                             const Walk& there,
                                             const Walk& back) const;

    const LookupMesh* mesh_ = nullptr;
    WalkOptions options_;
    std::vector<double> q_;  ///< per vertex
    std::vector<glm::ivec2> places_;
    std::vector<std::int8_t> facing_;
    std::vector<std::uint8_t> is_cut_;
    raster::ViewTransform transform_;
    std::optional<scene::Projection> projection_;
    scene::Viewpoint eye_;
    double near_ = 0;
};

}  // namespace ink::methods
