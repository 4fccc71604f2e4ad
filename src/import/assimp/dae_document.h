#pragma once

#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ink::import {

/// A COLLADA document and what its ids stand for.
class DaeDocument {
  public:
    explicit DaeDocument(pugi::xml_node root) : root_(root) { number_ids(); }

    [[nodiscard]] const pugi::xml_node& root() const { return root_; }

    /// The element of one of the `kinds` of names whose id is the `attribute` of `from`, "#id".
    /// Refuses what is in another file; throws Error where there is none.
    [[nodiscard]] pugi::xml_node target(const pugi::xml_node& from,
                                        const char* attribute,
                                        const std::vector<std::string_view>& kinds) const;
    /// The element of that name and id; none if there is none.
    [[nodiscard]] pugi::xml_node find(std::string_view kind, std::string_view id) const;
    /// An id like `wanted` that nothing has.
    [[nodiscard]] std::string new_id(std::string wanted) const;
    /// To be called when elements were added.
    void number_ids();

  private:
    pugi::xml_node root_;
    /// By id, as elements of several kinds may share one.
    std::multimap<std::string, pugi::xml_node, std::less<>> by_id_;
};

/// An element for messages: <skin source="#body">.
[[nodiscard]] std::string named(const pugi::xml_node& element);

/// Adds `count` numbers, `stride` a row of three, as the only content of a <source>.
void write_vectors(const std::vector<double>& numbers, pugi::xml_node source);
/// The vectors of a <source> as its accessor says.
[[nodiscard]] std::vector<double> read_vectors(const DaeDocument& dae,
                                               const pugi::xml_node& source);

/// Puts a geometry of the weights' shape in place of each morph controller, alone and under skins.
void bake_morphs(DaeDocument& dae);

/// Throws unless Assimp finds the joints that each use of a skin means: sids of nodes below its
/// skeletons. Assimp takes the first node of that name or sid in the scene, or lets the skin stiff.
void check_skins(const DaeDocument& dae);

}  // namespace ink::import
