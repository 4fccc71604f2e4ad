#include "harness/crosscheck/crosscheck_cache.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "core/whole_file.h"
#include "truth/model.h"
#include "truth/truth_cache.h"

namespace ink::harness {
namespace {

constexpr std::string_view kMagic = "inkwitn2";

/// Everything in a check is a number that a double holds exactly; so is the file.
void add_numbers(const Crosscheck& check, std::vector<double>& numbers) {
    for (const ClassAgreement& c : check.agreement.by_class)
        numbers.insert(numbers.end(),
                       {c.truth_px,
                        c.truth_covered_px,
                        c.crosscheck_px,
                        c.crosscheck_covered_px,
                        c.truth_abstained_px,
                        c.crosscheck_abstained_px});
    const crosscheck::SamplingCounts& n = check.counts;
    for (const std::size_t count :
         {n.rays, n.refined_px, n.probes, n.defects, n.near_cuts, n.unexplained})
        numbers.push_back(static_cast<double>(count));
    numbers.push_back(check.look_s);
    for (const Disagreement& d : check.agreement.disagreements) {
        numbers.insert(numbers.end(),
                       {d.x_px,
                        d.y_px,
                        d.length_px,
                        static_cast<double>(d.line_class),
                        d.is_truth ? 1.0 : 0.0,
                        static_cast<double>(d.curve),
                        d.is_confirmed ? 1.0 : 0.0});
    }
}

constexpr std::size_t kClassNumbers = 6;
constexpr std::size_t kFixedNumbers = kClassNumbers * truth::kLineClasses.size() + 7;
constexpr std::size_t kDisagreementNumbers = 7;

/// Takes a number into one of another kind that holds it exactly; false if it does not.
template <class T>
bool take(double number, double most, T& to) {
    const bool is_good = number >= 0 && number <= most && number == std::floor(number);
    if (is_good) to = static_cast<T>(number);
    return is_good;
}

/// Nothing if a number is none of its kind.
std::optional<Crosscheck> check_of(const std::vector<double>& numbers) {
    constexpr double kMostCounted = 0x1p53;
    constexpr auto kLastClass = static_cast<double>(truth::LineClass::ignore);
    const double* next = numbers.data();
    Crosscheck check;
    bool is_good = true;
    for (ClassAgreement& c : check.agreement.by_class) {
        c = {next[0], next[1], next[2], next[3], next[4], next[5]};
        next += kClassNumbers;
    }
    crosscheck::SamplingCounts& n = check.counts;
    for (std::size_t* count :
         {&n.rays, &n.refined_px, &n.probes, &n.defects, &n.near_cuts, &n.unexplained})
        is_good = take(*next++, kMostCounted, *count) && is_good;
    check.look_s = *next++;
    for (; next != numbers.data() + numbers.size(); next += kDisagreementNumbers) {
        Disagreement& d = check.agreement.disagreements.emplace_back();
        d.x_px = next[0];
        d.y_px = next[1];
        d.length_px = next[2];
        is_good = take(next[3], kLastClass, d.line_class) && is_good;
        is_good = take(next[4], 1, d.is_truth) && is_good;
        is_good = take(next[5], kMostCounted, d.curve) && is_good;
        is_good = take(next[6], 1, d.is_confirmed) && is_good;
    }
    return is_good ? std::optional(std::move(check)) : std::nullopt;
}

std::string hash_of(std::string_view bytes) {
    return core::Hasher().bytes(bytes.data(), bytes.size()).hex();
}

Crosscheck look(truth::SceneModel& scene, const scene::View& view, const truth::Truth& truth) {
    const auto begin = std::chrono::steady_clock::now();
    crosscheck::SamplingOptions options;
    options.crease_rad = scene.options().crease_rad;
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
    std::vector<double> numbers;
    add_numbers(check, numbers);
    const std::string payload(reinterpret_cast<const char*>(numbers.data()),
                              numbers.size() * sizeof(double));
    return std::string(kMagic) + key + hash_of(payload) + payload;
}

std::optional<Crosscheck> decode_check(const std::string& bytes, const std::string& key) {
    const std::string head = std::string(kMagic) + key;
    const std::size_t hash_size = hash_of("").size();
    if (bytes.size() < head.size() + hash_size || bytes.compare(0, head.size(), head) != 0)
        return std::nullopt;
    const std::string payload = bytes.substr(head.size() + hash_size);
    if (bytes.compare(head.size(), hash_size, hash_of(payload)) != 0) return std::nullopt;
    const std::size_t count = payload.size() / sizeof(double);
    const bool is_whole = payload.size() % sizeof(double) == 0 && count >= kFixedNumbers &&
                          (count - kFixedNumbers) % kDisagreementNumbers == 0;
    if (!is_whole) return std::nullopt;
    std::vector<double> numbers(count);
    std::memcpy(numbers.data(), payload.data(), payload.size());
    return check_of(numbers);
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
    try {
        core::write_whole_file(path, encode_check(check, key));
    } catch (const core::Error&) {
        // What cannot be kept is looked at again the next time: that costs time, nothing else.
    }
    return check;
}

}  // namespace ink::harness
