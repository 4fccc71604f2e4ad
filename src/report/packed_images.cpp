#include "report/packed_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/image.h"
#include "core/parallel.h"
#include "draw/error_image.h"
#include "harness/view_images.h"
#include "image_io/image_file.h"
#include "report/packed_tables.h"

namespace ink::report {
namespace {

using Codes = core::Image<std::uint8_t>;

std::string base64(const std::vector<std::uint8_t>& bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = bytes.size() - i < 3 ? bytes.size() - i : 3;
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8U | (j < count ? bytes[i + j] : 0U);
        for (std::size_t digit = 0; digit < 4; ++digit)
            text += digit <= count ? kDigits[group >> (18U - 6U * digit) & 63U] : '=';
    }
    return text;
}

std::string png_of(const Codes& codes) {
    return base64(image_io::encode_png(codes));
}

std::string truth_png(const Codes& labels, int factor) {
    return png_of(factor == 1 ? labels : draw::shrink(labels, factor));
}

std::string method_png(const harness::ShownView& view,
                       const harness::MethodImage& image,
                       int factor) {
    draw::Marks marks = draw::mark_errors(
        view.labels, image.edge_response, {.threshold = image.threshold, .wrong = image.wrong});
    if (factor > 1) marks = draw::shrink(marks, factor);
    Codes codes(marks.width_px(), marks.height_px());
    for (std::size_t i = 0; i < codes.size(); ++i)
        codes.data()[i] = static_cast<std::uint8_t>(marks.data()[i]);
    return png_of(codes);
}

/// A view's entry: its key, and its images as JSON.
std::string packed_view(const harness::ShownView& view, int factor) {
    std::vector<std::string> pngs(view.images.size() + 1);
    core::parallel_for(pngs.size(), core::hardware_threads(), [&](std::size_t i) {
        pngs[i] =
            i == 0 ? truth_png(view.labels, factor) : method_png(view, view.images[i - 1], factor);
    });
    std::string methods;
    for (std::size_t i = 1; i < pngs.size(); ++i) {
        methods += fmt::format(
            "{}{}:\"{}\"", i == 1 ? "" : ",", json_text(view.images[i - 1].method), pngs[i]);
    }
    return fmt::format("{}:{{\"width\":{},\"height\":{},\"truth\":\"{}\",\"methods\":{{{}}}}}",
                       json_text(view.scene + "\n" + view.view),
                       view.labels.width_px(),
                       view.labels.height_px(),
                       pngs[0],
                       methods);
}

/// One view of a run, of which the run folder may hold images.
struct ViewPlace {
    std::size_t run = 0;
    std::vector<harness::Row> rows;  ///< its methods
};

/// The views of all runs: the first of every scene, then the second of every scene, and so on.
/// What comes late is left out first.
std::vector<ViewPlace> view_places(const std::vector<experiment::RunData>& runs) {
    std::vector<std::pair<int, ViewPlace>> places;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        std::map<std::pair<std::string, std::string>, std::size_t> index;
        std::map<std::string, int> views_of_scene;
        for (const harness::Row& row : runs[run].tables.rows) {
            const auto [at, is_new] = index.emplace(std::pair(row.scene, row.view), places.size());
            if (is_new) places.push_back({views_of_scene[row.scene]++, {run, {}}});
            places[at->second].second.rows.push_back(row);
        }
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return a.first < b.first;
    });
    std::vector<ViewPlace> ordered;
    for (auto& [rank, place] : places)
        ordered.push_back(std::move(place));
    return ordered;
}

/// The images of every view at 1/factor of their size; nothing if they exceed the budget, unless
/// `may_leave_out`: then those that fit.
std::optional<std::vector<std::string>> packed_at(const std::vector<experiment::RunData>& runs,
                                                  const std::vector<ViewPlace>& places,
                                                  int factor,
                                                  std::size_t budget_bytes,
                                                  bool may_leave_out) {
    std::vector<std::string> of_run(runs.size());
    std::size_t size_bytes = 0;
    for (const ViewPlace& place : places) {
        const auto view = harness::read_shown_view(runs[place.run].folder, place.rows);
        if (!view) continue;
        const std::string packed = packed_view(*view, factor);
        size_bytes += packed.size();
        if (size_bytes > budget_bytes) {
            if (may_leave_out) break;
            return std::nullopt;
        }
        of_run[place.run] += (of_run[place.run].empty() ? "" : ",") + packed;
    }
    return of_run;
}

}  // namespace

std::string packed_images(const std::vector<experiment::RunData>& runs, std::size_t budget_bytes) {
    const std::vector<ViewPlace> places = view_places(runs);
    std::optional<std::vector<std::string>> of_run;
    for (const int factor : {1, 2, 4, 8}) {
        of_run = packed_at(runs, places, factor, budget_bytes, factor == 8);
        if (of_run) break;
    }
    std::string text;
    for (const std::string& views : *of_run)
        text += fmt::format("{}{{{}}}", text.empty() ? "" : ",", views);
    return "[" + text + "]";
}

}  // namespace ink::report
