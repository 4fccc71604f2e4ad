#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/program/run_program.h"

namespace ink::program {
namespace {

using testing::HasSubstr;

TEST(ListColumns, AsMarkdownIsTheCommittedDataDictionary) {
    const Desk desk;
    std::ostringstream committed;
    committed << std::ifstream(INK_SOURCE_DIR "/experiments/columns.md").rdbuf();
    EXPECT_EQ(committed.str(), expect_done(desk, "list columns --markdown"))
        << "make it anew: inkbench list columns --markdown >experiments/columns.md";
}

TEST(ListColumns, OnATerminalHasALineForEveryColumnOfThePage) {
    const Desk desk;
    const auto lines_with = [](const std::string& text, const std::string& begin) {
        std::istringstream stream(text);
        int count = 0;
        for (std::string line; std::getline(stream, line);)
            count += line.starts_with(begin) ? 1 : 0;
        return count;
    };
    const std::string page = desk.run("list columns --markdown").out;
    const std::string text = desk.run({"list", "columns"}).out;
    EXPECT_GT(lines_with(page, "| `"), 200);
    EXPECT_EQ(lines_with(text, "    "), lines_with(page, "| `"));
}

TEST(ListColumns, RefusesMarkdownOfAnythingElse) {
    EXPECT_THAT(refusal(Desk(), "list scenes --markdown"), HasSubstr("list columns --markdown"));
}

}  // namespace
}  // namespace ink::program
