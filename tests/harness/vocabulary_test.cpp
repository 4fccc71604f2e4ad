#include "core/vocabulary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "method/method.h"
#include "score/attribution.h"
#include "truth/line_class.h"

// vocabulary.json has the words, the rooms have the enumerators: their order must be the same.

namespace ink::harness {
namespace {

using testing::ElementsAre;
using testing::MatchesRegex;

TEST(Vocabulary, NamesTheClassesInTheirOrder) {
    const auto classes = core::vocabulary().classes;
    ASSERT_EQ(classes.size(), truth::kLineClasses.size());
    for (std::size_t i = 0; i < classes.size(); ++i)
        EXPECT_EQ(classes[i].name, truth::name(truth::kLineClasses[i]));
    std::vector<std::string_view> groups;
    for (const core::Term& group : core::vocabulary().recall_groups)
        groups.push_back(group.name);
    EXPECT_THAT(groups,
                ElementsAre("contour",
                            "boundary",
                            "crease",
                            "intersection",
                            "seam",
                            "intersection_above_crease",
                            "intersection_below_crease"));
}

TEST(Vocabulary, NamesTheCausesInTheirOrder) {
    using score::Cause;
    EXPECT_EQ(core::vocabulary().causes.size(), score::kCauseCount);
    const auto kind_of = [](Cause cause) {
        const std::string key = "{\"name\": \"" + std::string(name(cause)) + "\", \"kind\": \"";
        const std::string_view json = core::vocabulary().json;
        return json.substr(json.find(key) + key.size(), 15);
    };
    for (const Cause cause : score::kFalsePositiveCauses)
        EXPECT_EQ(kind_of(cause), "false_positives");
    for (const Cause cause : score::kFalseNegativeCauses)
        EXPECT_EQ(kind_of(cause), "false_negatives");
    EXPECT_EQ(name(Cause::one_triangle), "one_triangle");
    EXPECT_EQ(name(Cause::crack), "crack");
    EXPECT_EQ(name(Cause::thinned), "thinned");
    EXPECT_EQ(name(Cause::undeclared), "undeclared");
}

TEST(Vocabulary, NamesFamiliesAndMarkersInTheirOrder) {
    using method::Family;
    using method::Marker;
    EXPECT_EQ(core::vocabulary().families.size(), method::kFamilies.size());
    EXPECT_EQ(name_of(Family::packed), "packed");
    EXPECT_EQ(name_of(Family::edges_and_hulls), "edges_and_hulls");
    EXPECT_EQ(name_of(Family::other), "other");
    EXPECT_EQ(core::vocabulary().markers.size(), method::kMarkers.size());
    EXPECT_EQ(name_of(Marker::circle), "circle");
    EXPECT_EQ(name_of(Marker::plus), "plus");
    EXPECT_EQ(name_of(Marker::right), "right");
}

TEST(Vocabulary, HasAMeaningOfEveryCauseAndAColourOfWhatPicturesShow) {
    for (const core::Term& cause : core::vocabulary().causes)
        EXPECT_NE(cause.text, "") << cause.name;
    for (const auto& terms : {core::vocabulary().causes, core::vocabulary().classes}) {
        for (const core::Term& term : terms)
            EXPECT_THAT(std::string(term.picture), MatchesRegex("#[0-9a-f]{6}")) << term.name;
    }
}

}  // namespace
}  // namespace ink::harness
