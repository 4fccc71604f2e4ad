#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ink::report {

/// How long a GPU takes for the methods on one view, as the page that draws a model measured it
/// (live/card.js).
struct Card {
    struct Times {
        std::string method;
        double lines_ns = 0;
        double lines_spread_ns = 0;
        double mesh_ns = 0;
        double mesh_spread_ns = 0;
    };
    std::string program_version;
    std::string gpu;
    std::string driver;
    std::string browser;
    std::string clock;  ///< "timer query" or "frames read back"
    std::string scene;
    std::int64_t triangle_count = 0;
    std::string view;  ///< "" of a camera without a name
    std::int64_t width_px = 0;
    std::int64_t height_px = 0;
    std::vector<Times> methods;
};

/// Reads a card. Throws core::Error (where = "file: place") for a file that cannot be read or is no
/// JSON, a key that is missing, and a value that no page writes.
[[nodiscard]] Card read_card(const std::filesystem::path& file);

/// The card for a terminal: what measured what, then a line of milliseconds for each method. Times
/// of lines whose spread is above 15 % of them are marked.
[[nodiscard]] std::string card_text(const Card& card);

}  // namespace ink::report
