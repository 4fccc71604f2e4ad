#include "parts.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <map>
#include <stdexcept>

namespace brep {
namespace {

/// A use of an edge by a face: its border, with the face on the left.
struct Side {
    TopoDS_Edge edge;
    TopoDS_Face face;
};

/// Numbers in sets that are joined.
class Joined {
  public:
    std::uint32_t add() {
        parents_.push_back(static_cast<std::uint32_t>(parents_.size()));
        return parents_.back();
    }
    std::uint32_t root(std::uint32_t i) {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a), b = root(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::uint32_t> parents_;
};

/// From a point of a face's border into the face, at a right angle to the border; zero where the
/// surface has no normal. Does not depend on which side of the face is outside.
gp_Vec inward(const Side& side, double t) {
    double first, last;
    const auto curve = BRep_Tool::CurveOnSurface(side.edge, side.face, first, last);
    if (curve.IsNull()) return {};
    const gp_Pnt2d uv = curve->Value(t);
    BRepLProp_SLProps surface(BRepAdaptor_Surface(side.face, false), uv.X(), uv.Y(), 1, 1e-9);
    gp_Pnt p;
    gp_Vec along;
    BRepAdaptor_Curve(side.edge).D1(t, p, along);
    if (!surface.IsNormalDefined() || along.Magnitude() < 1e-12) return {};
    const gp_Vec in = gp_Vec(surface.Normal()).Crossed(along.Normalized());
    // An edge runs with its face on the left, seen from the face's outside.
    const bool is_turned = side.edge.Orientation() != side.face.Orientation();
    return is_turned ? -in : in;
}

/// Whether two faces meet there by more than an angle.
bool is_sharp(const std::vector<Side>& sides, double t, double tangent_rad) {
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size(); ++j) {
            const gp_Vec a = inward(sides[i], t), b = inward(sides[j], t);
            if (a.Magnitude() < 0.5 || b.Magnitude() < 0.5) continue;
            if (M_PI - a.Angle(b) > tangent_rad) return true;
        }
    return false;
}

/// One object: its faces' triangles, with the points of an edge the same in all of its faces.
class PartMaker {
  public:
    PartMaker(double tangent_rad, TopTools_IndexedMapOfShape& counted, EdgeCounts& counts)
        : tangent_rad_(tangent_rad), counted_(counted), counts_(counts) {}

    void add(const TopoDS_Shape& shape) {
        for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
            add_face(TopoDS::Face(at.Current()));
    }

    [[nodiscard]] Part made() {
        std::vector<std::pair<Segment, bool>> segments;
        for (int e = 1; e <= edges_.Extent(); ++e)
            add_edge(sides_[static_cast<std::size_t>(e - 1)], segments);
        Part part;
        std::map<std::uint32_t, std::uint32_t> number;
        const auto final = [&](std::uint32_t node) {
            const std::uint32_t root = joined_.root(node);
            const auto [at, is_new] = number.try_emplace(root, part.points.size());
            if (is_new) part.points.push_back(points_[root]);
            return at->second;
        };
        for (const auto& [a, b, c] : triangles_) {
            const std::array<std::uint32_t, 3> t{final(a), final(b), final(c)};
            if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) part.triangles.push_back(t);
        }
        for (const auto& [ends, is_hard] : segments)
            if (is_hard) part.hard.insert(segment(final(ends.first), final(ends.second)));
        return part;
    }

  private:
    void add_face(const TopoDS_Face& face) {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(face, location);
        if (mesh.IsNull()) throw std::runtime_error("a face could not be tessellated");
        first_node_[faces_.Add(face)] = static_cast<std::uint32_t>(points_.size());
        for (int i = 1; i <= mesh->NbNodes(); ++i) {
            points_.push_back(mesh->Node(i).Transformed(location));
            joined_.add();
        }
        const bool is_mirrored = location.Transformation().IsNegative();
        const bool is_turned = (face.Orientation() == TopAbs_REVERSED) != is_mirrored;
        for (int i = 1; i <= mesh->NbTriangles(); ++i) {
            int a, b, c;
            mesh->Triangle(i).Get(a, b, c);
            if (is_turned) std::swap(b, c);
            triangles_.push_back({node(face, a), node(face, b), node(face, c)});
        }
        for (TopExp_Explorer at(face, TopAbs_EDGE); at.More(); at.Next()) {
            const auto number = static_cast<std::size_t>(edges_.Add(at.Current()));
            if (sides_.size() < number) sides_.resize(number);
            sides_[number - 1].push_back({TopoDS::Edge(at.Current()), face});
        }
    }

