#include "core/system_reason.h"

#include <cctype>
#include <cerrno>
#include <system_error>

namespace ink::core {

std::string system_reason(int error) {
    if (error == 0) return "unknown reason";
    std::string words = std::generic_category().message(error);
    if (!words.empty())
        words[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(words[0])));
    return error == ENOSPC ? "disk full (" + words + ")" : words;
}

Error refused_path(const std::filesystem::filesystem_error& error) {
    return {error.path1().string(), system_reason(error.code().value()), "a path that can be used"};
}

}  // namespace ink::core
