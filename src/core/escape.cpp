#include "core/escape.h"

namespace ink::core {

std::string escape(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                const auto code = static_cast<unsigned char>(c);
                const bool is_control = (code < 0x20 && c != '\t' && c != '\n') || code == 0x7f;
                if (!is_control) safe += c;
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

}  // namespace ink::core
