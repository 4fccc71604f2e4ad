#include "report/card.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/whole_file.h"
#include "tests/core/temp_folder.h"

namespace ink::report {
namespace {

using testing::HasSubstr;
using testing::Not;

nlohmann::json made_up_card() {
    return {{"inkbench_card", 1},
            {"program_version", "9.9.9"},
            {"gpu", "Made-up GPU 1"},
            {"driver", "WebGL 2.0"},
            {"browser", "Made-up 1"},
            {"clock", "timer query"},
            {"scene", "torus"},
            {"triangle_count", 1234},
            {"view", "iso"},
            {"width_px", 640},
            {"height_px", 360},
            {"methods",
             {{{"method", "ids"},
               {"lines_ns", 10000},
               {"lines_spread_ns", 900.5},
               {"mesh_ns", 200000},
               {"mesh_spread_ns", 1}},
              {{"method", "mote4"},
               {"lines_ns", 0},
               {"lines_spread_ns", 5},
               {"mesh_ns", 0},
               {"mesh_spread_ns", 0}}}}};
}

class CardFile : public testing::Test {
  protected:
    [[nodiscard]] Card read(const std::string& text) const {
        core::write_whole_file(file_, text);
        return read_card(file_);
    }
    void expect_refused(const std::string& text, const std::string& words) const {
        try {
            (void)read(text);
            FAIL() << words;
        } catch (const core::Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(words));
            EXPECT_THAT(error.what(), HasSubstr("card.json"));
        }
    }
    core::TempFolder folder_;
    std::filesystem::path file_ = folder_.path() / "card.json";
};

TEST_F(CardFile, IsReadBackAndPrinted) {
    const Card card = read(made_up_card().dump());
    EXPECT_EQ(card.triangle_count, 1234);
    EXPECT_EQ(card.methods[0].lines_spread_ns, 900.5);
    const std::string text = card_text(card);
    EXPECT_THAT(text,
                HasSubstr("model    torus, 1234 triangles, view iso, 640x360, inkbench 9.9.9\n"));
    EXPECT_THAT(text, HasSubstr("ids                   0.010    0.001      0.200    0.000\n"));
    EXPECT_THAT(
        text,
        HasSubstr("mote4                 0.000    0.000      0.000    0.000  lines uncertain"));
}

TEST_F(CardFile, NamesEachPlaceWithItsValue) {
    const auto expect_wrong =
        [&](const char* pointer, const nlohmann::json& value, const char* words) {
            nlohmann::json card = made_up_card();
            card[nlohmann::json::json_pointer(pointer)] = value;
            expect_refused(card.dump(), words);
        };
    expect_wrong("/inkbench_card", 2, "card.json: inkbench_card: it is 2 (accepted: 1)");
    expect_wrong("/gpu", 5, "card.json: gpu: it is 5 (accepted: a text)");
    expect_wrong("/clock", "sundial", "clock: it is \"sundial\" (accepted: timer query or frames");
    expect_wrong("/width_px", 0, "width_px: it is 0 (accepted: a whole number, 1 to");
    expect_wrong("/height_px", 1.5, "height_px: it is 1.5");
    expect_wrong("/methods", nullptr, "methods: it is null (accepted: a list");
    expect_wrong("/methods/1", "ids", "methods[1].: it is \"ids\" (accepted: an object)");
    expect_wrong("/methods/1/lines_ns", -1, "methods[1].lines_ns: it is -1 (accepted: nanoseconds");
    expect_wrong("/methods/0/mesh_ns", nullptr, "methods[0].mesh_ns: it is null");
    const nlohmann::json whole = made_up_card();
    for (const auto& [key, value] : whole.items()) {
        nlohmann::json card = whole;
        card.erase(key);
        expect_refused(card.dump(), "card.json: " + key + ": it is missing");
    }
    expect_refused("{\"inkbench_card\": 1", "it is no JSON object");
    expect_refused("", "it is no JSON object");
}

TEST_F(CardFile, ThatIsNotThereIsRefused) {
    EXPECT_THROW((void)read_card(folder_.path() / "none.json"), core::Error);
}

}  // namespace
}  // namespace ink::report
