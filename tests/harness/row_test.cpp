#include "harness/row.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/error.h"
#include "harness/csv.h"

namespace ink::harness {
namespace {

/// The fields of one CSV record, unquoted as RFC 4180 has it.
std::vector<std::string> parse_record(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

std::string field(const Row& row, const std::string& column) {
    const auto& names = row_columns();
    const auto found = std::find(names.begin(), names.end(), column);
    return parse_record(to_csv(row)).at(static_cast<std::size_t>(found - names.begin()));
}

TEST(RowColumns, HoldWhatScriptsRelyOnOnceEach) {
    const auto& names = row_columns();
    for (const char* name : {"method",
                             "scene",
                             "view",
                             "split",
                             "width",
                             "height",
                             "threads",
                             "seed",
                             "params",
                             "status",
                             "f_2px",
                             "f_1px",
                             "precision_2px",
                             "recall_2px",
                             "recall_contour",
                             "recall_boundary",
                             "recall_crease",
                             "recall_intersection",
                             "recall_seam",
                             "mean_width_px",
                             "ap",
                             "prepare_ns",
                             "draw_ns",
                             "bytes_per_px",
                             "image_hash",
                             "truth_px",
                             "commit",
                             "dirty",
                             "compiler",
                             "flags",
                             "cpu",
                             "simd"}) {
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    }
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(ToCsv, ReadsBackWhateverANameHolds) {
    Row row;
    row.method = "mote4";
    row.scene = "a \"b\", c\nd";
    row.params = "k=1;l=2";
    row.f_2px = 0.1;
    row.recall_by_class["crease"] = 0.25;
    EXPECT_EQ(parse_record(to_csv(row)).size(), row_columns().size());
    EXPECT_EQ(field(row, "scene"), row.scene);
    EXPECT_EQ(field(row, "f_2px"), "0.1");
    EXPECT_EQ(field(row, "recall_crease"), "0.25");
    EXPECT_EQ(field(row, "recall_seam"), "");
    EXPECT_EQ(field(row, "draw_ns"), "");
}

TEST(ToCsv, AFailedCellIsARowWithAStatusAndNoMetrics) {
    Row row;
    row.method = "mote4";
    row.status = "failed: out of ink";
    EXPECT_EQ(field(row, "status"), "failed: out of ink");
    for (const char* name : {"f_2px", "ap", "draw_ns", "truth_px", "n_pred"}) {
        EXPECT_EQ(field(row, name), "") << name;
    }
}

class CsvFileTest : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::string text_of(const std::filesystem::path& path) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) /
        ("ink_csv_file_test_" +  // of one test: others run beside it
         std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(CsvFileTest, HasItsNameOnlyWhenItIsFinished) {
    CsvFile file(folder_ / "t.csv", {"a", "b"});
    file.write("1,2");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "t.csv"));
    EXPECT_EQ(text_of(folder_ / "t.csv.part"), "a,b\n1,2\n");
    file.finish();
    EXPECT_EQ(text_of(folder_ / "t.csv"), "a,b\n1,2\n");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "t.csv.part"));
}

TEST_F(CsvFileTest, AnUnwritablePlaceIsAnErrorAtOnce) {
    EXPECT_THROW(CsvFile(folder_ / "nowhere" / "t.csv", {"a"}), core::Error);
}

TEST(CurveCsv, HasNinetyNineLinesOfOneCell) {
    std::array<score::CurveCount, 99> curve{};
    curve[98] = {1, 2, 3};
    Row row;
    row.method = "mote4";
    row.scene = "a,b";
    const std::string lines = curve_csv(row, curve);
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 98);
    const std::string last = lines.substr(lines.rfind('\n') + 1);
    const auto fields = parse_record(last);
    ASSERT_EQ(fields.size(), curve_columns().size());
    EXPECT_EQ(fields[1], "a,b");
    EXPECT_EQ(fields[6], "99");
    EXPECT_EQ(fields[9], "3");
}

TEST(RowColumns, OfLineScoresAreEmptyWithoutThem) {
    const std::vector<std::string> names = {"crack_precision",
                                            "crack_recall",
                                            "crack_f",
                                            "offset_px",
                                            "offset_spread_px",
                                            "offset_rms_px",
                                            "shift_x_px",
                                            "shift_y_px",
                                            "width_along_px",
                                            "width_spread_px",
                                            "false_ink_px"};
    Row row;
    for (const std::string& name : names)
        EXPECT_EQ(field(row, name), "") << name;
    row.lines = LineScores{};
    row.lines->cracks.n_drawn = 8;
    row.lines->cracks.n_beside = 4;
    row.lines->cracks.all = {4, 4};
    row.lines->ink = {8, 3};
    row.lines->offsets.all.add(0.25);
    row.lines->offsets.all.add(0.75);
    EXPECT_EQ(field(row, "crack_precision"), "0.5");
    EXPECT_EQ(field(row, "crack_recall"), "1");
    EXPECT_EQ(field(row, "offset_px"), "0.5");
    EXPECT_EQ(field(row, "offset_spread_px"), "0.25");
    EXPECT_EQ(field(row, "shift_x_px"), "");
    EXPECT_EQ(field(row, "width_along_px"), "");
    EXPECT_EQ(field(row, "false_ink_px"), "3");
    EXPECT_EQ(field(row, "ink_px"), "8");
}

}  // namespace
}  // namespace ink::harness
