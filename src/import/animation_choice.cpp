#include "import/animation_choice.h"

#include <algorithm>
#include <charconv>
#include <system_error>

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
    std::size_t number = 0;
    const char* last = asked.data() + asked.size();
    const auto [end, error] = std::from_chars(asked.data(), last, number);
    if (error == std::errc{} && end == last && number < names.size()) return number;
    throw Refusal("", "it has no animation \"" + asked + '"', listed(names));
}

}  // namespace ink::import
