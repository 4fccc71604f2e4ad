#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/tables/table_of.h"
#include "core/text_table.h"
#include "core/whole_file.h"
#include "scene/animation.h"
#include "studies/timedemo.h"

namespace ink::studies {
namespace {

/// A kind of frame: what of it counts.
struct DemoRow {
    const char* name;
    bool is_of_method;  ///< else the same for all
    std::int64_t (*frame_ns)(const DemoFrame&);
};
constexpr DemoRow kRows[] = {
    {"plain", false, [](const DemoFrame& f) { return f.fill_ns; }},
    {"shading", false, [](const DemoFrame& f) { return f.shade_ns; }},
    {"no edges", true, [](const DemoFrame& f) { return f.shade_ns + f.pose_ns; }},
    {"full",
     true,
     [](const DemoFrame& f) { return f.shade_ns + f.pose_ns + f.draw_ns + f.compose_ns; }},
    {"toon",
     true,
     [](const DemoFrame& f) { return f.toon_ns + f.pose_ns + f.draw_ns + f.compose_ns; }},
};

/// The values of one column, in the order in which they first come.
std::vector<std::string> seen(const std::vector<DemoFrame>& frames, std::string DemoFrame::*field) {
    std::vector<std::string> values;
    for (const DemoFrame& frame : frames) {
        if (std::ranges::find(values, frame.*field) == values.end()) values.push_back(frame.*field);
    }
    return values;
}

/// The rate of the frames that `of` is about; nothing if there are none.
std::optional<DemoRate> rate_of(const std::vector<DemoFrame>& frames,
                                const DemoRow& row,
                                const DemoRate& of) {
    std::vector<std::int64_t> times_ns;
    for (const DemoFrame& frame : frames) {
        if (frame.path == of.path && frame.method == of.method &&
            (frame.pass > 0) == of.is_cached) {
            times_ns.push_back(row.frame_ns(frame));
        }
    }
    if (times_ns.empty()) return std::nullopt;
    const MedianRange range = median_range(std::move(times_ns));
    const auto rate = [](std::int64_t ns) {
        return 1e9 / static_cast<double>(std::max(ns, std::int64_t{1}));
    };
    DemoRate found = of;
    found.fps = rate(range.median);
    found.low_fps = rate(range.high);
    found.high_fps = rate(range.low);
    if (!row.is_of_method) found.method.clear();
    return found;
}

/// A frame and what it is of.
struct FrameLine {
    const harness::SceneViews& scene_views;
    const DemoFrame& frame;
};

const core::TableOf<FrameLine>& frames_table() {
    static const auto kTable = [] {
        core::TableOf<FrameLine> table(
            "timedemo.csv",
            "A line per frame, pass, path and method of `inkbench timedemo`, which "
            "writes this file alone. Times are processor time of the one thread, or time on the "
            "wall of several.");
        table.add_derived({"scene", "", "that moves"},
                          [](const FrameLine& l) { return l.scene_views.scene.name; });
        const auto view =
            table.part([](auto& l) -> const scene::View& { return l.scene_views.views.front(); });
        view.add_derived({"width", "px", "of the image"}, &scene::View::width_px);
        view.add_derived({"height", "px", "of the image"}, &scene::View::height_px);
        using F = DemoFrame;
        const auto frame = table.part([](auto& l) -> const F& { return l.frame; });
        const auto add_time = [&frame](const char* name, std::int64_t F::*ns, const char* doc) {
            frame.add_derived({name, "ns", doc, true}, ns);
        };
        frame.add_derived({"path", "", "how the camera moves: orbit, dolly, shake, pan, roll, own"},
                          &F::path);
        frame.add_derived({"method", "", "as registered"}, &F::method);
        frame.add_derived({"pass", "", "0: every frame for the first time"}, &F::pass);
        frame.add_derived({"frame", "", "of the path, from 0"}, &F::frame);
        frame.add_derived({"time_s", "s", "of the animation"}, &F::time_s);
        add_time("fill_ns", &F::fill_ns, "the surface moved and filled with one tone");
        add_time("shade_ns", &F::shade_ns, "shading, its own rasterization included");
        add_time("toon_ns", &F::toon_ns, "the same by the toon table");
        add_time("pose_ns", &F::pose_ns, "of the method; with its prepare in the first frame");
        add_time("draw_ns", &F::draw_ns, "of the method");
        add_time("compose_ns", &F::compose_ns, "the lines put over the shading");
        frame.add_derived({"image_hash", "", "of the edge responses"}, &F::image_hash);
        return table;
    }();
    return kTable;
}

}  // namespace

MedianRange median_range(std::vector<std::int64_t> values) {
    assert(!values.empty());
    std::ranges::sort(values);
    const auto n = static_cast<double>(values.size());
    const double reach = 0.98 * std::sqrt(n);
    const auto at = [&](double rank) {
        return values[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
    };
    return {at(std::floor((n - 1) / 2)),
            at(std::floor(n / 2 - reach)),
            at(std::ceil(n / 2 + reach) - 1)};
}

std::vector<DemoRate> timedemo_rates(const std::vector<DemoFrame>& frames) {
    std::vector<DemoRate> rates;
    const auto methods = seen(frames, &DemoFrame::method);
    for (const std::string& path : seen(frames, &DemoFrame::path)) {
        for (const std::string& method : methods) {
            for (const DemoRow& row : kRows) {
                // Fill and shading stand in every method's lines: the first will do.
                if (!row.is_of_method && method != methods.front()) continue;
                for (const bool is_cached : {false, true}) {
                    const DemoRate of{path, method, row.name, is_cached};
                    if (const auto rate = rate_of(frames, row, of)) rates.push_back(*rate);
                }
            }
        }
    }
    return rates;
}

std::string timedemo_table(const std::vector<DemoFrame>& frames) {
    if (frames.empty()) return "";
    const auto paths = seen(frames, &DemoFrame::path);
    core::Cells cells = {{"method", "drawn"}};
    for (const std::string& path : paths) {
        cells[0].push_back(path + ", first");
        cells[0].push_back(path + ", cached");
    }
    // "142 [138, 147]" frames a second where there is such a rate, in the line of its kind.
    for (const DemoRate& rate : timedemo_rates(frames)) {
        const std::string method = rate.method.empty() ? "-" : rate.method;
        auto line = std::ranges::find_if(
            cells, [&](const auto& cell) { return cell[0] == method && cell[1] == rate.drawn; });
        if (line == cells.end()) {
            line = cells.insert(line, std::vector<std::string>(cells[0].size(), "-"));
            line->front() = method;
            line->at(1) = rate.drawn;
        }
        const auto path = std::ranges::find(paths, rate.path) - paths.begin();
        line->at(2 + 2 * static_cast<std::size_t>(path) + (rate.is_cached ? 1 : 0)) =
            fmt::format("{:.0f} [{:.0f}, {:.0f}]", rate.fps, rate.low_fps, rate.high_fps);
    }
    return core::aligned(cells);
}

std::string timedemo_legend() {
    return "plain     the surface filled with one tone\n"
           "shading   Gouraud's shading\n"
           "no edges  shading, and what the method does to follow the motion; no lines\n"
           "full      the same with the lines, which are put over the shading\n"
           "toon      the same over levels of grey from a table instead\n"
           "first     every frame for the first time along the path\n"
           "cached    the same frames again: methods that keep what they have seen are faster\n";
}

bool has_own_lights(const harness::SceneViews& scene_views) {
    return !scene_views.scene.lights.empty();
}

std::string timedemo_heading(const harness::SceneViews& scene_views,
                             const TimedemoOptions& options) {
    const auto& animation = scene_views.scene.animation;
    const std::string motion =
        animation == nullptr ? "which does not move"
        : animation->frame_count() > 0
            ? fmt::format("{:g} s of {} frames", animation->duration_s, animation->frame_count())
            : fmt::format("{:g} s of keys", animation->duration_s);
    return fmt::format(
        "{}, {}, {} drawn along each path, {}x{}, {} thread{}, {} lights; frames per second {}, "
        "median [95 %]",
        scene_views.scene.name,
        motion,
        options.frames,
        scene_views.views.front().width_px,
        scene_views.views.front().height_px,
        options.threads,
        options.threads == 1 ? "" : "s",
        has_own_lights(scene_views) ? "own" : "studio",
        options.threads == 1 ? "of processor time" : "on the wall");
}

const core::TableInfo& timedemo_frames_table() {
    return frames_table().info();
}

void write_timedemo(const harness::SceneViews& scene_views,
                    const std::vector<DemoFrame>& frames,
                    const std::filesystem::path& path) {
    std::vector<FrameLine> lines;
    for (const DemoFrame& frame : frames)
        lines.push_back({scene_views, frame});
    core::write_whole_file(path, frames_table().file(lines));
}

}  // namespace ink::studies
