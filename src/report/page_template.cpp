#include "report/page_template.h"

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

}  // namespace ink::report
