#include "report/packed_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include <optional>
#include <utility>

#include "core/base64.h"
#include "core/image.h"
#include "core/parallel.h"
#include "core/parse_number.h"
#include "draw/error_image.h"
#include "harness/images/view_images.h"
#include "image_io/image_file.h"
#include "report/page_template.h"

namespace ink::report {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kExactDigits = 15;

/// The field as a JSON value; nothing if it is a text.
std::optional<std::string> json_value(const std::string& field) {
    if (field.empty() || field == "nan") return "null";
    if (field == "true" || field == "false") return field;
    if (field == "inf" || field == "-inf") return page_json(field);
    const auto value = core::parse_number<double>(field);
    const bool is_number = value && std::isfinite(*value);
    const bool is_plain = field.find_first_not_of("0123456789") == std::string::npos;
    // JSON has no numbers that begin with 0 and a digit: these are a code.
    const std::size_t first = field.front() == '-' ? 1 : 0;
    const bool is_code = field.size() > first + 1 && field[first] == '0' &&
                         std::isdigit(static_cast<unsigned char>(field[first + 1])) != 0;
    if (!is_number || is_code || (is_plain && field.size() > kExactDigits)) return std::nullopt;
    return field;
}

template <class Items>
std::string json_array(const Items& items) {
    return fmt::format("[{}]", fmt::join(items, ","));
}

std::string text_column(const std::vector<std::string>& fields) {
    std::map<std::string, int> index;
    std::vector<std::string> words;
    std::vector<int> at;
    for (const std::string& field : fields) {
        if (field.empty()) {
            at.push_back(-1);
            continue;
        }
        const auto [found, is_new] = index.emplace(field, static_cast<int>(words.size()));
        if (is_new) words.push_back(page_json(field));
        at.push_back(found->second);
    }
    return fmt::format("{{\"words\":{},\"at\":{}}}", json_array(words), json_array(at));
}

std::string png_of(const core::Image<std::uint8_t>& codes) {
    const auto png = image_io::encode_png(codes);
    return core::base64(std::as_bytes(std::span(png)));
}

/// Views whose images are in memory at a time, about 100 MB each.
constexpr std::size_t kViewsAtOnce = 4;

/// A view's images as JSON, and what says of them which method drew which.
struct PackedView {
    std::string head;    ///< members "width", "height" and "methods"
    std::string images;  ///< members "truth", "images" and "inks"
};

PackedView packed_view(const harness::ShownView& view, const experiment::RunData& run) {
    const draw::ErrorMarker marker(view.labels, {});
    std::vector<std::string> inks(view.images.size(), "null");
    for (const auto& [method, image] : view.image_of) {
        if (experiment::method_fact(run, method, "ink") == "true")
            inks[image] = fmt::format("\"{}\"", png_of(view.images[image].edge_response));
    }
    std::vector<std::string> pngs(view.images.size());
    core::parallel_for(pngs.size(), core::hardware_threads(), [&](std::size_t i) {
        const harness::MethodImage& image = view.images[i];
        const draw::Marks marks =
            marker.mark(image.edge_response, {.threshold = image.threshold, .wrong = image.wrong});
        pngs[i] = fmt::format("\"{}\"", png_of(core::mapped<std::uint8_t>(marks, [](draw::Mark m) {
                                  return static_cast<std::uint8_t>(m);
                              })));
    });
    std::vector<std::string> methods;
    for (const auto& [method, image] : view.image_of)
        methods.push_back(fmt::format("{}:{}", page_json(method), image));
    return {fmt::format(R"("width":{},"height":{},"methods":{{{}}})",
                        view.labels.width_px(),
                        view.labels.height_px(),
                        fmt::join(methods, ",")),
            fmt::format(R"("truth":"{}","images":{},"inks":{})",
                        png_of(view.labels),
                        json_array(pngs),
                        json_array(inks))};
}

/// One view of a run, of which the run folder may hold images.
struct ViewPlace {
    int rank = 0;  ///< in its scene
    std::size_t run = 0;
    std::vector<harness::Row> rows = {};  ///< its methods
};

/// The views of all runs: the first of every scene, then the second of every scene, and so on.
/// What comes late has no room first.
std::vector<ViewPlace> view_places(const std::vector<experiment::RunData>& runs) {
    std::vector<ViewPlace> places;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        std::map<std::pair<std::string, std::string>, std::size_t> index;
        std::map<std::string, int> views_of_scene;
        for (const harness::Row& row : runs[run].tables.rows) {
            const auto [at, is_new] = index.emplace(std::pair(row.scene, row.view), places.size());
            if (is_new) places.push_back({views_of_scene[row.scene]++, run});
            places[at->second].rows.push_back(row);
        }
    }
    std::ranges::stable_sort(places, {}, &ViewPlace::rank);
    return places;
}

}  // namespace

