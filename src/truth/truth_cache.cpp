#include "truth/truth_cache.h"

#include <algorithm>
#include <limits>

#include "core/byte_stream.h"
#include "core/hash.h"
#include "core/kept_file.h"
#include "core/whole_file.h"
#include "truth/truth_sources.h"

namespace ink::truth {
namespace {

constexpr core::KeptKind kKind = {'i', 'n', 'k', 't', 'r', 'u', 't', '1'};

struct Size {
    std::int32_t width_px = 0, height_px = 0;
};

/// Pixels as runs of equal ones: ids and labels are mostly that.
template <class T>
void write_runs(core::ByteWriter& out, const core::Image<T>& image) {
    out.parts(Size{image.width_px(), image.height_px()});
    for (std::size_t i = 0; i < image.size();) {
        std::uint32_t run = 1;
        while (i + run < image.size() && image.data()[i + run] == image.data()[i])
            ++run;
        out.parts(run, image.data()[i]);
        i += run;
    }
}

/// The most pixels of an image that is read: as many as the program draws.
constexpr std::size_t kMostPixels = std::size_t{1} << 27;

/// Whether runs of T that cover `pixels` come next. `in` is a copy, which looks ahead: what is
/// claimed must not be allocated before it is known to be there.
template <class T>
bool has_runs(core::ByteReader in, std::size_t pixels) {
    while (pixels > 0) {
        const auto run = in.value<std::uint32_t>();
        (void)in.value<T>();
        if (!in.is_good() || run == 0 || run > pixels) return false;
        pixels -= run;
    }
    return true;
}

/// An image of `most_pixels` at most; empty where the reader fails.
template <class T>
core::Image<T> read_runs(core::ByteReader& in, std::size_t most_pixels) {
    const auto size = in.value<Size>();
    const bool is_size = size.width_px >= 0 && size.height_px >= 0;
    const std::size_t pixels =
        is_size ? static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px)
                : 0;
    if (!is_size || pixels > most_pixels || !has_runs<T>(in, pixels)) {
        in.fail();
        return {};
    }
    core::Image<T> image(size.width_px, size.height_px);
    for (std::size_t i = 0; i < pixels;) {
        const auto run = in.value<std::uint32_t>();
        std::fill_n(image.data() + i, run, in.value<T>());
        i += run;
    }
    return image;
}

/// Floats of the pixels that show a triangle; the sky has no need of any.
void write_seen(core::ByteWriter& out, const core::Image<float>& image, const Layers& layers) {
    std::vector<float> seen;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (layers.triangle.data()[i] != kNoTriangle) seen.push_back(image.data()[i]);
    }
    out.parts(seen);
}

core::Image<float> read_seen(core::ByteReader& in, const Layers& layers, float sky) {
    core::Image<float> image(layers.triangle.width_px(), layers.triangle.height_px(), sky);
    std::vector<float> seen;
    in.parts(seen);
    std::size_t next = 0;
    for (std::size_t i = 0; i < image.size() && in.is_good(); ++i) {
        if (layers.triangle.data()[i] == kNoTriangle) continue;
        if (next == seen.size()) in.fail();
        if (next < seen.size()) image.data()[i] = seen[next++];
    }
    return image;
}

template <class Stream, class Lines>
void pass_curves(Stream& of, Lines& curves) {
    constexpr std::size_t kCurveBytes = 3 + 6 * sizeof(std::uint32_t) + 2 * sizeof(CurvePoint);
    of.list(curves, kCurveBytes, [](Stream& stream, auto& curve) {
        stream.parts(curve.line_class,
                     curve.kind,
                     curve.empty_side,
                     curve.edge,
                     curve.face0,
                     curve.face1,
                     curve.deviation_rad,
                     curve.gap,
                     curve.view_angle_rad,
                     curve.begin,
                     curve.end);
    });
}

void write_payload(core::ByteWriter& out, const Truth& truth) {
    write_runs(out, truth.labels);
    write_runs(out, truth.below_crease);
    pass_curves(out, truth.curves);
    write_runs(out, truth.sampled);
    write_runs(out, truth.exact_corner);
    write_runs(out, truth.layers.triangle);
    write_runs(out, truth.layers.patch);
    write_seen(out, truth.layers.n_dot_v, truth.layers);
    write_seen(out, truth.layers.w, truth.layers);
    out.parts(truth.counts, truth.trace_s);
}

