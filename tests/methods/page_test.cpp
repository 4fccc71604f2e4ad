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
        for (const std::string& heading : {"# " + info.name,
                                           std::string("## Idea"),
                                           std::string("## Formula"),
                                           std::string("## Our reading"),
                                           std::string("## Parameters"),
                                           std::string("## Where it fails"),
                                           std::string("## Picture")}) {
            const std::size_t found = page.find(heading + "\n", at);
            ASSERT_NE(found, std::string::npos) << info.name << ": " << heading;
            at = found;
        }
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

TEST(ParameterTable, HasARowPerParameterAndEscapesBars) {
    const std::string table = parameter_table(find_method("mote4"));
    EXPECT_NE(table.find("| `range_nx` | `63` | a number 0..255 code |"), std::string::npos);
    EXPECT_NE(table.find("absolute \\| positive \\| wrap"), std::string::npos);
    EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')),
              find_method("mote4").params.size() + 2);
}

TEST(ParameterTable, NamesBelowItWhatIsAsInAnotherMethod) {
    const std::string table = parameter_table(find_method("mote4"), "mote2");
    EXPECT_NE(table.find("\n| `range_nx` |"), std::string::npos);
    EXPECT_NE(table.find("\n\nAs in [mote2](../mote2/mote2.md): `depth_encoding`, "),
              std::string::npos);
    EXPECT_EQ(table.find("| `response` |"), std::string::npos);
    EXPECT_EQ(other_method(table), "mote2");
}

}  // namespace
}  // namespace ink::methods
