#include "report/figure_grids.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/sheet.h"
#include "score/attribution.h"
#include "tests/report/markup.h"

namespace ink::report {
namespace {

using testing::ElementsAre;

constexpr draw::Mark kWrong = draw::mark_of(score::Cause::other);

TEST(MostDifferent, FindsTheWindowWhereOneIsWorse) {
    draw::Marks a(100, 50);
    draw::Marks b(100, 50);
    for (int i = 0; i < 6; ++i)
        a.at(70 + i, 30) = kWrong;
    for (int i = 0; i < 20; ++i)  // both are wrong here: no difference
        a.at(10 + i, 10) = b.at(10 + i, 10) = kWrong;
    const Window w = most_different(a, b, 20, 10);
    // All windows with the six pixels: left 56..70, top 21..30; their middle.
    EXPECT_EQ(w.left, 63);
    EXPECT_THAT(w.top, testing::AnyOf(25, 26));
    EXPECT_EQ(w.width, 20);
    EXPECT_EQ(w.height, 10);
}

TEST(MostDifferent, OfEqualsShowsTheMostWrongAndOfNoneTheMiddle) {
    draw::Marks a(100, 50);
    EXPECT_EQ(most_different(a, a, 20, 10).left, 40);
    EXPECT_EQ(most_different(a, a, 20, 10).top, 20);
    a.at(0, 0) = kWrong;
    EXPECT_EQ(most_different(a, a, 20, 10).left, 0);
    EXPECT_EQ(most_different(a, a, 20, 10).top, 0);
}

GridFigure made_up_grid(int columns) {
    GridFigure figure;
    GridBand band{"a title that is much longer than it has any right to be in a figure", {}, {}};
    GridRow row{"a_scene_with_a_name_of_considerable_length", "three_quarter", {}};
    for (int i = 0; i < columns; ++i) {
        band.columns.push_back("polygon_offset_tuned");
        row.cells.push_back({draw::RgbImage(60, 34, draw::kMist.rgb), "F .912 and more than fits"});
    }
    band.rows = {row, row};
    figure.bands = {band, band};
    figure.legend = {{{draw::kInk, "right"},
                      {draw::kBlue, "false: one triangle"},
                      {draw::kGreen, "false: crack"}},
                     {{draw::kOrange, "missing: below threshold"}}};
    return figure;
}

TEST(PictureGrid, KeepsAllWordsOnTheSheetAndApart) {
    for (const int columns : {1, 3, 8}) {
        const GridFigure figure = made_up_grid(columns);
        const Sheet sheet = lay_out(figure.bands, figure.legend);
        const std::vector<Box> boxes = sheet.text_boxes();
        EXPECT_GE(boxes.size(), 4U * static_cast<std::size_t>(columns));
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_GE(boxes[i].x, 0);
            EXPECT_GE(boxes[i].y, 0);
            EXPECT_LE(boxes[i].x + boxes[i].width, sheet.width_px());
            EXPECT_LE(boxes[i].y + boxes[i].height, sheet.height_px());
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(boxes[i].overlaps(boxes[j])) << columns << ": " << i << ", " << j;
        }
    }
}

TEST(PictureGrid, ComesOutAsPixelsAndAsVectors) {
    const GridFigure figure = made_up_grid(2);
    const Sheet sheet = lay_out(figure.bands, figure.legend);
    const draw::RgbImage raster = sheet.raster();
    EXPECT_EQ(raster.width_px(), sheet.width_px());
    EXPECT_EQ(raster.height_px(), sheet.height_px());
    const std::string svg = sheet.svg("grid");
    EXPECT_EQ(nesting_error(svg), "");
    std::size_t images = 0;
    for (std::size_t at = 0; (at = svg.find("<image ", at)) != std::string::npos; ++at)
        ++images;
    EXPECT_EQ(images, 8U);
}

TEST(PictureGrid, WithoutBandsIsTheLegend) {
    const Sheet sheet = lay_out({}, {{{draw::kInk, "right"}}});
    EXPECT_EQ(sheet.text_boxes().size(), 1U);
}

TEST(Sheet, LettersCoverThePaperWhereTheyStand) {
    Sheet sheet(200, 40);
    sheet.text({100, 28, "MMMM", {"middle", "#0072b2", 24}});
    const draw::RgbImage raster = sheet.raster();
    const Box box = sheet.text_boxes()[0];
    int inside = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 200; ++x) {
            if (raster.at(x, y) == draw::kPaper.rgb) continue;
            ++inside;
            EXPECT_GE(x + 2, box.x);
            EXPECT_LE(x - 2, box.x + box.width);
        }
    }
    EXPECT_GT(inside, 150);
}

TEST(Sheet, FittingCutsWithAMark) {
    const TextStyle style{"start", "#000000", 20};
    EXPECT_EQ(fitting("short", style, 500), "short");
    const std::string cut = fitting("a_very_long_name_of_a_method", style, 120);
    EXPECT_TRUE(cut.ends_with("~"));
    EXPECT_LE(sheet_text_width(cut, style), 120);
    EXPECT_GT(cut.size(), 3U);
    EXPECT_EQ(fitting("", style, -3), "");
}

