#include <gmock/gmock.h>

#include "tests/program/run_program.h"

// Skips as a user switches them off.

namespace ink::program {
namespace {

using testing::HasSubstr;

/// The first row of mote4 after `inkbench compare` with these words more.
std::map<std::string, std::string> compared(const Desk& desk, const Words& more) {
    expect_done(desk,
                "compare --scenes torus --methods mote4 --size 160x90 --no-sweep --no-crosscheck "
                "--repetitions 2 --out out --force" +
                    more);
    return only(rows_of(desk), "mote4").at(0);
}

TEST(NoSkip, IsRecordedAndChangesNoImage) {
    const Desk desk;
    const auto all_on = compared(desk, {});
    EXPECT_EQ(all_on.at("skips_off"), "temporal_reuse");
    EXPECT_NE(all_on.at("skip_occlusion_culling"), "") << "a number";
    const auto some_off = compared(desk, {"--no-skip", "occlusion_culling,back_face_culling"});
    EXPECT_EQ(some_off.at("skips_off"), "back_face_culling;occlusion_culling;temporal_reuse");
    EXPECT_EQ(some_off.at("skip_occlusion_culling"), "0");
    EXPECT_EQ(some_off.at("image_hash"), all_on.at("image_hash"));
    EXPECT_EQ(some_off.at("params"), all_on.at("params"));
    EXPECT_THAT(compared(desk, {"--no-skip", "all"}).at("skips_off"),
                HasSubstr("attributes;frustum_culling;back_face_culling"));
}

TEST(NoSkip, RefusesWhatIsNoSkip) {
    for (const char* words : {"compare --scenes torus --no-skip oclusion_culling",
                              "draw torus -o a.png --no-skip oclusion_culling"})
        expect_refused(
            Desk(), words, {"--no-skip", "temporal_reuse", "did you mean occlusion_culling?"});
}

}  // namespace
}  // namespace ink::program
