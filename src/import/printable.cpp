#include "import/printable.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace ink::import {
namespace {

/// How many bytes the UTF-8 character at the start of `text` takes; 0 if there is none (RFC 3629).
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    // Overlong forms, surrogates, and what lies beyond the last character.
    const bool is_bad = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xed && byte(1) > 0x9f) ||
                        (lead == 0xf0 && byte(1) < 0x90) || (lead == 0xf4 && byte(1) > 0x8f);
    return is_bad ? 0 : length;
}

}  // namespace

std::string printable(const std::string& text, std::size_t most) {
    std::string line;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const std::size_t length = utf8_length(std::string_view(text).substr(i));
        if (std::isspace(byte) != 0 || byte == 0) {
            if (!line.empty() && line.back() != ' ') line.push_back(' ');
        } else if (length == 0 || byte < 0x20 || byte == 0x7f) {
            line.push_back('?');
        } else {
            line.append(text, i, length);
        }
        i += std::max<std::size_t>(length, 1);
    }
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    if (line.size() <= most) return line;
    std::size_t end = most - 3;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xc0) == 0x80)
        --end;  // no character is cut in two
    return line.substr(0, end) + "...";
}

}  // namespace ink::import
