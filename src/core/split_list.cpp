#include "core/split_list.h"

#include <algorithm>

namespace ink::core {

std::vector<std::string> split_list(const std::string& text) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const auto end = std::min(text.find(',', begin), text.size());
        const auto first = text.find_first_not_of(" \t", begin);
        if (first < end) {
            const auto last = text.find_last_not_of(" \t", end - 1);
            parts.push_back(text.substr(first, last - first + 1));
        }
        begin = end + 1;
    }
    return parts;
}

}  // namespace ink::core
