#include "harness/cells/sweep.h"

#include <gmock/gmock.h>

namespace ink::harness {
namespace {

/// A method that is not drawn here.
method::MethodInfo stroke_info() {
    method::MethodInfo info;
    info.name = "stroke";
    info.complete = [](const core::ParamValues& values) {
        core::ParamValues all = {{"edge_response", "200"}, {"threshold", "100"}, {"tip", "round"}};
        for (const auto& [name, value] : values)
            all[name] = value;
        return all;
    };
    info.sweep = {{}, {{"edge_response", "50"}}, {{"edge_response", "13"}}, {{"tip", "flat"}}};
    return info;
}

TEST(SweepConfigs, PutTheSweepOnTopOfWhatTheUserSet) {
    const auto info = stroke_info();
    const auto configs = sweep_configs({&info, {{"tip", "flat"}, {"edge_response", "77"}}});
    std::vector<core::ParamValues> settings;
    for (const method::MethodConfig& config : configs)
        settings.push_back(config.settings);
    // The last line, {tip: flat}, is what the user has already.
    EXPECT_THAT(settings,
                testing::ElementsAre(core::ParamValues{{"edge_response", "77"}, {"tip", "flat"}},
                                     core::ParamValues{{"edge_response", "50"}, {"tip", "flat"}},
                                     core::ParamValues{{"edge_response", "13"}, {"tip", "flat"}}));
}

TEST(SweepConfigs, OfAMethodWithoutASweepIsTheMethodAsItTakesPart) {
    auto info = stroke_info();
    info.sweep.clear();
    const auto configs = sweep_configs({&info, {{"tip", "flat"}}});
    ASSERT_EQ(configs.size(), 1U);
    EXPECT_EQ(configs[0].settings, (core::ParamValues{{"tip", "flat"}}));
}

TEST(SharedDrawings, DrawOnceWhatDiffersByTheThresholdAlone) {
    const auto info = stroke_info();
    const std::vector<method::MethodConfig> settings = {{&info, {}},
                                                        {&info, {{"edge_response", "50"}}},
                                                        {&info, {{"threshold", "201"}}},
                                                        {&info, {{"edge_response", "13"}}}};
    const SharedDrawings drawings(settings);
    ASSERT_EQ(drawings.drawn().size(), 3U);
    std::vector<Evaluation> drawn(3);
    for (std::size_t i = 0; i < drawn.size(); ++i)
        drawn[i].row.draw_ns = static_cast<std::int64_t>(i);
    const std::vector<Evaluation> all = drawings.shared(drawn);
    ASSERT_EQ(all.size(), 4U);
    EXPECT_EQ(all[2].row.draw_ns, 0);
    EXPECT_EQ(all[2].threshold, 201);
    EXPECT_EQ(all[2].row.threshold, 201);
    EXPECT_EQ(all[2].row.params, "edge_response=200;threshold=201;tip=round");
    EXPECT_EQ(all[0].row.params, "edge_response=200;threshold=100;tip=round");
    EXPECT_EQ(all[3].row.draw_ns, 2);
}

TEST(SharedDrawings, AreNotSharedWhereTheThresholdIsDrawn) {
    auto info = stroke_info();
    info.draws_by_threshold = true;
    const std::vector<method::MethodConfig> settings = {{&info, {}},
                                                        {&info, {{"threshold", "201"}}}};
    EXPECT_EQ(SharedDrawings(settings).drawn().size(), 2U);
}

}  // namespace
}  // namespace ink::harness
