#include "import/model_bytes.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

namespace ink::import {

std::optional<std::vector<std::byte>> read_file(const std::filesystem::path& path,
                                                std::uint64_t most) {
    std::error_code error;
    // A pipe would keep us waiting.
    if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
    const std::uint64_t size =
        std::min<std::uint64_t>(std::filesystem::file_size(path, error), most);
    if (error) return std::nullopt;
    std::vector<std::byte> bytes(size);
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!file) return std::nullopt;
    return bytes;
}

std::vector<std::byte> bytes_of(const std::filesystem::path& path) {
    return read_file(path).value_or(std::vector<std::byte>{});
}

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string head_of(const std::filesystem::path& path) {
    constexpr std::size_t kHeadBytes = 4096;
    return std::string(text_of(read_file(path, kHeadBytes).value_or(std::vector<std::byte>{})));
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
