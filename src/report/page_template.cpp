#include "report/page_template.h"

#include <zlib.h>
#include <nlohmann/json.hpp>

namespace ink::report {

std::string filled(std::string_view page, const std::map<std::string, std::string>& values) {
    std::string text;
    while (true) {
        const std::size_t open = page.find("{{");
        const std::size_t close = page.find("}}", open);
        text += page.substr(0, open);
        if (open == std::string_view::npos || close == std::string_view::npos) return text;
        text += values.at(std::string(page.substr(open + 2, close - open - 2)));
        page.remove_prefix(close + 2);
    }
}

std::string page_json(const nlohmann::ordered_json& json) {
    const auto replace = nlohmann::ordered_json::error_handler_t::replace;
    std::string safe;
    for (const char c : json.dump(-1, ' ', false, replace)) {
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    }
    return safe;
}

std::vector<std::uint8_t> deflated(std::span<const std::byte> bytes) {
    uLongf size = compressBound(bytes.size());
    std::vector<std::uint8_t> packed(size);
    compress(packed.data(),
             &size,
             reinterpret_cast<const Bytef*>(bytes.data()),  // NOLINT
             bytes.size());
    packed.resize(size);
    return packed;
}

}  // namespace ink::report
