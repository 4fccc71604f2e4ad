#include "core/tables/csv.h"

#include <fmt/format.h>

namespace ink::core {

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

std::string number_text(double value) {
    return fmt::format("{}", value);
}

std::string number_text(std::int64_t value) {
    return fmt::format("{}", value);
}

std::string number_text(std::uint64_t value) {
    return fmt::format("{}", value);
}

}  // namespace ink::core
