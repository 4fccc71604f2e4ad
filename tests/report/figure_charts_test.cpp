#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "methods/registry.h"
#include "report/charts.h"
#include "report/error_time_chart.h"
#include "report/label_places.h"
#include "report/method_looks.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using testing::HasSubstr;

/// Twenty-one methods, many of them close together: all registered ones and made-up others.
std::vector<std::string> many_names() {
    std::vector<std::string> names;
    for (const method::MethodInfo& info : methods::registry())
        names.push_back(info.name);
    while (names.size() < 21)
        names.push_back(fmt::format("made_up_{}_tuned", names.size()));
    return names;
}

std::vector<TimedError> many_points() {
    std::vector<TimedError> points;
    double ms = 0.3;
    for (const std::string& name : many_names()) {
        const double error = 0.02 + 0.003 * static_cast<double>(points.size() % 5);
        points.push_back({name,
                          ms,
                          statistics::Interval{ms / 2, ms * 2},
                          error,
                          statistics::Interval{error / 3, error * 2}});
        ms *= 1.09;
    }
    return points;
}

TEST(MethodLooks, NoTwoRegisteredMethodsLookAlike) {
    std::set<std::tuple<method::Family, method::Marker, bool>> looks;
    for (const method::MethodInfo& info : methods::registry()) {
        const Look look = look_of(info.name);
        EXPECT_EQ(look.family, info.family) << info.name;
        EXPECT_EQ(look.marker, info.marker) << info.name;
        EXPECT_TRUE(looks.insert({look.family, look.marker, look.is_hollow}).second) << info.name;
    }
}

TEST(MethodLooks, APresetIsItsMethodHollow) {
    const Look base = look_of("mote2");
    EXPECT_FALSE(base.is_hollow);
    for (const std::string name : {"mote4_tuned", "mote2_tuned"}) {  // shipped; made by a user
        const Look tuned = look_of(name);
        EXPECT_EQ(tuned.family, method::Family::packed) << name;
        EXPECT_TRUE(tuned.is_hollow) << name;
    }
    EXPECT_EQ(look_of("mote2_tuned").marker, base.marker);
    EXPECT_EQ(base_of("mote4_tuned"), "mote4");
    EXPECT_EQ(base_of("mote2_tuned"), "mote2");
    EXPECT_EQ(base_of("mote4"), "mote4");
}

TEST(MethodLooks, AStrangerIsOfNoFamilyAndGoesByItsPlace) {
    EXPECT_EQ(look_of("a_new_one", 3).family, method::Family::other);
    EXPECT_NE(look_of("a_new_one", 3).marker, look_of("another", 4).marker);
}

