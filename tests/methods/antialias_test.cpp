#include "methods/antialias.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "shade/compose.h"
#include "tests/core/error_text.h"
#include "tests/methods/small_scenes.h"

namespace ink::methods {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Pair;

/// Draws strength 200 above the line y = x of its image and 90 on it; or rows as wide as its lines.
class Slope : public method::Method {
  public:
    struct Params {
        double width_px = 2;
        int threshold = 100;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        table.number(&Params::width_px, "width_px", {1, 64}, "px", "Rows.");
        return method::add_threshold(table);
    }

    explicit Slope(const Params& params) : params_(params) {}
    void prepare(const scene::PreparedScene&) override {}
    void pose(const scene::PreparedScene&) override {}
    void draw(const method::Frame&, edge::EdgeImage& out) override {
        for (int y = 0; y < out.height_px(); ++y) {
            for (int x = 0; x < out.width_px(); ++x)
                out.at(x, y) = y < params_.width_px ? 255 : x > y ? 200 : x == y ? 90 : 0;
        }
    }
    [[nodiscard]] int bytes_per_px() const override { return 3; }

  private:
    Params params_;
};

const method::MethodInfo& slope() {
    static const method::MethodInfo info = method::method_info<Slope>("slope");
    return info;
}

edge::EdgeImage drawing_of(const method::MethodConfig& config, int width_px, int height_px) {
    const scene::Scene scene = cube_on_floor();
    return drawn(*config.info,
                 config.settings,
                 scene,
                 {view_from(scene, {3, 2, 4}, {0, 0, 0}, {width_px, height_px})});
}

TEST(Antialias, NoneIsTheMethodItself) {
    const method::MethodConfig config =
        antialiased({&slope(), {{"threshold", "7"}}}, Antialias::none, 1.5);
    EXPECT_EQ(config.info, &slope());
    EXPECT_FALSE(config.is_grey);
}

TEST(Antialias, AveragesSamplesThatAreAllOrNothing) {
    const method::MethodConfig grey = antialiased({&slope(), {}}, Antialias::resolve16, 0.25);
    EXPECT_TRUE(grey.is_grey);
    const edge::EdgeImage out = drawing_of(grey, 5, 5);
    EXPECT_EQ(out.width_px(), 5);
    // Of 16 samples 6 lie above the diagonal, and those on it are below the threshold.
    EXPECT_EQ(out.at(3, 3), (6 * 255 + 8) / 16);
    EXPECT_EQ(out.at(4, 3), 255);
    EXPECT_EQ(out.at(2, 3), 0);
    const method::MethodConfig all =
        antialiased({&slope(), {{"threshold", "90"}}}, Antialias::resolve4, 0.5);
    EXPECT_EQ(drawing_of(all, 5, 5).at(3, 3), (3 * 255 + 2) / 4);
}

TEST(Antialias, DrawsWidthsInSamples) {
    const auto rows = [](const core::ParamValues& settings, double line_width_px) {
        const auto grey = antialiased({&slope(), settings}, Antialias::resolve4, line_width_px);
        const edge::EdgeImage out = drawing_of(grey, 2, 8);
        int sum = 0;
        for (int y = 0; y < 8; ++y)
            sum += out.at(0, y);
        return sum / 255.0;
    };
    // Column 0 has no more than that and a sample of the slope.
    EXPECT_NEAR(rows({}, 1.5), 1.5, 0.25);
    EXPECT_NEAR(rows({}, 4), 4, 0.25);
    EXPECT_NEAR(rows({{"width_px", "3"}}, 1.5), 3, 0.25) << "what the user set stays";
}

/// Draws one pixel, the same share of the way across any image; or its mirror image.
template <bool kIsMirrored>
class Dot : public Slope {
  public:
    struct Params {
        int threshold = 128;
    };
    static core::ParamTable<Params> table() {
        core::ParamTable<Params> table;
        return method::add_threshold(table);
    }
    explicit Dot(const Params&) : Slope({}) {}
    void draw(const method::Frame&, edge::EdgeImage& out) override {
        const int x = out.width_px() * 3 / 8;
        const int y = out.height_px() / 2;
        out.fill(0);
        if (kIsMirrored) {
            out.at(out.width_px() - 1 - x, out.height_px() - 1 - y) = 255;
        } else {
            out.at(x, y) = 255;
        }
    }
};

TEST(Antialias, FollowsWhatIsDrawnWithAPenWhoseMiddleIsTheSample) {
    const method::MethodInfo dot = method::method_info<Dot<false>>("dot");
    const method::MethodInfo mirrored = method::method_info<Dot<true>>("mirrored");
    for (const Antialias antialias : {Antialias::resolve4, Antialias::resolve16}) {
        int ink_before = 0;
        for (const double width_px : {1.0, 1.5, 2.0, 3.0}) {
            const auto drawn = [&, antialias = antialias](const method::MethodInfo& info) {
                return drawing_of(antialiased({&info, {}}, antialias, width_px), 16, 12);
            };
            const edge::EdgeImage out = drawn(dot);
            const edge::EdgeImage other = drawn(mirrored);
            int ink = 0;
            for (int y = 0; y < 12; ++y) {
                for (int x = 0; x < 16; ++x) {
                    EXPECT_EQ(out.at(x, y), other.at(15 - x, 11 - y)) << width_px;
                    ink += out.at(x, y);
                }
            }
            EXPECT_GT(ink, ink_before) << width_px;
            ink_before = ink;
        }
    }
}

TEST(Antialias, OfAMethodWithoutAWidthIsItsSamplesUnderThePen) {
    const method::MethodConfig base{&find_method("roberts"), {}};
    edge::EdgeImage samples = drawing_of(base, 2 * 40, 2 * 24);
    const int threshold = method::threshold_of(base);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples.data()[i] = samples.data()[i] >= threshold ? 255 : 0;
    const edge::EdgeImage out = drawing_of(antialiased(base, Antialias::resolve4, 2), 40, 24);
    EXPECT_EQ(out, shade::average(shade::widen(samples, 3), 2));
    EXPECT_NE(out, edge::EdgeImage(40, 24)) << "something is drawn";
}

TEST(Antialias, IsAMethodOfItsOwnThatSaysAllItsParameters) {
    const method::MethodConfig grey =
        antialiased({&slope(), {{"threshold", "42"}}}, Antialias::resolve4, 1.5);
    EXPECT_EQ(grey.info->name, "slope_resolve4");
    EXPECT_EQ(grey.info->bytes_per_px({}), 12);
    EXPECT_THAT(grey.info->complete({}),
                AllOf(Contains(Pair("antialias", "resolve4")),
                      Contains(Pair("sample_threshold", "42")),
                      Contains(Pair("threshold", "128")),
                      Contains(Pair("width_px", "3"))));
    EXPECT_EQ(method::threshold_of(grey), kGreyThreshold);
    EXPECT_THAT(core::error_text([&] {
                    return grey.info->make({{"threshold", "0"}});
                }),
                HasSubstr("1..255"));
}

TEST(Antialias, RefusesMoreSamplesThanThereMayBe) {
    EXPECT_EQ(enlarged({{}, 160, 90}, 4).width_px, 640);
    EXPECT_THAT(core::error_text([] {
                    return enlarged({{}, 8000, 9}, 4);
                }),
                AllOf(HasSubstr("--antialias"), HasSubstr("4 times 8000x9"), HasSubstr("16384")));
}

}  // namespace
}  // namespace ink::methods