/// Whether every image has the size of the labels, those that a trace may leave out apart.
bool fits_together(const Truth& truth) {
    const auto is_like = [&](const auto& image) {
        return image.width_px() == truth.labels.width_px() &&
               image.height_px() == truth.labels.height_px();
    };
    const auto is_like_or_empty = [&](const auto& image) {
        return is_like(image) || image.is_empty();
    };
    return is_like(truth.below_crease) && is_like_or_empty(truth.sampled) &&
           is_like_or_empty(truth.exact_corner) && is_like_or_empty(truth.layers.triangle) &&
           truth.layers.patch.width_px() == truth.layers.triangle.width_px() &&
           truth.layers.patch.height_px() == truth.layers.triangle.height_px();
}

std::optional<Truth> read_payload(core::ByteReader& in) {
    Truth truth;
    truth.labels = read_runs<std::uint8_t>(in, kMostPixels);
    const std::size_t pixels = truth.labels.size();
    truth.below_crease = read_runs<std::uint8_t>(in, pixels);
    pass_curves(in, truth.curves);
    truth.sampled = read_runs<std::uint8_t>(in, pixels);
    truth.exact_corner = read_runs<std::uint8_t>(in, pixels);
    truth.layers.triangle = read_runs<std::uint32_t>(in, pixels);
    truth.layers.patch = read_runs<std::uint32_t>(in, pixels);
    truth.layers.n_dot_v = read_seen(in, truth.layers, 0);
    truth.layers.w = read_seen(in, truth.layers, std::numeric_limits<float>::infinity());
    in.parts(truth.counts, truth.trace_s);
    if (!in.is_at_end() || !fits_together(truth)) return std::nullopt;
    return truth;
}

namespace fs = std::filesystem;

std::optional<Truth> load(const fs::path& path, const std::string& key, const scene::View& view) {
    const auto bytes = core::read_whole_file(path);
    if (!bytes) return std::nullopt;
    auto truth = decode_truth(*bytes, key);
    const bool fits = truth && truth->labels.width_px() == view.width_px &&
                      truth->labels.height_px() == view.height_px;
    return fits ? std::move(truth) : std::nullopt;
}

}  // namespace

std::string encode_truth(const Truth& truth, const std::string& key) {
    return core::sealed(
        kKind, key, core::written_bytes([&](core::ByteWriter& out) { write_payload(out, truth); }));
}

std::optional<Truth> decode_truth(std::string_view bytes, const std::string& key) {
    const auto payload = core::unsealed(bytes, kKind, key);
    if (!payload) return std::nullopt;
    core::ByteReader in(*payload);
    return read_payload(in);
}

std::string truth_key(const scene::Scene& scene,
                      const scene::View& view,
                      const TruthOptions& options) {
    const scene::Camera& camera = view.camera;
    core::Hasher hasher;
    hasher.text(kSourcesHash).value(scene::scene_hash(scene));
    hasher.value(camera.eye_world).value(camera.view_from_world);
    hasher.value(camera.viewpoint().given_world);
    hasher.value(camera.fov_y_rad).value(camera.height_world).value(camera.near);
    hasher.value(view.width_px).value(view.height_px);
    hasher.value(options.crease_rad).value(options.creases).value(options.layers);
    hasher.value(options.weld_epsilon);
    return hasher.hex();
}

Truth cached_truth(SceneModel& scene,
                   const scene::View& view,
                   const std::filesystem::path& cache_dir) {
    const TruthOptions& options = scene.options();
    if (cache_dir.empty()) return trace_truth(scene.model(), view, options);
    const std::string key = truth_key(scene.scene(), view, options);
    const fs::path path = cache_dir / (key + ".truth");
    if (auto truth = load(path, key, view)) return std::move(*truth);
    Truth truth = trace_truth(scene.model(), view, options);
    core::keep_file(path, encode_truth(truth, key));
    return truth;
}

}  // namespace ink::truth
