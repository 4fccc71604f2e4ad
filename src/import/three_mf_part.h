#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "import/scene_stream.h"

namespace ink::import {

/// A model part of a 3MF package.
class ThreeMfPart {
  public:
    ThreeMfPart(const std::string& name, const std::string& text);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// How long one of its units is.
    [[nodiscard]] double unit_m() const { return unit_m_; }
    /// The <item>s of its <build> are its children.
    [[nodiscard]] pugi::xml_node build() const { return child(model_, "build"); }
    /// Throws Error, called as `user` names it, if there is no object of that id.
    [[nodiscard]] pugi::xml_node object(const std::string& id, const std::string& user) const;
    /// An element of the core specification below another; none if there is none.
    [[nodiscard]] pugi::xml_node child(const pugi::xml_node& of, std::string_view name) const;
    /// Whether an element is one of the core specification's, of that name.
    [[nodiscard]] bool is(const pugi::xml_node& element, std::string_view name) const;
    /// Extensions that should be known and are not.
    [[nodiscard]] const std::vector<std::string>& recommended() const { return recommended_; }
    /// The materials in it that have colours, by id.
    [[nodiscard]] pugi::xml_node base_materials(const std::string& id) const;

    /// For messages: object 3 of "3D/a.model".
    [[nodiscard]] std::string named(const pugi::xml_node& object) const;

  private:
    void check_extensions();
    [[nodiscard]] std::vector<std::string> unknown_extensions(const char* attribute) const;

    std::string name_;
    pugi::xml_document document_;
    pugi::xml_node model_;
    std::string core_;  ///< the core specification's prefix: "" or "m:"
    double unit_m_ = 1e-3;
    std::map<std::string, pugi::xml_node> objects_;
    std::map<std::string, pugi::xml_node> base_materials_;
    std::vector<std::string> recommended_;
};

/// Numbers the materials of a package.
class ThreeMfMaterials {
  public:
    /// That of a triangle, or of others of its object that name none.
    [[nodiscard]] std::uint32_t number(const ThreeMfPart& part,
                                       std::string_view group,
                                       std::string_view index);
    /// By number.
    [[nodiscard]] const std::vector<glm::vec4>& colors() const { return colors_; }

  private:
    std::map<std::string, std::uint32_t> numbers_;
    std::vector<glm::vec4> colors_;
};

/// The mesh of an object that has one, its triangles by material.
[[nodiscard]] ImportedMesh read_3mf_mesh(const ThreeMfPart& part,
                                         const pugi::xml_node& object,
                                         ThreeMfMaterials& materials);

/// A transform as 3MF writes it, 12 numbers, a row of the matrix by which rows are multiplied after
/// the other; the identity where there is none.
[[nodiscard]] glm::dmat4 transform_of(const pugi::xml_node& element, const std::string& where);

/// An attribute of an element in whatever namespace: "path" is p:path.
[[nodiscard]] std::string attribute_of(const pugi::xml_node& element, std::string_view name);

}  // namespace ink::import