    [[nodiscard]] std::uint32_t node(const TopoDS_Face& face, int index) const {
        return first_node_.at(faces_.FindIndex(face)) + static_cast<std::uint32_t>(index) - 1;
    }

    /// The nodes of an edge in one of its faces, in the order of the edge's parameter, and these.
    [[nodiscard]] std::vector<std::uint32_t> nodes_of(const Side& side,
                                                      std::vector<double>& parameters) const {
        TopLoc_Location location;
        const auto mesh = BRep_Tool::Triangulation(side.face, location);
        // For the second use of a seam the edge's orientation picks the second polygon.
        const auto polygon = BRep_Tool::PolygonOnTriangulation(side.edge, mesh, location);
        std::vector<std::uint32_t> nodes;
        if (polygon.IsNull()) return nodes;
        parameters.clear();
        for (int i = 1; i <= polygon->NbNodes(); ++i) {
            nodes.push_back(node(side.face, polygon->Node(i)));
            if (polygon->HasParameters()) parameters.push_back(polygon->Parameter(i));
        }
        return nodes;
    }

    void add_edge(const std::vector<Side>& sides, std::vector<std::pair<Segment, bool>>& segments) {
        const TopoDS_Edge& edge = sides.front().edge;
        std::vector<double> t;
        const std::vector<std::uint32_t> nodes = nodes_of(sides.front(), t);
        bool is_whole = nodes.size() > 1 || BRep_Tool::Degenerated(edge);
        for (const Side& side : sides) {
            std::vector<double> other_t;
            const auto other = nodes_of(side, other_t);
            is_whole = is_whole && other.size() == nodes.size();
            for (std::size_t i = 0; i < std::min(other.size(), nodes.size()); ++i)
                joined_.join(nodes[i], other[i]);
        }
        if (BRep_Tool::Degenerated(edge)) {
            for (const std::uint32_t other : nodes)
                joined_.join(nodes.front(), other);
            if (is_new(edge)) ++counts_.degenerate;
            return;
        }
        std::size_t hard = 0;
        const std::size_t count = nodes.empty() ? 0 : nodes.size() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_hard =
                sides.size() == 1 ||
                (t.size() == nodes.size() && is_sharp(sides, (t[i] + t[i + 1]) / 2, tangent_rad_));
            hard += is_hard;
            segments.push_back({{nodes[i], nodes[i + 1]}, is_hard});
        }
        if (!is_new(edge)) return;
        ++counts_.all;
        counts_.unmeshed += !is_whole;
        const bool is_of_one_face = sides.size() == 2 && sides[0].face.IsSame(sides[1].face);
        if (sides.size() == 1) {
            ++counts_.free;
        } else if (hard > 0) {
            ++counts_.sharp;
            counts_.partly += hard < count;
        } else {
            ++(is_of_one_face ? counts_.seams : counts_.tangent);
        }
    }

    /// Whether no place of the edge was counted yet.
    [[nodiscard]] bool is_new(const TopoDS_Edge& edge) {
        const TopoDS_Shape unplaced = edge.Located(TopLoc_Location());
        const int before = counted_.Extent();
        return counted_.Add(unplaced) > before;
    }

    double tangent_rad_;
    TopTools_IndexedMapOfShape& counted_;
    EdgeCounts& counts_;
    TopTools_IndexedMapOfShape faces_, edges_;
    std::map<int, std::uint32_t> first_node_;
    std::vector<std::vector<Side>> sides_;
    std::vector<gp_Pnt> points_;
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    Joined joined_;
};

}  // namespace

std::vector<Part> make_parts(const TopoDS_Shape& shape, double tangent_rad, EdgeCounts& counts) {
    TopTools_IndexedMapOfShape counted;
    std::vector<Part> parts;
    const auto add = [&](PartMaker& maker) {
        Part part = maker.made();
        if (!part.triangles.empty()) parts.push_back(std::move(part));
    };
    for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) {
        PartMaker maker(tangent_rad, counted, counts);
        maker.add(at.Current());
        add(maker);
    }
    PartMaker rest(tangent_rad, counted, counts);
    for (TopExp_Explorer at(shape, TopAbs_FACE, TopAbs_SOLID); at.More(); at.Next())
        rest.add(at.Current());
    add(rest);
    return parts;
}

}  // namespace brep
