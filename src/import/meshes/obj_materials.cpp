#include "import/meshes/obj_materials.h"

#include <charconv>
#include <optional>

#include "import/meshes/line_words.h"

namespace ink::import {
namespace {

std::optional<double> to_number(std::string_view word) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} ? std::optional(value) : std::nullopt;
}

}  // namespace

std::set<std::string> transparent_materials(std::string_view library) {
    std::set<std::string> names;
    std::string name;
    for (LineWords words(library, {.comment = '#'}); words.next_line();) {
        const std::string_view keyword = words.word();
        if (keyword == "newmtl") name = words.rest();
        if (keyword != "d" && keyword != "Tr") continue;
        const auto value = to_number(words.word());  // none: "d -halo 0.5" fades with the angle
        if (value && (keyword == "d" ? *value < 1 : *value > 0)) names.insert(name);
    }
    return names;
}

}  // namespace ink::import
