#include "entrants/entrant.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/scratch_folder.h"
#include "core/tables/csv_table.h"
#include "core/whole_file.h"
#include "core/work_clock.h"
#include "entrants/view_files.h"
#include "harness/images/outline_image.h"
#include "harness/images/view_images.h"
#include "harness/rows/row.h"
#include "import/child_process.h"
#include "import/model_bytes.h"
#include "methods/registry.h"

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

constexpr double kCrease_rad = 40 * std::numbers::pi / 180;
constexpr int kThreads = 64;  ///< a program may keep so many busy for its whole time
constexpr std::uint64_t kMemoryBytes = 8ULL << 30;  ///< that each process may write to
constexpr std::uint64_t kOutputBytes = 1 << 20;
constexpr std::uint64_t kFileBytes = 1ULL << 30;
constexpr int kNotStarted = 127;  ///< exit code of a child that could not become the program

/// The last line that is not empty, cut to a length that fits a table.
std::string last_line(const std::string& text) {
    constexpr std::size_t kLongest = 200;
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    std::ranges::replace_if(
        last, [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
    return last.substr(0, kLongest);
}

/// The number behind the last "draw_ms" at the beginning of a line.
std::optional<double> reported_ms(const std::string& text) {
    constexpr std::string_view kKey = "draw_ms";
    std::istringstream lines(text);
    std::optional<double> found;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(kKey)) continue;
        const std::size_t begin = line.find_first_not_of(" =:", kKey.size());
        if (begin == std::string::npos) continue;
        double ms = 0;
        const auto [at, error] =
            std::from_chars(line.data() + begin, line.data() + line.size(), ms);
        if (error == std::errc() && std::isfinite(ms) && ms >= 0) found = ms;
    }
    return found;
}

/// Why a call failed, or "".
std::string failure_of(const import::ChildOutcome& outcome, double wall_s) {
    const std::string said = last_line(std::string(import::text_of(outcome.output)));
    const std::string quote = said.empty() ? "" : ": " + said;
    switch (outcome.end) {
        case import::ChildEnd::not_started:
            return fmt::format("it cannot be started: {}", std::strerror(outcome.code));
        case import::ChildEnd::timed_out:
            return fmt::format("it took longer than {} s and was ended{}", wall_s, quote);
        case import::ChildEnd::flooded:
            return "it printed more than 1 MiB and was ended";
        case import::ChildEnd::signalled:
            return fmt::format("it crashed (signal {}){}", outcome.code, quote);
        case import::ChildEnd::exited:
            break;
    }
    if (outcome.code == kNotStarted) return "it cannot be started" + quote;
    if (outcome.code != 0) return fmt::format("it ended with exit code {}{}", outcome.code, quote);
    return "";
}

/// One scene's files, and the calls for its views.
class ProgramRunner {
  public:
    ProgramRunner(fs::path program, double wall_s)
        : program_(std::move(program)), wall_s_(wall_s) {}

    harness::OutsideImage draw(const scene::Scene& scene, const scene::View& view) {
        const std::uint64_t hash = scene::scene_hash(scene);
        if (!meshes_ || hash != scene_hash_) {
            meshes_ = write_meshes(scene, {}, scratch_.path() / "scene");
            scene_hash_ = hash;
        }
        const fs::path folder = scratch_.path() / "scene" / "view";
        write_view(scene, view, *meshes_, kCrease_rad, folder);
        const fs::path asked = folder / "camera.json";
        const fs::path image = folder / "out.png";
        std::error_code ignored;
        fs::remove(image, ignored);

        import::ChildOutcome outcome;
        core::Spent process = core::spent_on([&] {
            outcome = import::run_child(program_,
                                        {asked.string(), image.string()},
                                        {.wall_s = wall_s_,
                                         .memory_bytes = kMemoryBytes,
                                         .counts_reserved = false,  // a browser reserves a terabyte
                                         .output_bytes = kOutputBytes,
                                         .file_bytes = kFileBytes,
                                         .keeps_errors = true,
                                         .threads = kThreads,
                                         .leads_group = true});
        });
        process.cpu_ns = outcome.cpu_ns;
        const std::string failure = failure_of(outcome, wall_s_);
        if (!failure.empty()) throw core::Error(program_.string(), failure);
        if (!fs::exists(image))
            throw core::Error(
                program_.string(), "it wrote no image", "an image at its second argument");
        harness::OutsideImage drawn{image_of(image, view)};
        const auto ms = reported_ms(std::string(import::text_of(outcome.output)));
        if (ms) drawn.draw_ns = std::llround(*ms * kNsPerMs);
        drawn.process = process;
        return drawn;
    }

  private:
    /// The image that it wrote; what is wrong with it is told as the program's fault.
    [[nodiscard]] edge::EdgeImage image_of(const fs::path& image, const scene::View& view) const {
        try {
            return read_entrant_image(image, view);
        } catch (const core::Error& error) {
            throw core::Error(
                program_.string(), "of its image: " + error.what_happened(), error.accepted());
        }
    }

