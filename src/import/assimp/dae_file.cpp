#include "import/assimp/dae_file.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <set>
#include <sstream>

#include "core/error.h"
#include "import/assimp/dae_document.h"
#include "import/meshes/line_words.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"
#include "import/refusal.h"
#include "import/xml.h"
#include "import/zip_archive.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;

/// Takes all elements of a name out; how many there were.
std::size_t take_out(Element top, std::string_view name) {
    const std::vector<Element> found = elements(top, name);
    for (Element element : found)
        element.parent().remove_child(element);
    return found.size();
}

bool take_out_motion(Element root) {
    const bool has_motion = !elements(root, "channel").empty();
    for (const char* library : {"library_animations", "library_animation_clips"})
        while (root.remove_child(library)) {
        }
    return has_motion;
}

/// Whether a modelling program hides a node, as FCollada writes it.
bool is_hidden(const Element& node) {
    for (const Element& extra : node.children("extra"))
        for (const Element& technique : extra.children("technique")) {
            const Element visibility = technique.child("visibility");
            const std::string word = lower_case(visibility.text().get());
            const auto words = words_of(word);
            if (visibility && !words.empty() && (words[0] == "0" || words[0] == "false"))
                return true;
        }
    return false;
}

/// What is hidden with a node is below it, too. Nodes stay, as joints may be hidden.
void take_out_hidden(Element root, std::vector<std::string>& notes) {
    std::size_t hidden = 0;
    for (const Element& node : elements(root, "node")) {
        if (!is_hidden(node)) continue;
        ++hidden;
        for (const char* use : {"instance_geometry", "instance_controller", "instance_node"})
            take_out(node, use);
    }
    if (hidden > 0) notes.push_back(counted(hidden, "hidden node") + ": left out");
}

/// The place of something that stands at `eye` and looks at a point, row by row.
std::string matrix_of_view(const std::vector<double>& n) {
    const glm::dvec3 eye(n[0], n[1], n[2]), target(n[3], n[4], n[5]), up(n[6], n[7], n[8]);
    const glm::dvec3 z = glm::normalize(eye - target);
    const glm::dvec3 x = glm::normalize(glm::cross(up, z));
    const glm::dvec3 y = glm::cross(z, x);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(17);
    for (int row = 0; row < 3; ++row)
        text << x[row] << ' ' << y[row] << ' ' << z[row] << ' ' << eye[row] << ' ';
    text << "0 0 0 1";
    return text.str();
}

/// Assimp takes too few numbers from the text behind, and does not square a view's axes.
void check_transform(Element transform, std::size_t count) {
    const std::string where = named(transform.parent()) + ", <" + transform.name() + '>';
    const std::vector<double> numbers = numbers_of(transform.text().get(), where);
    if (numbers.size() != count) {
        throw core::Error("",
                          where + " has " + std::to_string(numbers.size()) + " numbers",
                          std::to_string(count));
    }
    const std::string_view name = transform.name();
    if (name == "matrix" &&
        (numbers[12] != 0 || numbers[13] != 0 || numbers[14] != 0 || numbers[15] != 1))
        throw Refusal("", where + ": its last row is not 0 0 0 1", "affine matrices");
    if (name != "lookat") return;
    const std::string matrix = matrix_of_view(numbers);
    if (matrix.find("nan") != matrix.npos)
        throw core::Error(
            "", where + " looks nowhere", "an eye, another point and an up direction");
    transform.set_name("matrix");
    transform.text().set(matrix.c_str());
}

void check_transforms(Element root) {
    constexpr std::array<std::pair<const char*, std::size_t>, 5> kCounts{
        {{"matrix", 16}, {"lookat", 9}, {"translate", 3}, {"rotate", 4}, {"scale", 3}}};
    for (const Element& node : elements(root, "node")) {
        if (node.child("skew"))
            throw Refusal("", named(node) + " has a <skew>, which is not read", "a <matrix>");
        for (const auto& [name, count] : kCounts)
            for (const Element& transform : node.children(name))
                check_transform(transform, count);
    }
}

/// Whether a geometry has faces. A spline has none; other surfaces than meshes are refused.
bool has_mesh(Element geometry) {
    const std::string where = named(geometry);
    if (geometry.child("convex_mesh"))
        throw Refusal("", where + " is the hull of another, which is not read", "a <mesh>");
    if (geometry.child("brep"))
        throw Refusal("", where + " is a <brep> (NURBS), which is not read", "a <mesh>");
    const Element mesh = geometry.child("mesh");
    if (!elements(mesh, "ph").empty())
        throw Refusal("", where + " has polygons with holes, which are not read", "triangles");
    return static_cast<bool>(mesh);
}

