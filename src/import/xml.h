#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace ink::import {

/// Makes a document of an XML text in UTF-8 or UTF-16. Throws Error that names the line, and
/// `part`, the file in the file that it is ("": the file itself), for one that is not well-formed.
void load_xml(std::string_view text, const std::string& part, pugi::xml_document& document);

/// An element's name without a prefix: "item" of "p:item".
[[nodiscard]] std::string_view local_name(const pugi::xml_node& element);

/// What comes behind `at` in a walk over all that is below `top`; none at the end. No recursion: a
/// hostile tree is deep.
[[nodiscard]] pugi::xml_node next_below(const pugi::xml_node& top, pugi::xml_node at);

/// All elements below `top` of that name, in the file's order.
[[nodiscard]] std::vector<pugi::xml_node> elements(const pugi::xml_node& top,
                                                   std::string_view name);

/// The words of a text, parted by XML's blanks. Borrows it.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text);

/// The numbers of a text. Throws Error that begins with `where` and names a word that is none.
[[nodiscard]] std::vector<double> numbers_of(std::string_view text, const std::string& where);

}  // namespace ink::import