std::string packed_column(const std::vector<std::string>& fields) {
    std::vector<std::string> values;
    for (const std::string& field : fields) {
        std::optional<std::string> value = json_value(field);
        if (!value) break;
        values.push_back(std::move(*value));
    }
    const bool is_text = values.size() < fields.size();
    const bool is_constant =
        fields.size() > 1 && std::equal(fields.begin() + 1, fields.end(), fields.begin());
    if (is_constant) {
        return fmt::format("{{\"constant\":{}}}",
                           is_text ? page_json(fields.front()) : values.front());
    }
    return is_text ? text_column(fields) : json_array(values);
}

std::string packed_columns(const core::CsvTable& table) {
    std::vector<std::string> columns;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::vector<std::string> fields;
        fields.reserve(table.records.size());
        for (const std::vector<std::string>& record : table.records)
            fields.push_back(core::unquoted(record[i]));
        columns.push_back(page_json(table.columns[i]) + ":" + packed_column(fields));
    }
    return fmt::format("{{{}}}", fmt::join(columns, ","));
}

nlohmann::ordered_json packed_table(const core::CsvTable& table) {
    const std::string columns = packed_columns(table);
    const std::vector<std::uint8_t> packed = deflated(std::as_bytes(std::span(columns)));
    return {{"lines", table.records.size()},
            {"columns", core::base64(std::as_bytes(std::span(packed)))}};
}

PackedImages packed_images(const std::vector<experiment::RunData>& runs,
                           const fs::path& page_folder,
                           std::size_t budget_bytes) {
    PackedImages packed;
    std::vector<std::string> of_run(runs.size());
    const std::vector<ViewPlace> places = view_places(runs);
    for (std::size_t at = 0; at < places.size(); at += kViewsAtOnce) {
        const std::size_t count = std::min(kViewsAtOnce, places.size() - at);
        std::array<PackedView, kViewsAtOnce> views;
        core::parallel_for(count, core::hardware_threads(), [&](std::size_t i) {
            const ViewPlace& place = places[at + i];
            const experiment::RunData& run = runs[place.run];
            const auto view = harness::read_shown_view(run.folder, place.rows);
            if (view) views[i] = packed_view(*view, run);
        });
        for (std::size_t i = 0; i < count; ++i) {
            auto& [head, images] = views[i];
            if (head.empty()) continue;
            const auto& [rank, run, rows] = places[at + i];
            const auto& [scene, view] = std::pair(rows.front().scene, rows.front().view);
            if (images.size() <= budget_bytes) {
                budget_bytes -= images.size();
            } else {
                const fs::path file =
                    runs[run].folder / harness::image_folder(scene, view) / "page.js";
                packed.beside[file] =
                    fmt::format("document.currentScript.images={{{}}};\n", images);
                images = fmt::format(R"("beside":{})",
                                     page_json(fs::relative(file, page_folder).generic_string()));
            }
            of_run[run] += fmt::format("{}{}:{{{},{}}}",
                                       of_run[run].empty() ? "" : ",",
                                       page_json(scene + "\n" + view),
                                       head,
                                       images);
        }
    }
    for (std::string& views : of_run)
        views = fmt::format("{{{}}}", views);
    packed.json = json_array(of_run);
    return packed;
}

}  // namespace ink::report
