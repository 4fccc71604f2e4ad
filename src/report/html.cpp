#include "report/html.h"

#include <string_view>

namespace ink::report {

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8U | (j < count ? bytes[i + j] : 0U);
        for (std::size_t digit = 0; digit < 4; ++digit) {
            const std::uint32_t value = group >> (18U - 6U * digit) & 63U;
            text += digit <= count ? kDigits[value] : '=';
        }
    }
    return text;
}

std::string png_uri(std::span<const std::uint8_t> png) {
    return "data:image/png;base64," + base64(png);
}

}  // namespace ink::report
