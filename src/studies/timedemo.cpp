#include "studies/timedemo.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/hash.h"
#include "core/interrupt.h"
#include "core/progress.h"
#include "harness/cells/cell.h"
#include "harness/clock/timing.h"
#include "methods/antialias.h"
#include "raster/mesh/mesh_pass.h"
#include "scene/animation.h"
#include "scene/views/camera_path.h"
#include "shade/compose.h"
#include "shade/lay_ink.h"
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
    bool is_ink = methods::draws_ink(*config.info);
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

}  // namespace ink::studies