/// One view of 120 x 60 with two methods: one has a packed buffer, the other depth and normals.
FigureView made_up_view(const std::string& scene) {
    FigureView view{scene, "front", {}, {}};
    view.truth.traced.labels = core::Image<std::uint8_t>(120, 60);
    for (int x = 20; x < 100; ++x)
        view.truth.traced.labels.at(x, 30) = 3;
    view.truth.traced.curves.push_back(
        {.line_class = truth::LineClass::crease, .begin = {20, 30.5, 1}, .end = {100, 30.5, 1}});
    const draw::RgbImage grey(120, 60, draw::kMist.rgb);
    FigureEvaluation packed{{}, draw::Marks(120, 60), {{"packed", grey}, {"filtered", grey}}};
    packed.row.method = "mote4";
    packed.row.f_2px = 0.9;
    packed.marks.at(50, 30) = draw::mark_of(score::Cause::cancelled);
    FigureEvaluation full{{}, draw::Marks(120, 60), {{"depth", grey}, {"normal", grey}}};
    full.row.method = "decaudin";
    full.row.f_2px = 0.8;
    view.evaluations = {packed, full};
    return view;
}

TEST(StripsFigure, HasEverySceneAndMethodAndWraps) {
    const GridFigure two = strips_figure({made_up_view("cube"), made_up_view("torus")});
    ASSERT_EQ(two.bands.size(), 1U);
    EXPECT_THAT(two.bands[0].columns, ElementsAre("truth", "mote4", "decaudin"));
    ASSERT_EQ(two.bands[0].rows.size(), 2U);
    EXPECT_EQ(two.bands[0].rows[1].label, "torus");
    EXPECT_EQ(two.bands[0].rows[0].cells[1].caption, "F .900");
    EXPECT_TRUE(two.bands[0].rows[0].cells[1].is_strong);
    EXPECT_FALSE(two.bands[0].rows[0].cells[2].is_strong);

    FigureView many = made_up_view("cube");
    for (int i = 0; i < 11; ++i) {
        many.evaluations.push_back(many.evaluations[0]);
        many.evaluations.back().row.method = "m" + std::to_string(i);
    }
    const GridFigure wrapped = strips_figure({many});
    ASSERT_EQ(wrapped.bands.size(), 3U) << "thirteen methods, six in a band";
    std::size_t shown = 0;
    for (const GridBand& band : wrapped.bands) {
        EXPECT_EQ(band.columns[0], "truth");
        EXPECT_LE(band.columns.size(), 7U);
        shown += band.columns.size() - 1;
    }
    EXPECT_EQ(shown, 13U);
}

TEST(StripsFigure, LegendHasTheColoursThatAreThere) {
    const GridFigure figure = strips_figure({made_up_view("cube")});
    std::vector<std::string> words;
    for (const auto& group : figure.legend) {
        for (const LegendEntry& entry : group)
            words.push_back(entry.words);
    }
    EXPECT_THAT(words, ElementsAre("right", "missing: cancelled", "truth: crease"));
}

TEST(BuffersFigure, ShowsPackedAndFilteredBesideFullBuffersAndTruth) {
    const GridFigure figure = buffers_figure({made_up_view("cube")});
    ASSERT_EQ(figure.bands.size(), 1U);
    EXPECT_THAT(figure.bands[0].columns, ElementsAre("full buffers", "mote4"));
    const auto& rows = figure.bands[0].rows;
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].label, "packed");
    EXPECT_EQ(rows[1].label, "filtered");
    EXPECT_EQ(rows[0].cells[0].caption, "depth");
    EXPECT_EQ(rows[1].cells[0].caption, "normal");
    EXPECT_EQ(rows[2].cells[0].caption, "truth");
    for (const GridRow& row : rows) {
        for (const GridCell& cell : row.cells)
            EXPECT_FALSE(cell.image.is_empty());
    }
}

TEST(BuffersFigure, IsEmptyWhereNobodyHasABuffer) {
    FigureView view = made_up_view("cube");
    for (FigureEvaluation& evaluation : view.evaluations)
        evaluation.layers.clear();
    EXPECT_TRUE(buffers_figure({view}).bands.empty());
}

TEST(ZoomFigure, EnlargesTheWindowWithTheTruthOverIt) {
    const GridFigure figure = zoom_figure({made_up_view("cube")}, {"mote4", "decaudin"});
    ASSERT_EQ(figure.bands.size(), 1U);
    const auto& rows = figure.bands[0].rows;
    ASSERT_EQ(rows.size(), 2U);
    ASSERT_EQ(rows[0].cells.size(), 4U);
    const draw::RgbImage& errors = rows[0].cells[2].image;
    EXPECT_EQ(errors.width_px(), 64 * 6);
    EXPECT_EQ(errors.height_px(), 32 * 6);
    EXPECT_EQ(rows[0].cells[2].caption, "mote4: 1 wrong here");
    EXPECT_EQ(rows[0].cells[3].caption, "decaudin: 0 wrong here");
    int vermilion = 0;
    for (std::size_t i = 0; i < errors.size(); ++i)
        vermilion += errors.data()[i] == draw::kVermilion.rgb ? 1 : 0;
    EXPECT_EQ(vermilion, 36) << "one pixel, six by six";
    ASSERT_EQ(rows[0].cells[2].lines.size(), 2U) << "a rim and a core";
    for (const SheetLine& line : rows[0].cells[2].lines) {
        EXPECT_GE(line.xy[0], 0);
        EXPECT_LE(line.xy[2], 64 * 6) << "cut at the window";
    }
    EXPECT_EQ(rows[1].cells[0].caption, "mote4: packed");
    EXPECT_EQ(rows[1].cells[3].caption, "decaudin: normal");
    EXPECT_TRUE(zoom_figure({made_up_view("cube")}, {"mote4", "nobody"}).bands.empty());
}

}  // namespace
}  // namespace ink::report
