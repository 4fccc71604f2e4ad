#include "core/param.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/core/error_text.h"

namespace ink::core {
namespace {

enum class Fruit { apple, pear };
struct Shared {
    int count = 3;
};
struct Parameters : Shared {
    double size = 0.5;
    bool is_ripe = true;
    Fruit fruit = Fruit::pear;
};

ParamTable<Parameters> table() {
    return ParamTable<Parameters>()
        .number(&Parameters::size, "size", {0, 1}, "px", "How large.")
        .number(&Parameters::count, "count", {0, 9}, "", "How many.")
        .flag(&Parameters::is_ripe, "is_ripe", "Whether it can be eaten.")
        .choice(&Parameters::fruit, "fruit", {"apple", "pear"}, "Which.");
}

std::string message_of(const ParamValues& values) {
    return error_text([&] { return table().read(values, "basket"); });
}

TEST(ParamTable, AGivenNumberCountsAndItsTextIsForMessages) {
    const ParamTable<Parameters> rows = table();
    Parameters found;
    rows.set(found, 0, {{"a third", "here", 1.0 / 3}}, "it");
    EXPECT_EQ(found.size, 1.0 / 3);
    EXPECT_EQ(error_text([&] {
                  rows.set(found, 0, {{"4/3", "here", 4.0 / 3}}, "it");
              }),
              "here: it cannot be '4/3' (accepted: a number 0..1)");
}

TEST(ParamTable, DefaultsComeFromTheFields) {
    const auto params = table().params();
    EXPECT_EQ(params[0].default_value, 0.5);
    EXPECT_EQ(params[1].default_value, 3);
    EXPECT_EQ(params[2].default_value, 1);
    EXPECT_EQ(params[3].default_value, 1);
}

TEST(ParamTable, ReadsEveryKind) {
    const Parameters k = table().read(
        {{"size", "0.25"}, {"count", "9"}, {"is_ripe", "false"}, {"fruit", "apple"}}, "basket");
    EXPECT_EQ(k.size, 0.25);
    EXPECT_EQ(k.count, 9);
    EXPECT_FALSE(k.is_ripe);
    EXPECT_EQ(k.fruit, Fruit::apple);
}

TEST(ParamTable, CompletesWithDefaultsWhatReadsBackTheSame) {
    const ParamValues values = table().complete({{"size", "0.10"}, {"fruit", "apple"}}, "basket");
    EXPECT_EQ(
        values,
        (ParamValues{{"size", "0.1"}, {"count", "3"}, {"is_ripe", "true"}, {"fruit", "apple"}}));
    EXPECT_EQ(table().complete(values, "basket"), values);
    const Parameters k = table().read(values, "basket");
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_EQ(table().get(k, i).front(), values.at(table().params()[i].name));
}

TEST(ParamTable, UnknownNameListsTheKnownAndTheNearest) {
    EXPECT_EQ(
        message_of({{"siez", "1"}}),
        "basket: there is no parameter 'siez' (accepted: size, count, is_ripe, fruit; did you "
        "mean size?)");
}

TEST(ParamTable, ValuesOutsideTheirRangeNameTheRange) {
    EXPECT_THAT(message_of({{"size", "1.5"}}), testing::HasSubstr("a number 0..1"));
    EXPECT_THAT(message_of({{"size", "nan"}}), testing::HasSubstr("'nan'"));
    EXPECT_THAT(message_of({{"size", "0.5x"}}), testing::HasSubstr("'0.5x'"));
    EXPECT_THAT(message_of({{"count", "2.5"}}), testing::HasSubstr("a whole number 0..9"));
    EXPECT_THAT(message_of({{"fruit", "plum"}}), testing::HasSubstr("apple | pear"));
    EXPECT_THAT(message_of({{"is_ripe", "maybe"}}), testing::HasSubstr("true | false"));
}

}  // namespace
}  // namespace ink::core
