// Each skip has something to do on the scene that was made for it.

#include <gtest/gtest.h>

#include <algorithm>

#include "methods/method_configs.h"
#include "studies/axis_rows.h"
#include "studies/skip_axes.h"

namespace ink::studies {
namespace {

/// Takes the name of a skip.
class SkipCounts : public testing::TestWithParam<std::string> {
  protected:
    raster::Skip skip() const {
        const auto& infos = raster::skip_infos();
        return std::find_if(infos.begin(),
                            infos.end(),
                            [](const auto& info) { return info.name == GetParam(); })
            ->skip;
    }
    /// mote4 on the scene of the skip, with a quarter of its triangles on a quarter of the pixels:
    /// with every skip, without that one, without any.
    std::vector<harness::Row> rows(int threads = 1) const {
        Axis axis = skip_axes(kSkipSceneLevels - 1)[static_cast<std::size_t>(skip())];
        axis.repetitions = 1;
        harness::CellOptions options;
        options.measure.threads = threads;
        std::vector<harness::Row> rows;
        for (const AxisRow& of : axis_rows(axis,
                                           axis.cases(axis.values.front(), {640, 360}).front(),
                                           methods::make_configs("mote4", {}),
                                           options))
            rows.push_back(of.row);
        return rows;
    }
    raster::SkipCount count(const harness::Row& row) const {
        return row.skips->at(static_cast<std::size_t>(skip()));
    }
};

TEST_P(SkipCounts, AreAboveZeroOnTheSceneMadeForThem) {
    const auto timed = rows();
    ASSERT_EQ(timed.front().status, "ok");
    EXPECT_GT(count(timed.front()).skipped, 0U);
    EXPECT_LE(count(timed.front()).skipped, count(timed.front()).of);
}

TEST_P(SkipCounts, AreZeroWhereTheSkipIsNotAllowed) {
    const auto timed = rows();
    ASSERT_EQ(timed.size(), 3U);
    EXPECT_EQ(count(timed[1]).skipped, 0U);
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        EXPECT_EQ((*timed[2].skips)[static_cast<std::size_t>(info.skip)].skipped, 0U)
            << info.name << " with everything off";
    }
}

TEST_P(SkipCounts, DoNotDependOnTheNumberOfThreads) {
    const auto one = rows(1);
    const auto two = rows(2);
    EXPECT_EQ(count(one.front()).skipped, count(two.front()).skipped);
    EXPECT_EQ(count(one.front()).of, count(two.front()).of);
    EXPECT_EQ(one.front().image_hash, two.front().image_hash);
}

std::vector<std::string> skip_names() {
    std::vector<std::string> names;
    for (const raster::SkipInfo& info : raster::skip_infos())
        names.emplace_back(info.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Every, SkipCounts, testing::ValuesIn(skip_names()), [](const auto& name) {
    return name.param;
});

}  // namespace
}  // namespace ink::studies
