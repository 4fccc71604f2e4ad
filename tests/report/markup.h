#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ink::report {

/// What is wrong with the nesting of `markup` (HTML as we write it, or SVG); "" if nothing is:
/// every element is closed in its turn, every attribute is quoted, no bare < stands in a text.
inline std::string nesting_error(std::string_view markup) {
    static const std::set<std::string, std::less<>> kVoid = {"meta", "img", "input", "br"};
    std::vector<std::string> open;
    std::size_t at = 0;
    while ((at = markup.find('<', at)) != std::string_view::npos) {
        std::size_t end = at + 1;
        bool is_quoted = false;
        while (end < markup.size() && (is_quoted || markup[end] != '>')) {
            if (markup[end] == '"') is_quoted = !is_quoted;
            if (markup[end] == '<' && !is_quoted) return "a bare < in a tag";
            ++end;
        }
        if (end >= markup.size()) return "a tag without end";
        const std::string_view tag = markup.substr(at + 1, end - at - 1);
        at = end + 1;
        if (tag.empty() || tag[0] == '!') continue;
        if (tag[0] == '/') {
            const std::string name(tag.substr(1));
            if (open.empty()) return "</" + name + "> closes nothing";
            if (open.back() != name) return "</" + name + "> closes <" + open.back() + ">";
            open.pop_back();
            continue;
        }
        const std::string name(tag.substr(0, tag.find_first_of(" \n/")));
        if (tag.back() == '/' || kVoid.count(name) != 0) continue;
        if (name == "script" || name == "style") {
            at = markup.find("</" + name + ">", at);
            if (at == std::string_view::npos) return "<" + name + "> without end";
            at += name.size() + 3;
            continue;
        }
        open.push_back(name);
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

}  // namespace ink::report
