#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "run_program.h"

namespace ink::program {
namespace {

TEST(ListColumns, AsMarkdownIsTheCommittedDataDictionary) {
    const Desk desk;
    const Outcome outcome = desk.run({"list", "columns", "--markdown"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::ostringstream committed;
    committed << std::ifstream(INK_SOURCE_DIR "/experiments/columns.md").rdbuf();
    EXPECT_EQ(committed.str(), outcome.out)
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
    const std::string page = desk.run({"list", "columns", "--markdown"}).out;
    const std::string text = desk.run({"list", "columns"}).out;
    EXPECT_GT(lines_with(page, "| `"), 200);
    EXPECT_EQ(lines_with(text, "    "), lines_with(page, "| `"));
}

TEST(ListColumns, RefusesMarkdownOfAnythingElse) {
    const Desk desk;
    const Outcome outcome = desk.run({"list", "scenes", "--markdown"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("list columns --markdown"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace ink::program
