#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/text_table.h"
#include "harness/csv.h"
#include "scene/animation.h"
#include "studies/timedemo.h"

namespace ink::studies {
namespace {

/// A line of the table: what of a frame counts.
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
};

/// The values of one column, in the order in which they first come.
std::vector<std::string> seen(const std::vector<DemoFrame>& frames, std::string DemoFrame::*field) {
    std::vector<std::string> values;
    for (const DemoFrame& frame : frames) {
        if (std::find(values.begin(), values.end(), frame.*field) == values.end())
            values.push_back(frame.*field);
    }
    return values;
}

/// Which frames a cell of the table is about.
struct Choice {
    std::string path;
    std::string method;
    bool is_cached = false;
};

/// "142 [138, 147]" frames a second.
std::string rate_text(const std::vector<DemoFrame>& frames, const DemoRow& row, const Choice& of) {
    std::vector<std::int64_t> times_ns;
    for (const DemoFrame& frame : frames) {
        if (frame.path == of.path && frame.method == of.method &&
            (frame.pass > 0) == of.is_cached) {
            times_ns.push_back(row.frame_ns(frame));
        }
    }
    if (times_ns.empty()) return "-";
    const MedianRange range = median_range(std::move(times_ns));
    const auto rate = [](std::int64_t ns) {
        return 1e9 / static_cast<double>(std::max(ns, std::int64_t{1}));
    };
    return fmt::format(
        "{:.0f} [{:.0f}, {:.0f}]", rate(range.median), rate(range.high), rate(range.low));
}

}  // namespace

MedianRange median_range(std::vector<std::int64_t> values) {
    assert(!values.empty());
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    const double reach = 0.98 * std::sqrt(n);
    const auto at = [&](double rank) {
        return values[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
    };
    return {at(std::floor((n - 1) / 2)),
            at(std::floor(n / 2 - reach)),
            at(std::ceil(n / 2 + reach) - 1)};
}

std::string timedemo_table(const std::vector<DemoFrame>& frames) {
    if (frames.empty()) return "";
    const auto paths = seen(frames, &DemoFrame::path);
    const auto methods = seen(frames, &DemoFrame::method);
    core::Cells cells(1);
    cells[0] = {"method", "drawn"};
    for (const std::string& path : paths) {
        cells[0].push_back(path + ", first");
        cells[0].push_back("cached");
    }
    const auto add = [&](const DemoRow& row, const std::string& method) {
        std::vector<std::string>& line = cells.emplace_back();
        line = {row.is_of_method ? method : "-", row.name};
        for (const std::string& path : paths) {
            for (const bool is_cached : {false, true})
                line.push_back(rate_text(frames, row, {path, method, is_cached}));
        }
    };
    for (const DemoRow& row : kRows) {
        if (!row.is_of_method) add(row, methods.front());
    }
    for (const std::string& method : methods) {
        for (const DemoRow& row : kRows) {
            if (row.is_of_method) add(row, method);
        }
    }
    return core::aligned(cells);
}

std::string timedemo_heading(const harness::Subject& subject, const TimedemoOptions& options) {
    const auto& animation = subject.scene.animation;
    const std::string motion =
        animation == nullptr ? "which does not move"
        : animation->frame_count() > 0
            ? fmt::format("{:g} s of {} frames", animation->duration_s, animation->frame_count())
            : fmt::format("{:g} s of keys", animation->duration_s);
    return fmt::format(
        "{}, {}, {} drawn along each path, {}x{}, {} thread{}; frames per second, median [95 %]",
        subject.scene.name,
        motion,
        options.frames,
        subject.views.front().width_px,
        subject.views.front().height_px,
        options.threads,
        options.threads == 1 ? "" : "s");
}

void write_timedemo(const harness::Subject& subject,
                    const std::vector<DemoFrame>& frames,
                    const std::filesystem::path& path) {
    harness::CsvFile file(path,
                          {"scene",
                           "width",
                           "height",
                           "path",
                           "method",
                           "pass",
                           "frame",
                           "time_s",
                           "fill_ns",
                           "shade_ns",
                           "pose_ns",
                           "draw_ns",
                           "compose_ns",
                           "image_hash"});
    const scene::View& view = subject.views.front();
    for (const DemoFrame& f : frames) {
        file.write(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}",
                               harness::csv_field(subject.scene.name),
                               view.width_px,
                               view.height_px,
                               f.path,
                               f.method,
                               f.pass,
                               f.frame,
                               f.time_s,
                               f.fill_ns,
                               f.shade_ns,
                               f.pose_ns,
                               f.draw_ns,
                               f.compose_ns,
                               f.image_hash));
    }
    file.finish();
}

}  // namespace ink::studies
