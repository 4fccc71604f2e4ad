#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include "core/escape.h"
#include "core/whole_file.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

std::string page_of(const std::string& method) {
    const std::string path = INK_SOURCE_DIR "/methods/" + method + "/" + method + ".md";
    return core::read_whole_file(path).value_or("");
}

std::string parameter_row(const core::Param& param) {
    return fmt::format("| `{}` | `{}` | {}{}{} | {} |\n",
                       param.name,
                       core::format_param(param, param.default_value),
                       core::markdown_cell(core::accepted_values(param)),
                       param.unit.empty() ? "" : " ",
                       param.unit,
                       core::markdown_cell(param.doc));
}

/// The parameters of a method as its page has them, a row each. Those that are in every way as in
/// method `other`, if there is one, are named below the table.
std::string parameter_table(const method::MethodInfo& method, const std::string& other = "") {
    std::set<std::string> others;
    if (!other.empty())
        for (const core::Param& param : find_method(other).params)
            others.insert(parameter_row(param));
    std::string table = "| parameter | default | values | meaning |\n|---|---|---|---|\n";
    std::vector<std::string> same;
    for (const core::Param& param : method.params) {
        const std::string row = parameter_row(param);
        if (others.contains(row))
            same.push_back(fmt::format("`{}`", param.name));
        else
            table += row;
    }
    if (same.empty()) return table;
    return fmt::format(
        "{0}\nAs in [{1}](../{1}/{1}.md): {2}.\n", table, other, fmt::join(same, ", "));
}

/// The method after "As in" in a text, or nothing.
std::string other_method(const std::string& text) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(R"(\nAs in \[(\w+)\])")) ? found[1].str() : "";
}

TEST(Page, EveryMethodHasItsPartsInOrder) {
    for (const method::MethodInfo& info : registry()) {
        const std::string page = page_of(info.name);
        std::size_t at = 0;
        for (const char* part :
             {"Idea", "Formula", "Our reading", "Parameters", "Where it fails", "Picture"}) {
            at = page.find(fmt::format("\n## {}\n", part), at);
            ASSERT_NE(at, std::string::npos) << info.name << ": " << part;
        }
        EXPECT_TRUE(page.starts_with("# " + info.name + "\n"));
    }
}

TEST(Page, ParametersAreThoseOfTheTable) {
    const std::string begin = "<!-- parameters -->\n";
    for (const method::MethodInfo& info : registry()) {
        const std::string page = page_of(info.name);
        const std::size_t first = page.find(begin);
        const std::size_t last = page.find("<!-- /parameters -->");
        ASSERT_NE(first, std::string::npos) << info.name;
        ASSERT_NE(last, std::string::npos) << info.name;
        const std::size_t start = first + begin.size();
        const std::string text = page.substr(start, last - start);
        EXPECT_EQ(text, parameter_table(info, other_method(text)))
            << "put this between the markers of methods/" << info.name << "/" << info.name << ".md";
    }
}

}  // namespace
}  // namespace ink::methods
