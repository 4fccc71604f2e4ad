#pragma once

#include <span>
#include <string_view>

namespace ink::core {

/// A word that tables, pictures, page and figures share.
struct Term {
    std::string_view name;     ///< the one spelling of columns, keys and files
    std::string_view text;     ///< what it means, for people; may be empty
    std::string_view picture;  ///< "#rrggbb" in the pictures that C++ draws; may be empty
};

/// What stands in vocabulary.json, the one place for the words and colours of results: families of
/// methods with their markers, classes of lines, parts of a class of which recall is told apart,
/// and causes of wrong pixels. The page reads it as `VOCABULARY`, the figures in paper/runs.py.
///
/// A colour is there once for each paper it stands on. `picture`: Okabe and Ito, "Color Universal
/// Design", 2008, in images that C++ draws. `figure`: in figures for papers and in the page's
/// images, on white. `light` and `dark`: lines and text of the page's two themes. `over`: lines
/// over a shaded model.
struct Vocabulary {
    std::span<const Term> families;       ///< in the order of method::Family
    std::span<const Term> markers;        ///< in the order of method::Marker
    std::span<const Term> classes;        ///< in the order of truth::kLineClasses
    std::span<const Term> recall_groups;  ///< the classes, then the parts of one
    std::span<const Term> causes;         ///< in the order of score::Cause
    std::string_view json;                ///< the file
};

/// As it was when the program was built; lives as long as the program.
[[nodiscard]] const Vocabulary& vocabulary();

}  // namespace ink::core
