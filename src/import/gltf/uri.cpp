#include "import/gltf/uri.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace ink::import {
namespace {

constexpr std::string_view kBase64 =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::size_t kMostShownChars = 60;

std::string shown(const std::string& uri) {
    return "the URI " + uri.substr(0, kMostShownChars) +
           (uri.size() > kMostShownChars ? "..." : "");
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const int letter = std::tolower(static_cast<unsigned char>(c));
    return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
}

std::string decoded(const std::string& uri, const JsonObject& owner) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            path += uri[i];
            continue;
        }
        const int high = i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
        const int low = high >= 0 ? hex_digit(uri[i + 2]) : -1;
        if (low < 0 || high * 16 + low == 0)
            owner.fail(shown(uri) + " has an escape that is none", "% and two digits, not %00");
        path += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return path;
}

/// What stands before the first colon if that makes it an absolute URI, as in "http:".
std::string scheme_of(const std::string& uri) {
    const std::size_t colon = uri.find(':');
    if (colon == std::string::npos || uri.find('/') < colon) return "";
    return uri.substr(0, colon);
}

}  // namespace

bool is_data_uri(const std::string& uri) {
    return uri.starts_with("data:");
}

std::vector<std::byte> bytes_of_data_uri(const std::string& uri, const JsonObject& owner) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
        owner.refuse(shown(uri) + " is not read", "data in base64");
    std::string_view text = std::string_view(uri).substr(comma + 1);
    for (int i = 0; i < 2 && text.ends_with('='); ++i)
        text.remove_suffix(1);
    std::vector<std::byte> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t digit = kBase64.find(c);
        if (digit == std::string_view::npos)
            owner.fail("its data has a character that base64 has not", "A-Z a-z 0-9 + /");
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::byte>(bits >> count & 0xff));
    }
    return bytes;
}

std::filesystem::path path_of_uri(const std::string& uri,
                                  const std::filesystem::path& folder,
                                  const JsonObject& owner) {
    constexpr const char* kAccepted = "a path below the model's folder";
    if (!scheme_of(uri).empty()) owner.refuse(shown(uri) + " is not opened", kAccepted);
    const std::filesystem::path path = decoded(uri, owner);
    const bool is_below = path.is_relative() &&
                          std::none_of(path.begin(), path.end(), [](auto& p) { return p == ".."; });
    if (!is_below) owner.refuse(shown(uri) + " leaves the model's folder", kAccepted);
    return folder / path;
}

}  // namespace ink::import
