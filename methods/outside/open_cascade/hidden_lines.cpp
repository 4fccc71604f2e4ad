// Open CASCADE's hidden-line algorithms on the triangles of a view:
//
//     hidden_lines exact|polygonal|triangles mesh.obj lines.txt < camera
//
// The camera is a parallel one, in numbers: width and height in px, px per unit of length, and
// three rows of four of view_from_world. lines.txt gets "visible x,y x,y" and "hidden x,y x,y" in
// px, or "triangle x,y x,y x,y". Seconds go to standard output.
//
// The algorithms would draw every side of a triangle. Where two faces bend by less than the crease
// angle and lie on either side of their edge in the image, the edge is marked as smooth (G1)
// before, and comes back in a list that is not written. Creases, outlines and boundaries are.

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr double kCreaseRad = 40 * M_PI / 180;  ///< as the testbed's truth
constexpr double kSewingPx = 1e-6;              ///< corners so near are the same
constexpr double kNone = 1e-9;                  ///< so small a length, area or sine counts as none

/// Its axes lie in the origin: the polygonal algorithm does not move lines by a projector's place.
struct Camera {
    double width_px, height_px, px_per_unit;
    gp_XYZ eye_world;
    gp_Ax2 axes;
};

using Triangle = std::array<gp_Pnt, 3>;
using Objects = std::vector<std::vector<Triangle>>;

using Lines = std::pair<TopoDS_Shape, const char*>;  ///< and the word for them

Camera read_camera(std::istream& in) {
    Camera camera;
    std::array<gp_XYZ, 3> rows;  // right, up and back in world space
    in >> camera.width_px >> camera.height_px >> camera.px_per_unit;
    for (gp_XYZ& row : rows) {
        double x, y, z, moved;
        in >> x >> y >> z >> moved;
        row = gp_XYZ(x, y, z);
        camera.eye_world -= row * moved;
    }
    if (!in) throw std::runtime_error("no camera (accepted: 15 numbers)");
    camera.axes = gp_Ax2(gp_Pnt(0, 0, 0), rows[2], rows[0]);
    return camera;
}

/// Per object, the triangles of a Wavefront file, around the eye and in px, because Open CASCADE's
/// tolerances are lengths.
Objects read_objects(const std::string& path, const Camera& camera) {
    std::ifstream file(path);
    std::vector<gp_Pnt> points;
    Objects objects;
    for (char kind; file >> kind;) {
        double x, y, z;
        std::string rest;
        if (kind == 'v' && file >> x >> y >> z) {
            points.push_back((gp_XYZ(x, y, z) - camera.eye_world) * camera.px_per_unit);
        } else if (kind == 'o') {
            objects.emplace_back();
        } else if (std::size_t a, b, c; kind == 'f' && file >> a >> b >> c) {
            objects.back().push_back({points.at(a - 1), points.at(b - 1), points.at(c - 1)});
        }
        std::getline(file, rest);
    }
    if (!file.eof())
        throw std::runtime_error(path + ": cannot be read as inkbench export writes it");
    return objects;
}

/// Adds faces that share edges, without their shells: the algorithms leave out the back faces of a
/// closed shell, and sewing turns some shells of imported models inside out.
void add_sewn(const std::vector<Triangle>& triangles, TopoDS_Compound& shape) {
    BRepBuilderAPI_Sewing sewing(kSewingPx);
    for (const Triangle& t : triangles) {
        const gp_Vec normal = gp_Vec(t[0], t[1]).Crossed(gp_Vec(t[0], t[2]));
        if (normal.Magnitude() <= kNone) continue;
        BRepBuilderAPI_MakePolygon border(t[0], t[1], t[2], true);
        BRepBuilderAPI_MakeFace face(gp_Pln(t[0], normal), border.Wire(), true);
        if (face.IsDone()) sewing.Add(face.Face());
    }
    sewing.Perform();
    for (TopExp_Explorer at(sewing.SewedShape(), TopAbs_FACE); at.More(); at.Next())
        BRep_Builder().Add(shape, at.Current());
}

gp_Vec along_of(const TopoDS_Edge& edge) {
    return gp_Dir(gp_Vec(BRep_Tool::Pnt(TopExp::FirstVertex(edge)),
                         BRep_Tool::Pnt(TopExp::LastVertex(edge))));
}

/// From an edge to the corner of a face that is farthest from it, at a right angle. It does not
/// depend on how either is oriented, and is zero where the face has no area.
gp_Vec inward(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const gp_Vec along = along_of(edge);
    gp_Vec farthest;
    for (TopExp_Explorer at(face, TopAbs_VERTEX); at.More(); at.Next()) {
        const gp_Vec to(a, BRep_Tool::Pnt(TopoDS::Vertex(at.Current())));
        const gp_Vec across = to - along * to.Dot(along);
        if (across.Magnitude() > farthest.Magnitude()) farthest = across;
    }
    return farthest.Magnitude() > kNone ? farthest.Normalized() : gp_Vec();
}

