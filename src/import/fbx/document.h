#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "import/fbx/tree.h"

namespace ink::import {

/// The properties of an object (Properties70), behind them those that its kind has by default.
struct FbxProperties {
    const FbxElement* own = nullptr;
    const FbxElement* standard = nullptr;

    /// The property's element, whose values begin at 4; nothing of none.
    [[nodiscard]] const FbxElement* find(std::string_view name) const;
    [[nodiscard]] double real(std::string_view name, double otherwise) const;
    [[nodiscard]] int whole(std::string_view name, int otherwise) const;
    [[nodiscard]] glm::dvec3 vector(std::string_view name, const glm::dvec3& otherwise) const;
};

struct FbxObject {
    std::int64_t number = 0;
    std::string name;  ///< as the user gave it
    std::string kind;  ///< "Mesh", "Skin": of those that share an element's name
    const FbxElement* element = nullptr;
    FbxProperties properties;
    std::vector<const FbxObject*> children;  ///< what is connected to it, in the file's order
};

/// The objects of a file and what is connected to what.
class FbxDocument {
  public:
    /// Throws core::Error for a damaged file, Refusal for one of a version that is not read.
    explicit FbxDocument(std::string_view file);

    [[nodiscard]] const FbxProperties& settings() const { return settings_; }
    /// What the whole scene is: an object of number 0 without an element.
    [[nodiscard]] const FbxObject& scene() const { return objects_.at(0); }
    /// All objects whose element is called so, by number.
    [[nodiscard]] std::vector<const FbxObject*> all(std::string_view element) const;

  private:
    void read_objects();
    void read_connections();
    [[nodiscard]] const FbxElement* standard_of(const FbxElement& object) const;

    FbxElement root_;
    FbxProperties settings_;
    std::map<std::int64_t, FbxObject> objects_;
};

/// The children of an object whose element and kind are these, the kind only if one is given.
[[nodiscard]] std::vector<const FbxObject*> children_of(const FbxObject& object,
                                                        std::string_view element,
                                                        std::string_view kind = {});

}  // namespace ink::import
