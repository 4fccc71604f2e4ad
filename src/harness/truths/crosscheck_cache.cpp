#include "harness/truths/crosscheck_cache.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/byte_stream.h"
#include "core/kept_file.h"
#include "core/whole_file.h"
#include "truth/model.h"
#include "truth/truth_cache.h"

namespace ink::harness {
namespace {

constexpr core::KeptKind kKind = {'i', 'n', 'k', 'w', 'i', 't', 'n', '4'};

template <class Stream, class Check>
void pass(Stream& of, Check& check) {
    constexpr std::size_t kBytes = 3 * sizeof(double) + 3 + sizeof(std::size_t);
    of.parts(check.agreement.by_class, check.counts, check.look_s);
    of.list(check.agreement.disagreements, kBytes, [](Stream& stream, auto& d) {
        stream.parts(
            d.x_px, d.y_px, d.length_px, d.line_class, d.is_truth, d.curve, d.is_confirmed);
    });
}

Crosscheck look(truth::SceneModel& scene, const scene::View& view, const truth::Truth& truth) {
    const auto begin = std::chrono::steady_clock::now();
    crosscheck::SamplingOptions options;
    options.crease_rad = scene.options().crease_rad;
    options.creases = scene.options().creases;
    options.threads = scene.options().threads;
    const crosscheck::SampledLines crosscheck =
        crosscheck::sample_lines(scene.model().topology, view, options);
    Crosscheck check;
    check.agreement = compare_truths(truth.curves, crosscheck, view, options.threads);
    judge_disagreements(scene.model().topology, view, options, check.agreement);
    check.counts = crosscheck.counts;
    check.look_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return check;
}

}  // namespace

std::string encode_check(const Crosscheck& check, const std::string& key) {
    return core::sealed(
        kKind, key, core::written_bytes([&](core::ByteWriter& out) { pass(out, check); }));
}

std::optional<Crosscheck> decode_check(std::string_view bytes, const std::string& key) {
    const auto payload = core::unsealed(bytes, kKind, key);
    if (!payload) return std::nullopt;
    core::ByteReader in(*payload);
    Crosscheck check;
    pass(in, check);
    const auto& all = check.agreement.disagreements;
    const bool has_classes = std::ranges::all_of(
        all, [](const Disagreement& d) { return d.line_class <= truth::LineClass::ignore; });
    return in.is_at_end() && has_classes ? std::optional(std::move(check)) : std::nullopt;
}

Crosscheck cached_crosscheck(truth::SceneModel& scene,
                             const scene::View& view,
                             const truth::Truth& truth,
                             const std::filesystem::path& cache_dir) {
    if (cache_dir.empty()) return look(scene, view, truth);
    const std::string key = truth::truth_key(scene.scene(), view, scene.options());
    const std::filesystem::path path = cache_dir / (key + ".crosscheck");
    if (const auto bytes = core::read_whole_file(path)) {
        if (auto check = decode_check(*bytes, key)) return std::move(*check);
    }
    Crosscheck check = look(scene, view, truth);
    core::keep_file(path, encode_check(check, key));
    return check;
}

}  // namespace ink::harness
