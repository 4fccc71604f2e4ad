#include "search/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ink::search {
namespace {

using Point = std::vector<double>;

/// Lowest, 0, at (0.3, 0.7, 0.7, ...), with waves over it so that it has many lows.
double bumpy(const Point& x) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double d = x[i] - (i == 0 ? 0.3 : 0.7);
        sum += d * d + 0.02 * (1 - std::cos(25 * d));
    }
    return sum;
}

struct Trail {
    std::vector<std::string> phases;
    std::vector<Point> points;
    double best = 1e9;

    SearchObjective objective() {
        return [this](const char* phase, const Point& x) {
            phases.emplace_back(phase);
            points.push_back(x);
            best = std::min(best, bumpy(x));
            return SearchValue{bumpy(x), true};
        };
    }
};

Trail searched(const SearchPlan& plan, std::size_t size = 3) {
    Trail trail;
    search(trail.objective(), Point(size, 0.95), plan);
    return trail;
}

TEST(Search, EverySearchComesNearTheLowestPoint) {
    for (const std::string& global : global_searches()) {
        const Trail trail = searched({.evaluations = 600, .seed = 3, .global = global});
        EXPECT_LT(trail.best, 0.02) << global;
    }
}

TEST(Search, UsesItsEvaluationsAndNoMore) {
    const Trail trail = searched({.evaluations = 150, .seed = 1});
    EXPECT_EQ(trail.points.size(), 150U);
    EXPECT_EQ(trail.phases.front(), "start");
    EXPECT_EQ(trail.points.front(), Point(3, 0.95));
    EXPECT_EQ(trail.phases[1], "global");
    EXPECT_EQ(trail.phases.back(), "local");
    for (const Point& point : trail.points) {
        for (const double x : point) {
            EXPECT_GE(x, 0);
            EXPECT_LE(x, 1);
        }
    }
    EXPECT_EQ(searched({.evaluations = 1}).points.size(), 1U);
    EXPECT_EQ(searched({.evaluations = 30}, 1).points.size(), 30U) << "one parameter alone";
}

TEST(Search, TheSeedDecidesTheTrail) {
    const Trail a = searched({.evaluations = 120, .seed = 5});
    EXPECT_EQ(a.points, searched({.evaluations = 120, .seed = 5}).points);
    EXPECT_NE(a.points, searched({.evaluations = 120, .seed = 6}).points);
}

TEST(Search, AFunctionOfFewValuesEndsTheSearchToo) {
    // Nothing is new after the first: a search that waits for new values would not end.
    int calls = 0;
    search(
        [&](const char*, const Point&) {
            return SearchValue{1, calls++ == 0};
        },
        Point(2, 0.5),
        {.evaluations = 50});
    EXPECT_GT(calls, 1);
    EXPECT_LE(calls, 50 * 20 + 10);
}

TEST(Search, WhatTheObjectiveThrowsComesThrough) {
    int calls = 0;
    const SearchObjective objective = [&](const char*, const Point& x) {
        if (++calls == 20) throw std::runtime_error("stop here");
        return SearchValue{bumpy(x), true};
    };
    EXPECT_THROW(search(objective, Point(3, 0.5), {.evaluations = 100}), std::runtime_error);
    EXPECT_EQ(calls, 20);
}

TEST(Search, RandomPointsAreEvenOverTheCubeAndTheSameForASeed) {
    Trail a;
    random_search(a.objective(), 2, {.evaluations = 1000, .seed = 4});
    Trail b;
    random_search(b.objective(), 2, {.evaluations = 1000, .seed = 4});
    EXPECT_EQ(a.points, b.points);
    ASSERT_EQ(a.points.size(), 1000U);
    double sum = 0;
    int low = 0;
    for (const Point& x : a.points) {
        sum += x[0];
        low += x[1] < 0.25 ? 1 : 0;
    }
    // Five standard deviations: 0.289 / sqrt(1000) and sqrt(1000 / 4 * 3 / 4).
    EXPECT_NEAR(sum / 1000, 0.5, 0.046);
    EXPECT_NEAR(low, 250, 69);
    EXPECT_EQ(a.phases.back(), "random");
}

}  // namespace
}  // namespace ink::search
