// A STEP or BRep file as triangles whose edges say what they are:
//
//     tessellate model.step|model.brep model.glb tolerance angle_deg tangent_deg
//
// The tolerance is a share of the diagonal of the model's box, the angle that by which neighbouring
// facets of a face may differ. One object per solid, and one for faces that are in none. An edge of
// two faces is hard where the faces meet by more than tangent_deg, an edge of one face always
// (EXT_mesh_primitive_edge_visibility). z up becomes y up. Counts go to standard output, as JSON.

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <array>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "glb.h"
#include "parts.h"

namespace {

TopoDS_Shape read_shape(const std::string& path) {
    TopoDS_Shape shape;
    std::string end = path.substr(path.find_last_of('.') + 1);
    for (char& c : end)
        c = static_cast<char>(std::tolower(c));
    if (end == "step" || end == "stp") {
        STEPControl_Reader reader;
        if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
            throw std::runtime_error(path + ": is no STEP file that Open CASCADE reads");
        reader.TransferRoots();
        shape = reader.OneShape();
    } else if (end == "brep") {
        BRepTools::Read(shape, path.c_str(), BRep_Builder());
    } else {
        throw std::runtime_error(path + ": ends in '" + end + "' (accepted: step, stp, brep)");
    }
    if (shape.IsNull() || !TopExp_Explorer(shape, TopAbs_FACE).More())
        throw std::runtime_error(path + ": it holds no face");
    return shape;
}

double diagonal_of(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, false);
    return std::sqrt(box.SquareExtent());
}

void run(const std::string& from, const std::string& to, const std::array<double, 3>& numbers) {
    const auto& [tolerance, angle_deg, tangent_deg] = numbers;
    const TopoDS_Shape shape = read_shape(from);
    BRepTools::Clean(shape);
    BRepMesh_IncrementalMesh(
        shape, tolerance * diagonal_of(shape), false, angle_deg * M_PI / 180, false);
    brep::EdgeCounts counts;
    const std::vector<brep::Part> parts = brep::make_parts(shape, tangent_deg * M_PI / 180, counts);
    std::ofstream file(to, std::ios::binary);
    if (!(file << brep::glb_of(parts)).flush())
        throw std::runtime_error(to + ": cannot be written");
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    std::size_t triangles = 0;
    for (const brep::Part& part : parts)
        triangles += part.triangles.size();
    std::cout << "{\"objects\": " << parts.size() << ", \"faces\": " << faces.Extent()
              << ", \"triangles\": " << triangles << ", \"edges\": " << counts.all
              << ", \"degenerate\": " << counts.degenerate << ", \"seams\": " << counts.seams
              << ", \"free\": " << counts.free << ", \"tangent\": " << counts.tangent
              << ", \"sharp\": " << counts.sharp << ", \"partly_sharp\": " << counts.partly
              << ", \"unmeshed\": " << counts.unmeshed << "}\n";
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 6)
            throw std::runtime_error("usage: tessellate IN OUT.glb TOLERANCE ANGLE TANGENT");
        run(argv[1], argv[2], {std::stod(argv[3]), std::stod(argv[4]), std::stod(argv[5])});
        return 0;
    } catch (const Standard_Failure& failure) {
        std::cerr << "tessellate: Open CASCADE: " << failure.GetMessageString() << '\n';
    } catch (const std::exception& error) {
        std::cerr << "tessellate: " << error.what() << '\n';
    }
    return 2;
}