/// Whether an edge of two faces is neither a crease nor an outline as seen along `back`.
bool is_smooth(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces, const gp_Vec& back) {
    if (faces.Extent() != 2) return false;
    const gp_Vec f = inward(edge, TopoDS::Face(faces.First()));
    const gp_Vec g = inward(edge, TopoDS::Face(faces.Last()));
    if (f.Magnitude() == 0 || g.Magnitude() == 0 || M_PI - f.Angle(g) >= kCreaseRad) return false;
    const gp_Vec across = back.Crossed(along_of(edge));
    const double f_side = f.Dot(across), g_side = g.Dot(across);
    const bool is_edge_on = std::abs(f_side) <= kNone && std::abs(g_side) <= kNone;
    return is_edge_on || f_side * g_side < 0;
}

void mark_smooth_edges(const TopoDS_Shape& shape, const gp_Vec& back) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
    for (int i = 1; i <= faces_of.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(faces_of.FindKey(i));
        const TopTools_ListOfShape& faces = faces_of(i);
        if (is_smooth(edge, faces, back))
            BRep_Builder().Continuity(
                edge, TopoDS::Face(faces.First()), TopoDS::Face(faces.Last()), GeomAbs_G1);
    }
}

/// The sharp edges and outlines of either algorithm's result.
template <class ToShape>
std::vector<Lines> lines_of(ToShape&& result) {
    return {{result.VCompound(), "visible"},
            {result.OutLineVCompound(), "visible"},
            {result.HCompound(), "hidden"},
            {result.OutLineHCompound(), "hidden"}};
}

std::vector<Lines> hidden_lines(bool is_exact, const TopoDS_Shape& shape, const Camera& camera) {
    if (is_exact) {
        const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
        algorithm->Add(shape);
        algorithm->Projector(HLRAlgo_Projector(camera.axes));
        algorithm->Update();
        algorithm->Hide();
        return lines_of(HLRBRep_HLRToShape(algorithm));
    }
    const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo(shape);
    algorithm->Projector(HLRAlgo_Projector(camera.axes));
    algorithm->Update();
    HLRBRep_PolyHLRToShape result;
    result.Update(algorithm);
    return lines_of(result);
}

void write_point(const gp_Pnt& p, const Camera& camera, std::ostream& out) {
    out << ' ' << camera.width_px / 2 + p.X() << ',' << camera.height_px / 2 - p.Y();
}

void write_lines(const std::vector<Lines>& lists, const Camera& camera, std::ostream& out) {
    for (const auto& [shape, kind] : lists) {
        if (shape.IsNull()) continue;
        BRepLib::BuildCurves3d(shape);
        for (TopExp_Explorer at(shape, TopAbs_EDGE); at.More(); at.Next()) {
            const BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));  // straight, as all are here
            out << kind;
            write_point(curve.Value(curve.FirstParameter()), camera, out);
            write_point(curve.Value(curve.LastParameter()), camera, out);
            out << '\n';
        }
    }
}

void write_triangles(const Objects& objects, const Camera& camera, std::ostream& out) {
    const HLRAlgo_Projector projector(camera.axes);
    for (const auto& object : objects) {
        for (Triangle t : object) {
            out << "triangle";
            for (gp_Pnt& p : t) {
                projector.Transform(p);
                write_point(p, camera, out);
            }
            out << '\n';
        }
    }
}

void run(const std::string& method, const std::string& mesh, std::ostream& out) {
    const Camera camera = read_camera(std::cin);
    const auto objects = read_objects(mesh, camera);
    if (method == "triangles") return write_triangles(objects, camera, out);
    const auto seconds = [start = std::chrono::steady_clock::now()] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    TopoDS_Compound shape;
    BRep_Builder().MakeCompound(shape);
    for (const auto& object : objects)
        add_sewn(object, shape);
    const double sewn_at = seconds();
    mark_smooth_edges(shape, camera.axes.Direction());
    if (method == "polygonal") BRepMesh_IncrementalMesh(shape, 1);
    const double begun = seconds();
    const auto lines = hidden_lines(method == "exact", shape, camera);
    std::cout << "sewing_s " << sewn_at << "\nmeshing_s " << begun - sewn_at << "\nalgorithm_s "
              << seconds() - begun << '\n';
    write_lines(lines, camera, out);
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count != 4) throw std::runtime_error("usage: hidden_lines METHOD mesh.obj lines.txt");
        std::ofstream out(words[3]);
        out << std::fixed << std::setprecision(4);
        run(words[1], words[2], out);
        if (!out.flush()) throw std::runtime_error("the lines cannot be written");
        return 0;
    } catch (const Standard_Failure& failure) {
        std::cerr << "Open CASCADE: " << failure.GetMessageString() << '\n';
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    }
    return 1;
}
