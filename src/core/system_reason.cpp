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

}  // namespace ink::core
