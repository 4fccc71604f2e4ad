#include "report/card.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "core/error.h"
#include "core/whole_file.h"

namespace ink::report {
namespace {

using CardJson = nlohmann::json;

constexpr int kFormat = 1;
constexpr double kMost_ns = 1e12;
constexpr double kMostSpread = 0.15;  ///< of a time, as in live/clock.js
constexpr std::size_t kMostShown = 60;

std::string shown(const CardJson& value) {
    std::string text = value.dump(-1, ' ', true, CardJson::error_handler_t::replace);
    if (text.size() > kMostShown) text = text.substr(0, kMostShown) + "...";
    return text;
}

/// An object of a card, and where it stands, for messages.
struct Fields {
    const CardJson& object;
    std::string where;

    [[nodiscard]] std::string place(const char* key) const { return where + key; }

    [[nodiscard]] const CardJson& at(const char* key, const char* accepted) const {
        if (!object.is_object()) throw core::Error(where, "it is " + shown(object), "an object");
        const auto found = object.find(key);
        if (found == object.end()) throw core::Error(place(key), "it is missing", accepted);
        return *found;
    }
    [[nodiscard]] std::string text(const char* key) const {
        constexpr const char* kAccepted = "a text";
        const CardJson& value = at(key, kAccepted);
        if (!value.is_string()) throw core::Error(place(key), "it is " + shown(value), kAccepted);
        return value.get<std::string>();
    }
    [[nodiscard]] double ns(const char* key) const {
        constexpr const char* kAccepted = "nanoseconds, 0 to 1e12";
        const CardJson& value = at(key, kAccepted);
        if (!value.is_number() || !(value >= 0.0 && value <= kMost_ns))
            throw core::Error(place(key), "it is " + shown(value), kAccepted);
        return value.get<double>();
    }
    [[nodiscard]] std::int64_t count(const char* key) const {
        constexpr const char* kAccepted = "a whole number, 1 to 2147483647";
        const CardJson& value = at(key, kAccepted);
        if (!value.is_number_integer() || value < 1 || value > 2147483647)
            throw core::Error(place(key), "it is " + shown(value), kAccepted);
        return value.get<std::int64_t>();
    }
    [[nodiscard]] std::string word(const char* key,
                                   std::initializer_list<const char*> words) const {
        const std::string accepted = fmt::format("{}", fmt::join(words, " or "));
        const CardJson& value = at(key, accepted.c_str());
        for (const char* each : words)
            if (value == each) return each;
        throw core::Error(place(key), "it is " + shown(value), accepted);
    }
};

std::vector<Card::Times> times_of(const Fields& card) {
    constexpr const char* kAccepted = "a list of methods with their times";
    const CardJson& methods = card.at("methods", kAccepted);
    if (!methods.is_array())
        throw core::Error(card.place("methods"), "it is " + shown(methods), kAccepted);
    std::vector<Card::Times> times;
    for (const CardJson& method : methods) {
        const Fields fields{method, fmt::format("{}methods[{}].", card.where, times.size())};
        times.push_back({fields.text("method"),
                         fields.ns("lines_ns"),
                         fields.ns("lines_spread_ns"),
                         fields.ns("mesh_ns"),
                         fields.ns("mesh_spread_ns")});
    }
    return times;
}

}  // namespace

Card read_card(const std::filesystem::path& file) {
    const std::string accepted = "the file that Copy card or Save card of a page gives";
    const std::optional<std::string> bytes = core::read_whole_file(file);
    if (!bytes) throw core::Error(file.string(), "it cannot be read", accepted);
    const CardJson json = CardJson::parse(*bytes, nullptr, false);
    if (!json.is_object()) throw core::Error(file.string(), "it is no JSON object", accepted);
    const Fields fields{json, file.string() + ": "};
    if (const CardJson& format = fields.at("inkbench_card", "1"); format != kFormat)
        throw core::Error(fields.place("inkbench_card"), "it is " + shown(format), "1");
    return {.program_version = fields.text("program_version"),
            .gpu = fields.text("gpu"),
            .driver = fields.text("driver"),
            .browser = fields.text("browser"),
            .clock = fields.word("clock", {"timer query", "frames read back"}),
            .scene = fields.text("scene"),
            .triangle_count = fields.count("triangle_count"),
            .view = fields.text("view"),
            .width_px = fields.count("width_px"),
            .height_px = fields.count("height_px"),
            .methods = times_of(fields)};
}

std::string card_text(const Card& card) {
    std::string text = fmt::format(
        "GPU      {}\ndriver   {}\nbrowser  {}\nclock    {}\n"
        "model    {}, {} triangles, view {}, {}x{}, inkbench {}\n\n"
        "{:<16} {:>10} {:>8} {:>10} {:>8}\n",
        card.gpu,
        card.driver,
        card.browser,
        card.clock,
        card.scene,
        card.triangle_count,
        card.view.empty() ? "as turned" : card.view,
        card.width_px,
        card.height_px,
        card.program_version,
        "method",
        "lines ms",
        "+-",
        "mesh ms",
        "+-");
    for (const Card::Times& times : card.methods)
        text += fmt::format("{:<16} {:>10.3f} {:>8.3f} {:>10.3f} {:>8.3f}{}\n",
                            times.method,
                            times.lines_ns / 1e6,
                            times.lines_spread_ns / 1e6,
                            times.mesh_ns / 1e6,
                            times.mesh_spread_ns / 1e6,
                            times.lines_spread_ns <= kMostSpread * times.lines_ns
                                ? ""
                                : "  lines uncertain: coarse clock, or busy");
    return text;
}

}  // namespace ink::report
