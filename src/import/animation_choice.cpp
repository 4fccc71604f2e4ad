#include "import/animation_choice.h"

#include <algorithm>

#include "core/parse_number.h"
#include "import/refusal.h"

namespace ink::import {
namespace {

std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return "none, as the file has no animation";
    std::string list;
    for (const std::string& name : names)
        if (!name.empty()) list += name + ", ";
    return list + "or a number, 0.." + std::to_string(names.size() - 1);
}

}  // namespace

std::size_t choose_animation(const std::vector<std::string>& names, const std::string& asked) {
    if (asked.empty()) return 0;
    const auto named = std::find(names.begin(), names.end(), asked);
    if (named != names.end()) return static_cast<std::size_t>(named - names.begin());
    const auto number = core::parse_number<std::size_t>(asked);
    if (number && *number < names.size()) return *number;
    throw Refusal("", "it has no animation \"" + asked + '"', listed(names));
}

}  // namespace ink::import
