#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/program/run_program.h"

// Two runs beside each other, as a user compares them.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

Words compare_into(const std::string& folder, const Words& more) {
    Words words{"compare",
                "--scenes",
                "cube,rocket",
                "--methods",
                "mote4,ids",
                "--size",
                "96x54",
                "--repetitions",
                "1",
                "--out",
                folder};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

TEST(Diff, FindsAPlantedThresholdAndNothingInARunAndItself) {
    const Desk desk;
    ASSERT_EQ(desk.run(compare_into("before", {})).exit_code, 0);
    ASSERT_EQ(desk.run(compare_into("after", {"--set", "mote4.threshold=200"})).exit_code, 0);

    const Outcome itself = desk.run({"diff", "before", "before", "--fail-if-worse"});
    EXPECT_EQ(itself.exit_code, 0) << itself.err;
    EXPECT_THAT(itself.out, AllOf(HasSubstr("Nothing differs"), Not(HasSubstr("mote4 "))));

    const Outcome planted = desk.run({"diff", "before", "after"});
    EXPECT_EQ(planted.exit_code, 0) << planted.err;
    EXPECT_THAT(planted.out, AllOf(HasSubstr("methods.mote4.threshold"), HasSubstr("-> 200")));
    const auto json = nlohmann::json::parse(desk.run({"diff", "before", "after", "--json"}).out);
    EXPECT_FALSE(json["same"].get<bool>());
    for (const auto& method : json["methods"]) {
        const bool is_changed =
            method["changed_images"].get<int>() > 0 || method["changed_scores"].get<int>() > 0;
        EXPECT_EQ(is_changed && method["difference"] != 0.0, method["method"] == "mote4")
            << method.dump();
    }
    EXPECT_EQ(desk.run({"diff", "before", "after", "--fail-if-worse"}).exit_code, 1);
}

TEST(Diff, RefusesFoldersWithoutARun) {
    const Desk desk;
    const Outcome outcome = desk.run({"diff", "nowhere", "nowhere"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("nowhere"), HasSubstr("there is no run in it")));
}

}  // namespace
}  // namespace ink::program
