#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// Two runs beside each other, as a user compares them.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Words compare_into(const std::string& folder, const Words& more) {
    return fmt::format(
               "compare --scenes cube,rocket --methods mote4,ids --size 96x54 --repetitions 1 "
               "--out {}",
               folder) +
           more;
}

TEST(Diff, FindsAPlantedThresholdAndNothingInARunAndItself) {
    const Desk desk;
    expect_done(desk, compare_into("before", {}));
    expect_done(desk, compare_into("after", "--set mote4.threshold=200"));

    EXPECT_THAT(expect_done(desk, "diff before before --fail-if-worse"),
                AllOf(HasSubstr("Nothing differs"), Not(HasSubstr("mote4 "))));

    EXPECT_THAT(expect_done(desk, "diff before after"),
                AllOf(HasSubstr("methods.mote4.threshold"), HasSubstr("-> 200")));
    const auto json = nlohmann::json::parse(desk.run("diff before after --json").out);
    EXPECT_FALSE(json["same"].get<bool>());
    for (const auto& method : json["methods"]) {
        const bool is_changed =
            method["changed_images"].get<int>() > 0 || method["changed_scores"].get<int>() > 0;
        EXPECT_EQ(is_changed && method["difference"] != 0.0, method["method"] == "mote4")
            << method.dump();
    }
    EXPECT_EQ(desk.run("diff before after --fail-if-worse").exit_code, 1);
}

TEST(Diff, RefusesFoldersWithoutARun) {
    expect_refused(Desk(), "diff nowhere nowhere", {"nowhere", "there is no run in it"});
}

}  // namespace
}  // namespace ink::program
