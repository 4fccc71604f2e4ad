#include "studies/timedemo.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "core/tables/table_of.h"
#include "core/text_table.h"
#include "core/whole_file.h"
#include "harness/cells/cell.h"
#include "harness/clock/timing.h"
#include "raster/mesh/mesh_pass.h"
#include "scene/animation.h"
#include "scene/views/camera_path.h"
#include "shade/compose.h"
#include "shade/shading.h"

namespace ink::studies {
namespace {

constexpr double kStep_px = 3;  // a frame: fast enough to see, slow enough for 60 frames

/// The model in one tone: what a frame costs before anybody draws lines or light.
class PlainFill : public raster::TileSink {
  public:
    void pose(const scene::Scene& scene) {
        auto moved = std::make_unique<scene::Surface>(scene::flatten(scene));
        const bool is_same = surface_ && moved->triangles == surface_->triangles &&
                             moved->p_world.size() == surface_->p_world.size();
        if (is_same) mesh_.update(*moved);
        if (!is_same) mesh_ = raster::LaneMesh(*moved);
        surface_ = std::move(moved);
        bounds_ = scene::bounding_sphere(scene);
    }
    void draw(const scene::View& view, int threads) {
        if (surface_->triangles.empty()) return;
        image_ = core::Image<std::uint8_t>(view.width_px, view.height_px, 0);
        raster::MeshInput input;
        input.mesh = &mesh_;
        input.view = view;
        input.bounds = bounds_;
        input.threads = threads;
        (void)pass_.draw({}, input, *this);
    }
    void finish(const raster::Tile& tile) override {
        if (tile.is_empty) return;
        for (int y = 0; y < tile.height_px; ++y) {
            const auto* depth = tile.depth_row<float>(y);
            std::uint8_t* to = image_.row(tile.y0_px + y) + tile.x0_px;
            for (int x = 0; x < tile.width_px; ++x)
                to[x] = depth[x] > 0 ? 255 : 0;
        }
    }

  private:
    std::unique_ptr<scene::Surface> surface_;
    raster::LaneMesh mesh_;
    raster::MeshPass pass_;
    scene::Sphere bounds_;
    core::Image<std::uint8_t> image_;
};

/// One shading of every frame.
class Shaded {
  public:
    explicit Shaded(const shade::Style& style) : shader_(style) {}
    /// Returns what it took; poses the scene first if it `is_moved`.
    std::int64_t draw(const scene::Scene& scene,
                      bool is_moved,
                      const scene::View& view,
                      const TimedemoOptions& options) {
        const auto shade = [&] {
            if (is_moved) shader_.prepare(scene);
            image_ = shader_.draw({view, {}, 1, options.threads});
        };
        return harness::time_ns(shade, options.threads);
    }
    [[nodiscard]] const core::Image<shade::Rgb>& image() const { return image_; }

  private:
    shade::Shader shader_;
    core::Image<shade::Rgb> image_;
};

/// A method under way along one path.
struct Player {
    method::MethodConfig config;
    int threshold = method::threshold_of(config);
    bool is_ink = config.info->draws_ink;
    std::unique_ptr<method::Method> method = config.info->make(config.settings);
    edge::EdgeImage edge_responses = {};
    std::vector<std::string> hashes = {};  ///< of its frames, as first drawn
};

/// Stored frames are shown whole, as games of their time showed them; keys at even steps.
double demo_time_s(const scene::Scene& scene, int frame, int frames) {
    if (!scene.animation) return 0;
    const std::size_t stored = scene.animation->frame_count();
    if (stored == 0) return scene.animation->duration_s * frame / frames;
    return scene.animation->frame_time_s(stored * static_cast<std::size_t>(frame) /
                                         static_cast<std::size_t>(frames));
}

/// A ball that holds the scene in all the poses that are drawn.
scene::Sphere bounds_of_demo(const scene::Scene& scene, int frames) {
    std::vector<double> times_s;
    for (int f = 0; f < frames && scene.animation; ++f)
        times_s.push_back(demo_time_s(scene, f, frames));
    return scene::bounds_of_poses(scene, times_s);
}

/// Which of the scene's cameras a view is, if the animation moves that one.
std::optional<std::size_t> moving_camera(const scene::Scene& scene, const scene::View& view) {
    const std::size_t count = scene.animation ? scene.animation->node_of_camera.size() : 0;
    for (std::size_t c = 0; c < count; ++c) {
        const bool is_it = scene.cameras[c].name == view.camera.name &&
                           scene.cameras[c].eye_world == view.camera.eye_world;
        if (is_it && scene.animation->node_of_camera[c] != scene::kNoNode) return c;
    }
    return std::nullopt;
}

/// How the camera moves: along a path, or as that of the scene's own does.
struct DemoPath {
    scene::CameraPath path;
    std::optional<std::size_t> camera = {};

