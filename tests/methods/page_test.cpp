#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/escape.h"
#include "core/whole_file.h"
#include "methods/registry.h"

namespace ink::methods {
namespace {

std::string page_of(const std::string& method) {
    const std::string path = INK_SOURCE_DIR "/methods/" + method + "/" + method + ".md";
    return core::read_whole_file(path).value_or("");
}

/// The parameters of a method as its page has them, a row each; of a preset those whose default
/// is its own.
std::string parameter_table(const method::MethodInfo& method) {
    std::string table = "| parameter | default | values | meaning |\n|---|---|---|---|\n";
    const method::MethodInfo* base =
        method.preset_of.empty() ? nullptr : &find_method(method.preset_of);
    for (std::size_t i = 0; i < method.params.size(); ++i) {
        const core::Param& param = method.params[i];
        if (base && param.default_value == base->params[i].default_value) continue;
        table += fmt::format("| `{}` | `{}` | {}{}{} | {} |\n",
                             param.name,
                             core::format_param(param, param.default_value),
                             core::markdown_cell(core::accepted_values(param)),
                             param.unit.empty() ? "" : " ",
                             param.unit,
                             core::markdown_cell(param.doc));
    }
    return table;
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
        EXPECT_EQ(page.substr(start, last - start), parameter_table(info))
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

}  // namespace
}  // namespace ink::methods
