#include "core/toml_document.h"

#include <fmt/format.h>

#include "core/error.h"

namespace ink::core {

toml::array array_of(const std::vector<std::string>& texts) {
    toml::array array;
    for (const std::string& text : texts)
        array.push_back(text);
    return array;
}

std::vector<std::string> texts_of(const toml::node_view<const toml::node>& node) {
    std::vector<std::string> texts;
    if (const toml::array* array = node.as_array()) {
        for (const toml::node& text : *array)
            texts.push_back(text.value_or(std::string()));
    }
    return texts;
}

toml::table parse_toml(std::string_view text, const std::filesystem::path& file) {
    try {
        return toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        throw Error(fmt::format("{}:{}", file.string(), error.source().begin.line),
                    fmt::format("this is no TOML: {}", error.description()),
                    "key = value, [table], # comment");
    }
}

}  // namespace ink::core
