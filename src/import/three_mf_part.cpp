#include "import/three_mf_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/parse_number.h"
#include "import/meshes/line_words.h"
#include "import/refusal.h"
#include "import/xml.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;

constexpr const char* kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
/// What changes no shape, or is read.
constexpr std::array<std::string_view, 4> kKnown{
    kCore,
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{{{"micron", 1e-6},
                                                                     {"millimeter", 1e-3},
                                                                     {"centimeter", 1e-2},
                                                                     {"inch", 0.0254},
                                                                     {"foot", 0.3048},
                                                                     {"meter", 1}}};

std::optional<double> finite_number(std::string_view word) {
    const auto number = core::parse_number<double>(word.substr(word.starts_with('+') ? 1 : 0));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

double number_in(const Element& element, const char* key, const std::string& where) {
    const std::string_view text = element.attribute(key).value();
    const auto words = words_of(text);
    const auto number = words.size() == 1 ? finite_number(words[0]) : std::nullopt;
    if (number) return *number;
    throw core::Error(
        "", where + ": " + key + " of a vertex is " + in_quotes(text), "a number that floats hold");
}

std::uint32_t index_in(const Element& element,
                       const char* key,
                       std::size_t count,
                       const std::string& where) {
    const std::string_view text = element.attribute(key).value();
    const auto words = words_of(text);
    const auto index =
        words.size() == 1 ? core::parse_number<std::uint32_t>(words[0]) : std::nullopt;
    if (index && *index < count) return *index;
    throw core::Error("",
                      where + ": " + key + " of a triangle is " + in_quotes(text),
                      count == 0 ? "a mesh with vertices" : "0.." + std::to_string(count - 1));
}

/// "#RRGGBB" or "#RRGGBBAA".
glm::vec4 color_of(std::string_view text) {
    const auto value = core::parse_number<std::uint32_t>(text.substr(text.empty() ? 0 : 1), 16);
    if (!text.starts_with('#') || !value || (text.size() != 7 && text.size() != 9))
        return glm::vec4(1);
    const std::uint32_t rgba = text.size() == 9 ? *value : (*value << 8U | 255U);
    glm::vec4 color;
    for (int k = 0; k < 4; ++k)
        color[k] = static_cast<float>(rgba >> (24U - 8U * static_cast<unsigned>(k)) & 255U) / 255;
    return color;
}

}  // namespace

std::string attribute_of(const Element& element, std::string_view name) {
    for (const pugi::xml_attribute& attribute : element.attributes()) {
        const std::string_view key = attribute.name();
        if (key.substr(key.find(':') + 1) == name) return attribute.value();
    }
    return {};
}

glm::dmat4 transform_of(const Element& element, const std::string& where) {
    const pugi::xml_attribute attribute = element.attribute("transform");
    glm::dmat4 transform(1);
    if (!attribute) return transform;
    const std::string_view text = attribute.value();
    const auto words = words_of(text);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto number = finite_number(words[i]);
        if (!number || words.size() != 12) break;
        transform[static_cast<int>(i / 3)][static_cast<int>(i % 3)] = *number;
        if (i == 11) return transform;
    }
    throw core::Error("", where + ": transform is " + in_quotes(text), "12 numbers");
}

ThreeMfPart::ThreeMfPart(const std::string& name, const std::string& text) : name_(name) {
    load_xml(text, name, document_);
    model_ = document_.document_element();
    const std::string tag = model_.name();
    core_ = tag.substr(0, tag.find(':') + 1);
    const std::string uses = core_.empty() ? "xmlns" : "xmlns:" + core_.substr(0, core_.size() - 1);
    const std::string_view language = model_.attribute(uses.c_str()).value();
    if (tag != core_ + "model" || language != kCore) {
        throw core::Error("",
                          "its file " + in_quotes(name) + " is no 3MF model: <" + tag + "> of " +
                              in_quotes(language),
                          std::string("<model> of ") + kCore);
    }
    check_extensions();
    const pugi::xml_attribute unit = model_.attribute("unit");
    const auto known = std::ranges::find_if(
        kUnits, [&](const auto& entry) { return entry.first == unit.value(); });
    if (unit && known == kUnits.end()) {
        throw core::Error(
            "",
            "its file " + in_quotes(name) + " has the unit " + in_quotes(unit.value()),
            "micron, millimeter, centimeter, inch, foot or meter");
    }
    if (unit) unit_m_ = known->second;
    for (const Element& resource : child(model_, "resources").children()) {
        const std::string id = resource.attribute("id").value();
        if (is(resource, "basematerials")) base_materials_.emplace(id, resource);
        if (!is(resource, "object") || objects_.emplace(id, resource).second) continue;
        throw core::Error("", named(resource) + " is there twice", "ids of their own");
    }
}