    [[nodiscard]] std::string name() const {
        return std::string(camera ? "own" : scene::name(path.kind));
    }
};

/// The camera's own way, if it has one, then three paths from the view; who stands inside the scene
/// looks about instead of going round it.
std::vector<DemoPath> demo_paths(const scene::Scene& scene,
                                 const scene::View& start,
                                 const TimedemoOptions& options) {
    using enum scene::PathKind;
    const scene::Sphere bounds = bounds_of_demo(scene, options.frames);
    const glm::dvec3 away = start.camera.eye_world - bounds.center_world;
    const bool is_outside = glm::length(away) > 1.01 * bounds.radius &&
                            glm::length(glm::dvec2(away.x, away.z)) > 0.01 * bounds.radius;
    std::vector<DemoPath> paths;
    if (const auto camera = moving_camera(scene, start))
        paths.push_back({scene::make_path(still, start, bounds, 0), camera});
    for (const scene::PathKind kind :
         {is_outside ? orbit : pan, is_outside ? dolly : roll, shake}) {
        paths.push_back({scene::make_path(kind, start, bounds, kStep_px)});
        paths.back().path.frame_count = options.frames;
        paths.back().path.seed = options.seed;
    }
    return paths;
}

/// One path with all methods in turns.
class Demo {
  public:
    Demo(const scene::Scene& scene,
         const DemoPath& path,
         const TimedemoOptions& options,
         core::Progress& progress)
        : scene_(scene), path_(path), options_(options), progress_(progress) {
        for (const method::MethodConfig& config : options.configs) {
            players_.push_back({config});
            players_.back().edge_responses =
                edge::EdgeImage(path.path.start.width_px, path.path.start.height_px);
        }
    }

    /// `done` frames, of this path and those before, are counted on.
    void play(std::vector<DemoFrame>& out, int& done) {
        for (int pass = 0; pass <= options_.cached_passes; ++pass) {
            for (int f = 0; f < options_.frames && !core::is_interrupted(); ++f) {
                progress_.report(done++, fmt::format("{}, frame {}", path_.name(), f));
                play_frame(pass, f, out);
            }
        }
    }

  private:
    template <class Work>
    [[nodiscard]] std::int64_t time_ns(Work work) const {
        return harness::time_ns(work, options_.threads);
    }

    /// What is seen in a frame, the scene being posed.
    [[nodiscard]] scene::View view_of(int f) const {
        if (!path_.camera) return scene::frame_at(path_.path, f).view;
        scene::View view = path_.path.start;
        view.camera = scene_.cameras[*path_.camera];
        scene::fit_clip_range(view.camera, path_.path.bounds);
        return view;
    }

    void play_frame(int pass, int f, std::vector<DemoFrame>& out) {
        DemoFrame line;
        line.path = path_.name();
        line.pass = pass;
        line.frame = f;
        line.time_s = demo_time_s(scene_, f, options_.frames);
        scene::pose_scene(scene_, line.time_s);
        const scene::View view = view_of(f);
        const bool is_moved = scene_.animation || is_new_;
        line.fill_ns = time_ns([&] {
            if (is_moved) fill_.pose(scene_);
            fill_.draw(view, options_.threads);
        });
        line.shade_ns = plain_.draw(scene_, is_moved, view, options_);
        line.toon_ns = toon_.draw(scene_, is_moved, view, options_);
        for (Player& player : players_) {
            draw(player, view, line);
            out.push_back(line);
        }
        is_new_ = false;
    }

    void draw(Player& player, const scene::View& view, DemoFrame& line) {
        method::Method& method = *player.method;
        line.method = player.config.info->name;
        line.pose_ns = time_ns([&] {
            if (is_new_) method.prepare(scene_);
            if (scene_.animation || is_new_) method.pose(scene_);
        });
        line.draw_ns = time_ns([&] {
            method.draw({view, options_.threads, options_.skips}, player.edge_responses);
        });
        line.compose_ns = time_ns([&] {
            constexpr shade::Rgb kBlack{0, 0, 0};
            const edge::EdgeImage& lines = player.edge_responses;
            image_ = player.is_ink
                         ? shade::lay_ink(lines, plain_.image(), kBlack)
                         : shade::compose(lines, plain_.image(), {kBlack, player.threshold});
        });
        line.image_hash = core::image_hash(player.edge_responses);
        if (line.pass == 0) player.hashes.push_back(line.image_hash);
        if (player.hashes[static_cast<std::size_t>(line.frame)] != line.image_hash) {
            throw core::Error(line.method,
                              fmt::format("frame {} of the {} path came out otherwise in pass {}",
                                          line.frame,
                                          line.path,
                                          line.pass));
        }
    }

    scene::Scene scene_;
    const DemoPath& path_;
    const TimedemoOptions& options_;
    core::Progress& progress_;
    std::vector<Player> players_;
    PlainFill fill_;
    Shaded plain_{shade::GouraudParams{}};
    Shaded toon_{shade::ToonParams{}};
    core::Image<shade::Rgb> image_;
    bool is_new_ = true;
};

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

std::vector<DemoFrame> run_timedemo(const harness::SceneViews& scene_views,
                                    const TimedemoOptions& options) {
    const std::vector<DemoPath> paths =
        demo_paths(scene_views.scene, scene_views.views.front(), options);
    core::Progress progress(
        "timedemo", static_cast<int>(paths.size()) * (options.cached_passes + 1) * options.frames);
    std::vector<DemoFrame> frames;
    int done = 0;
    for (const DemoPath& path : paths)
        Demo(scene_views.scene, path, options, progress).play(frames, done);
    if (core::is_interrupted()) return {};
    return frames;
}

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

void write_timedemo(const harness::SceneViews& scene_views,
                    const std::vector<DemoFrame>& frames,
                    const std::filesystem::path& path) {
    std::vector<FrameLine> lines;
    for (const DemoFrame& frame : frames)
        lines.push_back({scene_views, frame});
    core::write_whole_file(path, frames_table().file(lines));
}

}  // namespace ink::studies
