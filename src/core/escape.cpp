#include "core/escape.h"

#include <map>

namespace ink::core {

std::string escape(std::string_view text) {
    static const std::map<char, std::string_view> kEntities = {
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
    std::string safe;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        const bool is_control = (code < 0x20 && c != '\t' && c != '\n') || code == 0x7f;
        if (const auto entity = kEntities.find(c); entity != kEntities.end()) {
            safe += entity->second;
        } else if (!is_control) {
            safe += c;
        }
    }
    return safe;
}

std::string markdown_cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string shell_word(std::string_view word) {
    constexpr const char* kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos)
        return std::string(word);
    std::string text = "'";
    for (const char c : word)
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

}  // namespace ink::core