bool ThreeMfPart::is(const Element& element, std::string_view name) const {
    const std::string_view tag = element.name();
    return tag.starts_with(core_) && tag.substr(core_.size()) == name;
}

Element ThreeMfPart::child(const Element& of, std::string_view name) const {
    return of.child((core_ + std::string(name)).c_str());
}

std::vector<std::string> ThreeMfPart::unknown_extensions(const char* attribute) const {
    std::vector<std::string> unknown;
    for (const std::string_view prefix : words_of(model_.attribute(attribute).value())) {
        const std::string key = "xmlns:" + std::string(prefix);
        const std::string_view language = model_.attribute(key.c_str()).value();
        if (std::ranges::find(kKnown, language) != kKnown.end()) continue;
        unknown.push_back(std::string(prefix) + " (" + std::string(language) + ')');
    }
    return unknown;
}

void ThreeMfPart::check_extensions() {
    recommended_ = unknown_extensions("recommendedextensions");
    const std::vector<std::string> required = unknown_extensions("requiredextensions");
    if (required.empty()) return;
    throw Refusal("",
                  "it requires the extension " + required.front() + ", which is not read",
                  "3MF of the core specification, with production, material or triangle sets");
}

Element ThreeMfPart::object(const std::string& id, const std::string& user) const {
    const auto found = objects_.find(id);
    if (found != objects_.end()) return found->second;
    throw core::Error("",
                      user + " names the object " + in_quotes(id) + ", which " + in_quotes(name_) +
                          " does not hold",
                      "the id of an object");
}

Element ThreeMfPart::base_materials(const std::string& id) const {
    const auto found = base_materials_.find(id);
    return found == base_materials_.end() ? Element() : found->second;
}

std::string ThreeMfPart::named(const Element& object) const {
    return std::string(local_name(object)) + ' ' + object.attribute("id").value() + " of " +
           in_quotes(name_);
}

std::uint32_t ThreeMfMaterials::number(const ThreeMfPart& part,
                                       std::string_view group,
                                       std::string_view index) {
    const Element materials = part.base_materials(std::string(group));
    std::string key = part.name() + '\n';
    key.append(group) += '\n';
    if (materials) key += index;
    const auto [known, is_new] =
        numbers_.try_emplace(key, static_cast<std::uint32_t>(colors_.size()));
    if (!is_new) return known->second;
    const auto wanted = core::parse_number<std::size_t>(index).value_or(0);
    std::size_t at = 0;
    glm::vec4 color(1);
    for (const Element& base : materials.children())
        if (at++ == wanted) color = color_of(base.attribute("displaycolor").value());
    colors_.push_back(color);
    return known->second;
}

ImportedMesh read_3mf_mesh(const ThreeMfPart& part,
                           const Element& object,
                           ThreeMfMaterials& materials) {
    const std::string where = part.named(object);
    const Element from = part.child(object, "mesh");
    ImportedMesh mesh;
    for (const Element& vertex : part.child(from, "vertices").children()) {
        if (!part.is(vertex, "vertex")) continue;
        const double x = number_in(vertex, "x", where), y = number_in(vertex, "y", where);
        mesh.positions.emplace_back(x, y, number_in(vertex, "z", where));
    }
    const std::string_view group = object.attribute("pid").value();
    const std::string_view index = object.attribute("pindex").value();
    std::map<std::uint32_t, std::vector<scene::Triangle>> by_material;
    std::optional<std::pair<std::string_view, std::string_view>> last;  // mostly the same
    std::uint32_t material = 0;
    for (const Element& triangle : part.child(from, "triangles").children()) {
        if (!part.is(triangle, "triangle")) continue;
        const auto corner = [&](const char* key) {
            return index_in(triangle, key, mesh.positions.size(), where);
        };
        const auto own_group = triangle.attribute("pid"), own_index = triangle.attribute("p1");
        const std::pair<std::string_view, std::string_view> now{
            own_group ? own_group.value() : group, own_index ? own_index.value() : index};
        if (now != last) material = materials.number(part, now.first, now.second);
        last = now;
        by_material[material].push_back({corner("v1"), corner("v2"), corner("v3")});
    }
    for (const auto& [number, triangles] : by_material) {
        mesh.parts.push_back({.first_triangle = static_cast<std::uint32_t>(mesh.triangles.size()),
                              .material = number});
        mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    }
    return mesh;
}

}  // namespace ink::import
