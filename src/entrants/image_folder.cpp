#include "entrants/image_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "harness/images/outline_image.h"
#include "harness/images/view_images.h"

namespace ink::entrants {
namespace {

namespace fs = std::filesystem;
using Times = std::map<std::pair<std::string, std::string>, std::int64_t>;

constexpr double kNsPerMs = 1e6;

/// Times by scene and view; none without the file.
Times read_times(const fs::path& file) {
    Times times;
    if (!fs::exists(file)) return times;
    const auto text = core::read_whole_file(file);
    if (!text) throw core::Error(file.string(), "it cannot be read", "times as CSV");
    const core::CsvTable table = core::split_csv(*text, file.string());
    const std::size_t scene = table.find("scene");
    const std::size_t view = table.find("view");
    const std::size_t draw_ms = table.find("draw_ms");
    if (std::max({scene, view, draw_ms}) == table.columns.size()) {
        throw core::Error(file.string(), "a column is missing", "scene, view and draw_ms");
    }
    for (std::size_t i = 0; i < table.records.size(); ++i) {
        const core::CsvField field(table, i, draw_ms);
        const auto ms = field.as<double>();
        if (!(ms >= 0 && ms < 1e9)) field.refuse("milliseconds, 0 or more");
        times[{core::unquoted(table.records[i][scene]), core::unquoted(table.records[i][view])}] =
            std::llround(ms * kNsPerMs);
    }
    return times;
}

}  // namespace

edge::EdgeImage read_entrant_image(const fs::path& path, const scene::View& view) {
    edge::EdgeImage image = harness::read_outline_image(path).responses;
    if (image.width_px() != view.width_px || image.height_px() != view.height_px) {
        throw core::Error(
            path.string(),
            fmt::format("its size is {} x {} px", image.width_px(), image.height_px()),
            fmt::format("{} x {} px, that of the view", view.width_px, view.height_px));
    }
    return image;
}

harness::OutsideSource image_folder_source(const fs::path& folder) {
    return [folder, times = read_times(folder / "times.csv")](const scene::Scene& scene,
                                                              const scene::View& view) {
        const fs::path path = folder / harness::file_name(scene.name) /
                              (harness::file_name(view.camera.name) + ".png");
        harness::OutsideImage drawn{read_entrant_image(path, view)};
        const auto time = times.find({scene.name, view.camera.name});
        if (time != times.end()) drawn.draw_ns = time->second;
        return drawn;
    };
}

std::string folder_hash(const fs::path& folder) {
    std::set<fs::path> files;
    std::error_code failure;
    for (auto entry = fs::recursive_directory_iterator(folder, failure);
         !failure && entry != fs::recursive_directory_iterator();
         entry.increment(failure)) {
        if (entry->is_regular_file()) files.insert(entry->path());
    }
    core::Hasher hasher;
    for (const fs::path& file : files)
        hasher.text(file.lexically_relative(folder).string())
            .text(core::read_whole_file(file).value_or(""));
    return hasher.hex();
}

std::string file_hash(const fs::path& file) {
    return core::Hasher().text(core::read_whole_file(file).value_or("")).hex();
}

}  // namespace ink::entrants
