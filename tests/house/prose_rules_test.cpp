#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/house_rules.h"

// As in house_rules_test.cpp: every rule is broken on purpose.

namespace ink::house {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

SourceTree tree_with(const std::string& path, const std::string& text) {
    SourceTree tree;
    tree.files = {{path, text}};
    return tree;
}

std::string words(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "word ";
    return text;
}

TEST(Readme, MayHaveSixHundredWords) {
    EXPECT_THAT(check_readme(tree_with("README.md", words(600))), IsEmpty());
    EXPECT_THAT(check_readme(tree_with("README.md", words(601))),
                ElementsAre("README.md: 601 words, of 600 at most"));
    EXPECT_THAT(check_readme(tree_with("a.md", words(10))), ElementsAre(HasSubstr("missing")));
}

TEST(Readme, CountsWhatAReaderSees) {
    const std::string unseen = "<!-- a comment -->\n|---|--:|\n[word](a/link and more.md)\n";
    EXPECT_THAT(check_readme(tree_with("README.md", unseen + words(599))), IsEmpty());
    EXPECT_THAT(check_readme(tree_with("README.md", unseen + "```sh\nmake\n``` " + words(599))),
                SizeIs(1))
        << "a command is read too";
}

TEST(Prose, WordsOfTheListAreFoundWithTheirLine) {
    EXPECT_THAT(check_prose(tree_with("a.md", "Time\nhangs on the view.\n")),
                ElementsAre("a.md:2: 'hangs on': write depends on"));
    EXPECT_THAT(check_prose(tree_with("a.md", "A missing file\nis\nsaid so.\n")),
                ElementsAre(HasSubstr("a.md:2: ")))
        << "over a line's end";
    EXPECT_THAT(check_prose(tree_with("a.md", "Who draws? A Knob.")), SizeIs(2));
    EXPECT_THAT(check_prose(tree_with("a.cpp", "// a knob")), IsEmpty()) << "pages only";
}

TEST(Prose, WholeWordsOutsideCodeCount) {
    const std::string text =
        "The whole is noteworthy. `--witness`\n```sh\nknob\n```\n    knob = 1\n";
    EXPECT_THAT(check_prose(tree_with("a.md", text)), IsEmpty());
}

TEST(Prose, FractionsHaveTheirLeadingZero) {
    EXPECT_THAT(check_prose(tree_with("a.md", "0.918, 1.5, 1..255, a.1, `.5`")), IsEmpty());
    EXPECT_THAT(check_prose(tree_with("a.md", "F .918 [-.001, +.004]\n| .5 |")), SizeIs(4));
}

}  // namespace
}  // namespace ink::house