/// Assimp takes each index for a number without a sign.
void check_indices(const Element& mesh) {
    for (const char* name : {"p", "vcount"})
        for (const Element& list : elements(mesh, name)) {
            const std::string_view text = list.text().get();
            const std::size_t odd = text.find_first_not_of("0123456789 \t\r\n+");
            if (odd == text.npos) continue;
            throw core::Error("",
                              named(mesh.parent()) + ", <" + name + ">: " +
                                  in_quotes(words_of(text.substr(odd)).front()) + " is no index",
                              "whole numbers of 0 or more");
        }
}

/// Assimp knows the parts of a vector by the names X, Y and Z alone; else all are the first.
void name_axes(const DaeDocument& dae, const Element& input) {
    const Element source = dae.target(input, "source", {"source"});
    Element accessor = source.child("technique_common").child("accessor");
    constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};
    std::vector<Element> names;
    for (const Element& parameter : accessor.children("param"))
        if (*parameter.attribute("name").value() != '\0') names.push_back(parameter);
    if (!accessor.child("param") && accessor.attribute("stride").as_uint() == 3)
        for (std::size_t k = 0; k < 3; ++k) {
            names.push_back(accessor.append_child("param"));
            names.back().append_attribute("name");
        }
    std::size_t other_places = names.size() == 3 ? 0 : 1;
    for (std::size_t n = 0; n < names.size(); ++n)
        for (std::size_t k = 0; k < 3; ++k)
            if (n != k && std::string_view(names[n].attribute("name").value()) == kAxes[k])
                ++other_places;
    if (other_places > 0)
        throw Refusal("", named(source) + " has other parameters than three", "X, Y and Z");
    for (std::size_t k = 0; k < 3; ++k)
        names[k].attribute("name").set_value(kAxes[k]);
}

/// Says what meshes are in the words that Assimp knows.
void mend_meshes(const DaeDocument& dae) {
    for (Element hull : elements(dae.root(), "convex_mesh"))
        if (!hull.attribute("convex_hull_of")) hull.set_name("mesh");
    for (Element vertices : elements(dae.root(), "vertices"))
        for (Element input : vertices.children("input"))  // normals before positions: too much
            if (std::string_view(input.attribute("semantic").value()) == "POSITION") {
                vertices.prepend_move(input);
                break;
            }
    for (const Element& mesh : elements(dae.root(), "mesh")) {
        check_indices(mesh);
        for (const Element& input : elements(mesh, "input")) {
            const std::string_view semantic = input.attribute("semantic").value();
            if (semantic == "POSITION" || semantic == "NORMAL") name_axes(dae, input);
        }
    }
}

/// Units and axes are those of the whole document.
void check_assets(const Element& root) {
    const Element whole = root.child("asset");
    for (const Element& asset : elements(root, "asset")) {
        const bool has_unit =
            asset.child("unit") && asset.child("unit").attribute("meter").as_double(1) !=
                                       whole.child("unit").attribute("meter").as_double(1);
        const std::string_view up = asset.child("up_axis").text().as_string("Y_UP");
        const bool has_axis =
            asset.child("up_axis") && up != whole.child("up_axis").text().as_string("Y_UP");
        if (has_unit || has_axis) {
            throw Refusal(
                "",
                named(asset.parent()) + " has a unit or an up_axis of its own, which is not read",
                "one for the document");
        }
    }
}

/// Assimp takes a fan for one polygon.
void make_triangles_of_fans(Element root) {
    for (Element fans : elements(root, "trifans")) {
        std::size_t stride = 1;
        for (const Element& input : fans.children("input"))
            stride = std::max<std::size_t>(stride, input.attribute("offset").as_uint() + 1ULL);
        std::string text;
        unsigned triangles = 0;
        while (const Element fan = fans.child("p")) {
            const std::string numbers = fan.text().get();
            const std::vector<std::string_view> words = words_of(numbers);
            for (std::size_t corner = 1; (corner + 2) * stride <= words.size(); ++corner) {
                for (const std::size_t from : {std::size_t{0}, corner, corner + 1})
                    for (std::size_t i = from * stride; i < (from + 1) * stride; ++i)
                        text.append(words[i]) += ' ';
                ++triangles;
            }
            fans.remove_child(fan);
        }
        fans.set_name("triangles");
        fans.remove_attribute("count");
        fans.append_attribute("count").set_value(triangles);
        if (triangles > 0) fans.append_child("p").text().set(text.c_str());
    }
}

