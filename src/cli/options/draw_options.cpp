#include "cli/options/draw_options.h"

#include <fmt/format.h>

#include <optional>

#include "cli/options/command_rows.h"
#include "core/error.h"
#include "core/parse_number.h"
#include "core/split_list.h"

namespace ink::cli {
namespace {

/// Nothing for text that was not given.
std::optional<glm::u8vec3> parse_color(const std::string& text, const char* option) {
    if (text.empty()) return std::nullopt;
    const bool is_hex = text.size() == 7 && text[0] == '#';
    const std::vector<std::string> parts =
        is_hex ? std::vector{text.substr(1, 2), text.substr(3, 2), text.substr(5, 2)}
               : core::split_list(text);
    glm::u8vec3 color{0};
    bool is_color = parts.size() == 3;
    for (int c = 0; is_color && c < 3; ++c) {
        const auto byte =
            core::parse_number<std::uint8_t>(parts[static_cast<std::size_t>(c)], is_hex ? 16 : 10);
        color[c] = byte.value_or(0);
        is_color = byte.has_value();
    }
    if (!is_color) {
        throw core::Error(option,
                          fmt::format("'{}' is no colour", text),
                          "R,G,B with whole numbers 0..255, or #rrggbb");
    }
    return color;
}

core::ParamValues parse_settings(const std::vector<std::string>& settings, const char* option) {
    core::ParamValues values;
    for (const std::string& text : settings) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw core::Error(option, fmt::format("'{}' is no setting", text), "key=value");
        }
        values[text.substr(0, equals)] = text.substr(equals + 1);
    }
    return values;
}

void refuse_unused(bool is_given, const char* option, const std::string& needs) {
    if (is_given) throw core::Error(option, "it would do nothing here", needs);
}

std::optional<shade::Style> parse_style(const LookOptions& options) {
    const core::ParamValues settings = parse_settings(options.shade_settings, "--set-shade");
    if (options.shading != "none") return shade::find_shading(options.shading).make(settings);
    const std::string needs = "--shading NAME with it";
    refuse_unused(!settings.empty(), "--set-shade", needs);
    refuse_unused(!options.surface.empty(), "--surface", needs);
    return std::nullopt;
}

}  // namespace

void add_look_options(CLI::App& command, LookOptions& options) {
    std::string names = "none";
    for (const shade::ShadingInfo& info : shade::shadings())
        names += "|" + info.name;
    constexpr const char* kColor = "R,G,B|#RRGGBB";
    CommandRows rows(command);
    // clang-format off
    rows.text("--shading", options.shading, names, "What is under the lines");
    rows.list("--set-shade", options.shade_settings, "KEY=VALUE",
              "A parameter of the shading; may be given again (see inkbench list shadings)");
    rows.text("--ink", options.ink, kColor, "Colour of the lines (default: near black)");
    rows.text("--paper", options.paper, kColor, "Colour where nothing is (default: white)");
    rows.text("--surface", options.surface, kColor,
              "Colour of shaded surfaces, with --shading (default: light grey)");
    rows.number("--line-width", options.line_width_px, {0, draw::kMostLineWidth_px}, "PX",
                "Thin the lines and draw them this wide; 0 leaves them as the method draws them");
    rows.number("--antialias", options.antialias, {1, draw::kMostAntialias}, "N",
                "Draw at N x N the size and average, 1..8");
    rows.choice("--dither", options.dither, {"none", "565", "332"},
                "Ordered dither to a frame buffer's bits");
    // clang-format on
}

draw::DrawOptions drawing_looks(const LookOptions& options) {
    draw::DrawOptions looks;
    looks.shading = parse_style(options);
    looks.ink = parse_color(options.ink, "--ink");
    looks.paper = parse_color(options.paper, "--paper");
    looks.surface = parse_color(options.surface, "--surface");
    looks.dither = options.dither;
    looks.line_width_px = options.line_width_px;
    looks.antialias = options.antialias;
    return looks;
}

}  // namespace ink::cli