    fs::path program_;
    double wall_s_;
    core::ScratchFolder scratch_{"entrant"};
    std::optional<ViewFiles> meshes_;
    std::uint64_t scene_hash_ = 0;
};

/// Images that `program` draws, called as `program view.json out.png` in a folder of its own under
/// the system's temporary folder, removed with the source.
///
/// The source throws core::Error (where = the program) that says how a call failed: it could not be
/// started, hung, crashed, ended with an exit code and what it last said, wrote no image or a wrong
/// one.
harness::OutsideSource program_source(const fs::path& program, double wall_s) {
    // Made with the first view: a configuration that is only asked for its name leaves no folder.
    auto runner = std::make_shared<std::unique_ptr<ProgramRunner>>();
    return [runner, program = fs::absolute(program).lexically_normal(), wall_s](
               const scene::Scene& scene, const scene::View& view) {
        if (!*runner) *runner = std::make_unique<ProgramRunner>(program, wall_s);
        return (*runner)->draw(scene, view);
    };
}

constexpr const char* kWhere = "--entrant";
constexpr const char* kAccepted = "NAME=FOLDER of images, or NAME=PROGRAM";

void check_entrant_name(const std::string& name, const std::string& text) {
    const bool is_word = !name.empty() && std::ranges::all_of(name, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    });
    if (!is_word) {
        throw core::Error(
            kWhere, fmt::format("'{}' has no name", text), "letters, digits, _ and - before the =");
    }
    const auto& methods = methods::registry();
    const bool is_taken =
        harness::is_baseline(name) ||
        std::ranges::any_of(methods, [&](const auto& info) { return info.name == name; });
    if (is_taken) {
        throw core::Error(
            kWhere, fmt::format("there is a method '{}' already", name), "a name of its own");
    }
}

/// The parameters of every entrant.
struct EntrantParams {
    int threshold = 128;
};

core::ParamTable<EntrantParams> entrant_table() {
    core::ParamTable<EntrantParams> table;
    return table.number(&EntrantParams::threshold,
                        "threshold",
                        {1, 255},
                        "",
                        "Least edge response of a line pixel.");
}

/// A hash of all files in a folder, names and bytes.
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

/// A hash of a file's bytes; that of nothing if it cannot be read.
std::string file_hash(const fs::path& file) {
    return core::Hasher().text(core::read_whole_file(file).value_or("")).hex();
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

Entrant parse_entrant(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
        throw core::Error(kWhere, fmt::format("'{}' is no entrant", text), kAccepted);
    Entrant entrant{text.substr(0, equals), text.substr(equals + 1)};
    check_entrant_name(entrant.name, text);
    std::error_code error;
    if (fs::is_directory(entrant.path, error)) return entrant;
    entrant.is_program = true;
    if (!fs::is_regular_file(entrant.path, error)) {
        throw core::Error(kWhere,
                          fmt::format("there is no folder or program '{}'", entrant.path.string()),
                          kAccepted);
    }
    if (access(entrant.path.c_str(), X_OK) != 0) {
        throw core::Error(kWhere,
                          fmt::format("'{}' cannot be executed", entrant.path.string()),
                          "a program with its x bit set (chmod +x)");
    }
    return entrant;
}

method::MethodConfig entrant_config(const Entrant& entrant, double wall_s) {
    const auto make_source = [entrant, wall_s] {
        return entrant.is_program ? program_source(entrant.path, wall_s)
                                  : image_folder_source(entrant.path);
    };
    return outside_config(
        entrant.name,
        entrant.path.string(),
        entrant.is_program ? "a program from outside" : "images from outside",
        make_source,
        {{"entrant", entrant.path.string()},
         {"content", entrant.is_program ? file_hash(entrant.path) : folder_hash(entrant.path)}});
}

method::MethodConfig outside_config(const std::string& name,
                                    const std::string& origin,
                                    const std::string& summary,
                                    const std::function<harness::OutsideSource()>& make_source,
                                    const core::ParamValues& facts) {
    check_entrant_name(name, name);
    auto info = std::make_shared<method::MethodInfo>();
    info->name = name;
    info->source = fmt::format("outside: {}", origin);
    info->summary = summary;
    info->params = entrant_table().params();
    info->family = method::Family::other;
    info->marker = method::Marker::cross;
    info->make = [name, make_source](const core::ParamValues& values) {
        (void)entrant_table().read(values, name);
        return std::make_unique<harness::OutsideMethod>(make_source());
    };
    info->complete = [name, facts](const core::ParamValues& values) {
        core::ParamValues all = entrant_table().complete(values, name);
        all.insert(facts.begin(), facts.end());
        return all;
    };
    return {info.get(), {}, info, true};
}

}  // namespace ink::entrants
