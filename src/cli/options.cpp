#include "cli/options.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/error.h"
#include "harness/entrants.h"

namespace ink::cli {
namespace {

constexpr double kRadPerDeg = std::numbers::pi / 180;
constexpr double kMaxWeldEpsilon = 0.01;  // more would flatten the things themselves

template <class T>
bool parse_whole(std::string_view text, T& value) {
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc{} && end == text.data() + text.size();
}

void parse_size(const std::string& text, harness::ViewRequest& request) {
    const auto x = text.find('x');
    const bool is_pair = x != std::string::npos &&
                         parse_whole(std::string_view(text).substr(0, x), request.width_px) &&
                         parse_whole(std::string_view(text).substr(x + 1), request.height_px);
    if (!is_pair) {
        throw core::Error("--size",
                          fmt::format("'{}' is no size", text),
                          "WIDTHxHEIGHT in pixels, such as 1280x720");
    }
    harness::check_size(request.width_px, request.height_px);
}

glm::dvec3 parse_point(const std::string& text, const char* option) {
    const std::vector<std::string> parts = harness::split_list(text);
    glm::dvec3 point{0};
    bool is_point = parts.size() == 3;
    for (int i = 0; is_point && i < 3; ++i) {
        is_point = parse_whole<double>(parts[static_cast<std::size_t>(i)], point[i]) &&
                   std::isfinite(point[i]);
    }
    if (!is_point) {
        throw core::Error(option, fmt::format("'{}' is no point", text), "X,Y,Z");
    }
    return point;
}

void parse_cameras(const ViewOptions& options, harness::ViewRequest& request) {
    if (options.targets.size() > options.eyes.size()) {
        throw core::Error(
            "--target", "there are more targets than eyes", "one --eye for each --target");
    }
    for (std::size_t i = 0; i < options.eyes.size(); ++i) {
        harness::CameraRequest camera;
        camera.eye_world = parse_point(options.eyes[i], "--eye");
        if (i < options.targets.size()) {
            camera.target_world = parse_point(options.targets[i], "--target");
        }
        camera.up_world = parse_point(options.up, "--up");
        camera.fov_y_rad = options.fov_deg * kRadPerDeg;
        request.cameras.push_back(camera);
    }
}

}  // namespace

void add_set_option(CLI::App& command, std::vector<std::string>& settings, const char* doc) {
    command.add_option("--set", settings, doc)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

std::vector<std::string> scene_names(const std::string& scenes,
                                     const std::vector<std::string>& models) {
    std::vector<std::string> names = harness::split_list(scenes);
    names.insert(names.end(), models.begin(), models.end());
    return names;
}

void add_preset_option(CLI::App& command, std::vector<std::string>& presets, const char* role) {
    command
        .add_option("--preset",
                    presets,
                    fmt::format("A method with settings of its own, as inkbench tune writes it: a "
                                "TOML file, {}",
                                role))
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_view_options(CLI::App& command, ViewOptions& options) {
    command.add_option("--size", options.size, "Picture size in pixels, WIDTHxHEIGHT")
        ->capture_default_str();
    command.add_option(
        "--views", options.views, "N views round the scene, or 'file' for the model's own cameras");
    command
        .add_option("--eye", options.eyes, "Eye position X,Y,Z; may be given again for more views")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--target",
                    options.targets,
                    "Point looked at, X,Y,Z (the scene's centre unless given); one per --eye")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command.add_option("--up", options.up, "Up direction X,Y,Z")->capture_default_str();
    command.add_option("--fov", options.fov_deg, "Vertical field of view, degrees, with --eye")
        ->capture_default_str();
    command.add_option(
        "--time", options.time_s, "Seconds into an animated scene (unless said, as it rests)");
    command.add_option("--frame", options.frame, "A stored frame's number instead of --time");
}

harness::ViewRequest view_request(const ViewOptions& options) {
    harness::ViewRequest request;
    parse_size(options.size, request);
    parse_cameras(options, request);
    if (options.views == "file") {
        request.file_cameras = true;
    } else if (!options.views.empty()) {
        int count = 0;
        if (!parse_whole(options.views, count) || count < 1 || count > 360) {
            throw core::Error("--views",
                              fmt::format("'{}' is no number of views", options.views),
                              "1..360, or 'file'");
        }
        request.orbit_count = count;
    }
    if (options.time_s && options.frame) {
        throw core::Error("--time", "there is a --frame beside it", "one of the two");
    }
    request.time_s = options.time_s;
    request.frame = options.frame;
    return request;
}

int checked_threads(int threads) {
    if (threads < 1 || threads > 256) {
        throw core::Error(
            "--threads", fmt::format("{} threads are not possible", threads), "1..256");
    }
    return threads;
}

std::uint64_t parse_seed(const std::string& text) {
    std::uint64_t seed = 0;
    if (!parse_whole(text, seed)) {
        throw core::Error("--seed",
                          fmt::format("'{}' is no seed", text),
                          "a whole number 0..18446744073709551615");
    }
    return seed;
}

void add_truth_settings(CLI::App& command, TruthSettings& settings) {
    command.add_option("--crease", settings.crease_deg, "Crease angle of the truth, degrees")
        ->capture_default_str();
    command
        .add_option("--weld-epsilon",
                    settings.weld_epsilon,
                    "Weld vertices this near to each other, as a share of their part's diagonal "
                    "(0: at the same place only)")
        ->capture_default_str();
}

void apply(const TruthSettings& settings, truth::TruthOptions& options) {
    if (!(settings.crease_deg >= 0 && settings.crease_deg <= 180)) {
        throw core::Error(
            "--crease",
            fmt::format("the crease angle cannot be {:g} degrees", settings.crease_deg),
            "0..180");
    }
    if (!(settings.weld_epsilon >= 0 && settings.weld_epsilon <= kMaxWeldEpsilon)) {
        throw core::Error("--weld-epsilon",
                          fmt::format("it cannot be {:g}", settings.weld_epsilon),
                          fmt::format("0..{:g}", kMaxWeldEpsilon));
    }
    options.crease_rad = settings.crease_deg * kRadPerDeg;
    options.weld_epsilon = settings.weld_epsilon;
}

void add_cache_options(CLI::App& command, CacheOptions& options) {
    command.add_option("--cache", options.folder, "Folder of traced truths (~/.cache/inkbench)");
    command.add_flag("--no-cache", options.none, "Trace anew and keep nothing");
}

std::filesystem::path cache_folder(const CacheOptions& options) {
    if (options.none) return {};
    if (!options.folder.empty()) return options.folder;
    if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg != nullptr && *xdg != '\0') {
        return std::filesystem::path(xdg) / "inkbench";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / ".cache" / "inkbench";
    }
    return {};
}

void check_output_path(const std::filesystem::path& path,
                       const std::vector<std::string>& extensions) {
    if (std::find(extensions.begin(), extensions.end(), path.extension()) == extensions.end()) {
        throw core::Error(path.string(),
                          "this is not the name of such a file",
                          fmt::format("a name that ends in {}", fmt::join(extensions, " or ")));
    }
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (!std::filesystem::is_directory(folder)) {
        throw core::Error(
            path.string(), "its folder does not exist", "a file in an existing folder");
    }
    if (std::filesystem::is_directory(path) || access(folder.c_str(), W_OK) != 0) {
        throw core::Error(path.string(), "it cannot be written", "a file in a writable folder");
    }
}

}  // namespace ink::cli
