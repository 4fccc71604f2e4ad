#include "import/xml.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/error.h"
#include "core/parse_number.h"
#include "import/meshes/line_words.h"

namespace ink::import {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

}  // namespace

void load_xml(std::string_view text, const std::string& part, pugi::xml_document& document) {
    // As new does, so that its handler answers where memory ends.
    pugi::set_memory_management_functions([](std::size_t bytes) { return ::operator new(bytes); },
                                          [](void* memory) { ::operator delete(memory); });
    const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
    if (result.status == pugi::status_ok) return;
    const auto to =
        std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)), text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + to, '\n');
    throw core::Error("",
                      (part.empty() ? "" : "its file \"" + part + "\", ") + "line " +
                          std::to_string(line) + ": no well-formed XML",
                      "a whole XML text in UTF-8 or UTF-16");
}

std::string_view local_name(const pugi::xml_node& element) {
    const std::string_view name = element.name();
    return name.substr(name.find(':') + 1);  // npos + 1 is 0
}

pugi::xml_node next_below(const pugi::xml_node& top, pugi::xml_node at) {
    if (at.first_child()) return at.first_child();
    while (at && at != top && !at.next_sibling())
        at = at.parent();
    return at == top ? pugi::xml_node() : at.next_sibling();
}

std::vector<pugi::xml_node> elements(const pugi::xml_node& top, std::string_view name) {
    std::vector<pugi::xml_node> found;
    for (pugi::xml_node at = top.first_child(); at; at = next_below(top, at))
        if (at.name() == name) found.push_back(at);
    return found;
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t at = text.find_first_not_of(kBlanks); at != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
        words.push_back(text.substr(at, end - at));
        at = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

std::vector<double> numbers_of(std::string_view text, const std::string& where) {
    std::vector<double> numbers;
    for (const std::string_view word : words_of(text)) {
        std::string digits(word.substr(word.starts_with('+') ? 1 : 0));
        std::replace(digits.begin(), digits.end(), ',', '.');  // as some exporters write
        const auto number = core::parse_number<double>(digits);
        if (!number || !std::isfinite(*number))
            throw core::Error("", where + ": " + in_quotes(word) + " is no number", "numbers");
        numbers.push_back(*number);
    }
    return numbers;
}

}  // namespace ink::import