/// Assimp's default for a skin without one is no place at all.
void name_bind_shapes(Element root) {
    for (Element skin : elements(root, "skin"))
        if (!skin.child("bind_shape_matrix"))
            skin.prepend_child("bind_shape_matrix").text().set("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
}

/// Assimp ends in a crash where nodes place themselves.
void check_placed_nodes(const DaeDocument& dae) {
    constexpr std::size_t kMostPlaces = 1'000'000;
    const std::size_t deepest = elements(dae.root(), "instance_node").size();
    std::vector<std::pair<Element, std::size_t>> open{{dae.root(), 0}};
    std::size_t places = 0;
    while (!open.empty()) {
        const auto [top, depth] = open.back();
        open.pop_back();
        for (const Element& use : elements(top, "instance_node")) {
            if (depth == deepest || ++places > kMostPlaces) {
                throw core::Error("",
                                  named(use) + " places itself, or too much",
                                  std::to_string(kMostPlaces) + " places at most");
            }
            open.emplace_back(dae.target(use, "url", {"node"}), depth + 1);
        }
    }
}

/// What nodes use is there, and has faces.
void check_uses(const DaeDocument& dae, std::vector<std::string>& notes) {
    std::size_t splines = 0;
    std::set<std::string> with_lines;
    for (Element use : elements(dae.root(), "instance_geometry")) {
        if (std::string_view(use.parent().name()) != "node") continue;  // of physics
        const Element geometry = dae.target(use, "url", {"geometry"});
        const bool is_spline = !has_mesh(geometry);
        if (is_spline) use.parent().remove_child(use);
        splines += is_spline ? 1 : 0;
        for (const char* kind : {"lines", "linestrips"})
            if (geometry.child("mesh").child(kind)) with_lines.insert(named(geometry));
    }
    for (const Element& skin : elements(dae.root(), "skin"))
        if (!has_mesh(dae.target(skin, "source", {"geometry"})))
            throw core::Error("", named(skin) + " covers no mesh", "the id of a <geometry>");
    check_placed_nodes(dae);
    for (const Element& use : elements(dae.root(), "instance_controller"))
        (void)dae.target(use, "url", {"controller"});
    if (dae.root().child("scene").child("instance_kinematics_scene"))
        notes.emplace_back("kinematics, as nodes stand where they are: left out");
    if (splines > 0) notes.push_back(counted(splines, "spline") + ": left out");
    if (!with_lines.empty())
        notes.push_back("lines of " + counted(with_lines.size(), "mesh") + ": left out");
}

}  // namespace

bool is_dae(const std::filesystem::path& path) {
    const std::string ending = lower_case(path.extension().string());
    return ending == ".dae" || ending == ".zae" ||
           head_of(path).find("<COLLADA") != std::string::npos;
}

DaeFile read_dae_text(std::string_view text) {
    pugi::xml_document document;
    load_xml(text, "", document);
    const Element root = document.child("COLLADA");
    if (!root) throw core::Error("", "it is XML without a <COLLADA>", "a COLLADA document");
    DaeFile file;
    file.cameras = dae_cameras(root);
    file.has_motion = take_out_motion(root);
    take_out_hidden(root, file.notes);
    check_assets(root);
    DaeDocument dae(root);
    mend_meshes(dae);
    bake_morphs(dae);
    check_transforms(root);
    make_triangles_of_fans(root);
    name_bind_shapes(root);
    check_uses(dae, file.notes);
    check_skins(dae);
    std::ostringstream out;
    document.save(out, "", pugi::format_raw, pugi::encoding_utf8);
    file.text = std::move(out).str();
    return file;
}

DaeFile read_dae(const std::filesystem::path& path) {
    if (!head_of(path).starts_with("PK")) return read_dae_text(text_of(bytes_of(path)));
    const ZipArchive archive(path);
    // The manifest names the document in whose place others may stand.
    std::string root;
    if (const std::string manifest = archive.find("manifest.xml"); !manifest.empty()) {
        pugi::xml_document document;
        load_xml(archive.read(manifest), manifest, document);
        const auto words = words_of(document.child("dae_root").text().get());
        if (!words.empty())
            root = archive.find(std::string(words[0].substr(words[0].starts_with("./") ? 2 : 0)));
    }
    for (const std::string& name : archive.names())
        if (root.empty() && lower_case(name).ends_with(".dae")) root = name;
    if (root.empty()) throw core::Error("", "it holds no COLLADA document", "a .dae file in it");
    return read_dae_text(archive.read(root));
}

}  // namespace ink::import
