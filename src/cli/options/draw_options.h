#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "draw/drawing.h"

namespace ink::cli {

/// The options by which an image gets its looks, as text until `drawing_looks` reads them.
struct LookOptions {
    std::string shading = "none";
    std::vector<std::string> shade_settings;
    std::string ink;
    std::string paper;
    std::string surface;
    double line_width_px = 0;
    int antialias = 1;
    shade::DitherFormat dither = shade::DitherFormat::none;

    friend bool operator==(const LookOptions&, const LookOptions&) = default;
};

/// Adds --shading, --set-shade, --ink, --paper, --surface, --line-width, --antialias and --dither
/// to a command.
void add_look_options(CLI::App& command, LookOptions& options);

/// What the options ask for; threads and skips are left at their defaults.
///
/// Throws core::Error (where = the option) for text that means nothing, and for an option that
/// would do nothing: --set-shade or --surface without shading.
[[nodiscard]] draw::DrawOptions drawing_looks(const LookOptions& options);

}  // namespace ink::cli
