// Any text is an experiment whose names and numbers are all good, or an Error at one of its lines.

#include "experiment/experiment.h"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/error.h"
#include "harness/suite/suite.h"
#include "methods/registry.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

constexpr std::string_view kFile = "fuzz.toml";

/// "fuzz.toml" alone, or with the number of a line that the text has.
void check_where(std::string_view where, std::string_view text) {
    expect(where.substr(0, kFile.size()) == kFile, "an Error names the file");
    if (where == kFile) return;
    const std::string_view number = where.substr(kFile.size() + 1);
    int line = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), line);
    expect(
        where[kFile.size()] == ':' && error == std::errc{} && end == number.data() + number.size(),
        "an Error names a line");
    const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
    expect(line >= 1 && line <= lines, "the line is one of the file");
}

bool is_in(int value, int least, int most) {
    return value >= least && value <= most;
}

void check_experiment(const experiment::Experiment& e) {
    expect(!e.name.empty() && e.name.find('/') == std::string::npos, "the name names a folder");
    expect(!e.methods.empty() && !e.sizes.empty() && !e.threads.empty(), "there are cells");
    for (const std::string& method : e.methods)
        expect(methods::find_method(method).name == method, "methods are registered");
    for (const experiment::ImageSize& size : e.sizes)
        harness::check_size(size.width_px, size.height_px);
    for (const int threads : e.threads)
        expect(is_in(threads, 1, 256), "threads are in range");
    expect(is_in(e.compare.views, 0, 360) && is_in(e.stress.points, 0, 1000) &&
               is_in(e.animation.frames, 2, 10000) && is_in(e.repetitions, 1, 10000) &&
               is_in(e.compare.own_sweep_views, 0, 360),
           "counts are in range");
    expect(e.crease_deg >= 0 && e.crease_deg <= 180 && e.budget_ms >= 0, "numbers are in range");
    if (!e.compare.entrants.empty()) return;  // a configuration of an entrant reads all its files
    const auto configs = experiment::configs_of(e);
    expect(configs.size() == e.methods.size(), "a method is a configuration");
    for (const experiment::SettingGrid& grid : e.compare.grids) {
        std::size_t combinations = 1;
        for (const auto& [key, values] : grid.axes)
            combinations *= std::min<std::size_t>(values.size(), 100);
        const auto config =
            std::find_if(configs.begin(), configs.end(), [&](const method::MethodConfig& c) {
                return c.info->name == grid.method;
            });
        expect(config != configs.end(), "a sweep is of a method that takes part");
        if (combinations > 100) continue;
        const std::size_t count = experiment::grid_configs(*config, grid).size();
        expect(count >= 1 && count <= combinations, "a grid has its combinations, or fewer");
    }
}

}  // namespace

void check_experiment(Bytes bytes) {
    const std::string text(bytes.begin(), bytes.end());
    experiment::Experiment read;
    try {
        read = experiment::parse_experiment(text, kFile);
    } catch (const core::Error& error) {
        expect_clear(error);
        check_where(error.where(), text);
        return;
    }
    expect_usable("an experiment that was taken can be run", [&] { check_experiment(read); });
}

}  // namespace ink::fuzz