/// The attributes of the second shape of a drawing: the first is the rim of the marker.
std::string shape_of(method::Marker marker) {
    Svg svg(40, 40);
    draw_marker(svg, 20, 20, 10, {method::Family::packed, marker, false});
    const std::string text = svg.file("marker");
    const auto at = text.rfind('<', text.find(R"(fill="#0072b2")"));
    return text.substr(at, text.find('>', at) - at);
}

TEST(MethodLooks, EveryMarkerIsAShapeOfItsOwnRoundItsPlace) {
    std::set<std::string> shapes;
    for (const method::Marker marker : method::kMarkers) {
        const std::string shape = shape_of(marker);
        EXPECT_TRUE(shapes.insert(shape).second) << name_of(marker) << ": " << shape;
        if (marker == method::Marker::circle) continue;
        const auto begin = shape.find("points=\"") + 8;
        std::istringstream points(std::regex_replace(
            shape.substr(begin, shape.find('"', begin) - begin), std::regex(","), " "));
        std::vector<double> xy{std::istream_iterator<double>(points), {}};
        ASSERT_GE(xy.size(), 6U) << shape;
        for (const double value : xy) {
            EXPECT_GE(value, 20 - 14) << name_of(marker);
            EXPECT_LE(value, 20 + 14) << name_of(marker);
        }
    }
}

TEST(LabelPlaces, CoverNeitherEachOtherNorMarkersNorTheEdge) {
    LabelRoom room{.inside = {0, 0, 500, 400}, .taken = {{200, 150, 60, 20}}};
    std::vector<Named> named;
    for (const std::string& name : many_names()) {
        const auto i = static_cast<double>(named.size());
        named.push_back({name, 180 + 13 * std::fmod(i * 7, 11), 160 + 9 * std::fmod(i * 5, 8)});
    }
    named.push_back({"corner", 1, 1});
    const auto places = place_labels(named, room);
    ASSERT_EQ(places.size(), named.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Box& box = places[i].box;
        EXPECT_GE(box.x, 0) << named[i].name;
        EXPECT_GE(box.y, 0) << named[i].name;
        EXPECT_LE(box.x + box.width, 500) << named[i].name;
        EXPECT_LE(box.y + box.height, 400) << named[i].name;
        EXPECT_FALSE(box.overlaps(room.taken[0])) << named[i].name;
        for (std::size_t j = 0; j < places.size(); ++j) {
            const Box marker{named[j].x - 6, named[j].y - 6, 12, 12};
            EXPECT_FALSE(box.overlaps(marker)) << named[i].name << " covers " << named[j].name;
            if (j != i) {
                EXPECT_FALSE(box.overlaps(places[j].box))
                    << named[i].name << " covers " << named[j].name;
            }
        }
    }
}

/// Left and right end of every text of a drawing, as wide as it may come out.
std::vector<std::pair<double, double>> text_spans(const std::string& svg) {
    const std::regex text(
        R"re(<text x="([-\d.]+)" y="[-\d.]+" font-size="([\d.]+)"([^>]*)>([^<]*)</text>)re");
    std::vector<std::pair<double, double>> spans;
    for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
        const double x = std::stod((*it)[1]);
        const double width = 0.93 * text_width((*it)[4].str(), std::stod((*it)[2]));
        const std::string attributes = (*it)[3].str();
        const bool is_middle = attributes.find("\"middle\"") != std::string::npos;
        const bool is_end = attributes.find("\"end\"") != std::string::npos;
        const double left = is_middle ? x - width / 2 : is_end ? x - width : x;
        spans.emplace_back(left, left + width);
    }
    return spans;
}

TEST(ErrorTimeChart, NamesEveryMethodInsideTheImage) {
    const std::string svg = error_time_chart(many_points(), 0.002).file("error against time");
    EXPECT_EQ(nesting_error(svg), "");
    EXPECT_THAT(svg, HasSubstr(R"(width="560" height="470")"));
    for (const std::string& name : many_names())
        EXPECT_THAT(svg, HasSubstr(">" + name + "</text>"));
    EXPECT_THAT(svg, HasSubstr(">time to draw a frame (ms)</text>"));
    EXPECT_THAT(svg, HasSubstr(">error 1 − F at 2 px (%)</text>"));
    const auto spans = text_spans(svg);
    EXPECT_GT(spans.size(), 30U);
    for (const auto& [left, right] : spans) {
        EXPECT_GE(left, 0);
        EXPECT_LE(right, 560);
    }
}

TEST(ErrorTimeChart, DrawsInTheColoursOfThePalette) {
    const std::string svg = error_time_chart(many_points(), std::nullopt).file("e");
    std::set<std::string> known = {"#ffffff", "#d3d7dd", "#e6e8eb", "#8a919c", "#4b535e"};
    for (const method::Family family : method::kFamilies)
        known.insert(std::string(colour_of(family).hex));
    const std::regex colour("#[0-9a-f]{6}");
    for (std::sregex_iterator it(svg.begin(), svg.end(), colour), end; it != end; ++it)
        EXPECT_EQ(known.count(it->str()), 1U) << it->str();
}

TEST(ErrorTimeChart, AMethodWithoutErrorStandsOnTheLowerEdge) {
    const std::string svg =
        error_time_chart({{"ids", 1, std::nullopt, 0.0}, {"mote4", 2, std::nullopt, 0.1}}, {})
            .file("e");
    // The plot ends at 40 + 376; ids is a circle there.
    EXPECT_THAT(svg, HasSubstr(R"(cy="416.0")"));
    EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
    EXPECT_THAT(svg, testing::Not(HasSubstr("inf")));
}

TEST(ErrorTimeChart, SaysThatItIsEmpty) {
    EXPECT_THAT(error_time_chart({}, {}).file("e"), HasSubstr("No method was both"));
}

TEST(TimedErrors, AreOfMethodsAloneThatWereScoredAndTimed) {
    experiment::MethodSummary good;
    good.method = "a";
    good.f_2px = 0.75;
    good.f_2px_range = statistics::Interval{0.5, 1.0};
    good.draw_ms = 2;
    experiment::MethodSummary untimed = good;
    untimed.draw_ms.reset();
    experiment::MethodSummary baseline = good;
    baseline.is_baseline = true;
    const auto points = timed_errors({good, untimed, baseline});
    ASSERT_EQ(points.size(), 1U);
    EXPECT_EQ(points[0].error, 0.25);
    EXPECT_EQ(points[0].error_range->low, 0.0);
    EXPECT_EQ(points[0].error_range->high, 0.5);
    EXPECT_EQ(points[0].draw_ms, 2);
}

TEST(ClassChart, ShowsEveryClassEveryMethodAndTheIntervals) {
    std::vector<harness::Row> rows;
    for (const std::string& method : many_names()) {
        for (const char* scene : {"cube", "torus"}) {
            harness::Row row;
            row.method = method;
            row.scene = scene;
            row.k_2px = 40;
            row.n_pred = row.n_truth = 100;
            row.f_2px = 0.4;
            row.recall_by_class = {{"crease", scene == std::string("cube") ? 0.2 : 0.6}};
            row.truth_px_by_class = {{"crease", 100}};
            rows.push_back(row);
        }
    }
    const auto summaries = experiment::summarise(rows);
    const std::string svg = class_chart(summaries, rows).file("classes");
    EXPECT_EQ(nesting_error(svg), "");
    for (const char* name : {"contour", "boundary", "crease", "intersection", "seam"})
        EXPECT_THAT(svg, HasSubstr(fmt::format(">{}</text>", name)));
    EXPECT_THAT(svg, HasSubstr(">mote4</text>"));
    EXPECT_THAT(svg, HasSubstr(">.400</text>"));
    const std::string without = class_chart(summaries, {}).file("classes");
    EXPECT_GT(svg.size(), without.size() + 100) << "intervals are drawn";
}

}  // namespace
}  // namespace ink::report
