#include "cli/name_list.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

#include "core/error.h"
#include "core/param.h"
#include "core/split_list.h"

namespace ink::cli {
namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<std::string> list_parts(const std::vector<std::string>& texts) {
    std::vector<std::string> parts;
    for (const std::string& text : texts) {
        for (std::string& part : core::split_list(text))
            parts.push_back(std::move(part));
    }
    return parts;
}

bool is_glob(std::string_view text) {
    return text.find_first_of("*?[") != std::string_view::npos;
}

std::vector<std::string> fitting(const std::string& glob, const std::vector<std::string>& names) {
    std::vector<std::string> found;
    std::copy_if(names.begin(), names.end(), std::back_inserter(found), [&](const auto& name) {
        return fnmatch(glob.c_str(), name.c_str(), 0) == 0;
    });
    return found;
}

void refuse_name(const Names& names, const std::string& wrong) {
    std::string letters = wrong;  // of a glob too, to find the name that was meant
    std::erase_if(letters, [](char c) { return is_glob({&c, 1}); });
    throw core::Error(names.option,
                      is_glob(wrong) ? fmt::format("no {} fits '{}'", names.noun, wrong)
                                     : fmt::format("there is no {} '{}'", names.noun, wrong),
                      core::known_names(names.known, letters));
}

void NameList::add(const std::string& name) {
    if (!has(implied_, name)) names_.push_back(name);
}

void NameList::add_implied(const std::string& name) {
    if (has(names_, name)) return;
    names_.push_back(name);
    implied_.push_back(name);
}

std::vector<std::string> listed_names(const std::vector<std::string>& texts, const Names& names) {
    NameList list;
    Names accepted = names;
    accepted.known.emplace_back("all");
    for (const std::string& part : list_parts(texts)) {
        const bool is_all = part == "all";
        if (!is_all && !is_glob(part)) {
            if (!has(names.known, part)) refuse_name(accepted, part);
            list.add(part);
            continue;
        }
        const auto found = is_all ? names.known : fitting(part, names.known);
        if (found.empty()) refuse_name(accepted, part);
        for (const std::string& name : found)
            list.add_implied(name);
    }
    if (list.names().empty() && !texts.empty()) {
        throw core::Error(names.option,
                          fmt::format("'{}' names no {}", texts.front(), names.noun),
                          core::known_names(accepted.known, ""));
    }
    return list.names();
}

}  // namespace ink::cli
