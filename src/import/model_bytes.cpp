#include "import/model_bytes.h"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace ink::import {

std::vector<std::byte> bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    std::vector<std::byte> bytes(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)));
    file.seekg(0);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return bytes;
}

std::string head_of(const std::filesystem::path& path) {
    constexpr std::size_t kHeadBytes = 4096;
    std::string head(kHeadBytes, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return head;
}

std::string_view without_mark(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return text;
}

bool is_utf16(std::string_view head) {
    if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff")) return true;
    head = head.substr(0, 64);
    if (head.size() < 8) return false;
    const auto is_half = [&](std::size_t zero) {  // of the pair, which byte is zero
        for (std::size_t i = 0; i + 1 < head.size(); i += 2) {
            const char letter = head[i + 1 - zero];
            const bool is_ascii =
                (letter >= ' ' && letter <= '~') || (letter >= '\t' && letter <= '\r');
            if (head[i + zero] != '\0' || !is_ascii) return false;
        }
        return true;
    };
    return is_half(0) || is_half(1);
}

std::string lower_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

}  // namespace ink::import
