#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands/commands.h"
#include "cli/json_values.h"
#include "cli/options/command_rows.h"
#include "cli/options/run_options.h"
#include "cli/shader_counts.h"
#include "cli/traced_view.h"
#include "core/error.h"
#include "core/scratch_folder.h"
#include "core/split_list.h"
#include "core/vocabulary.h"
#include "draw/drawing.h"
#include "draw/error_image.h"
#include "experiment/experiment_run.h"
#include "experiment/options/option_table.h"
#include "experiment/run_data.h"
#include "harness/clock/timing.h"
#include "harness/images/view_images.h"
#include "image_io/image_file.h"
#include "report/text/answer_text.h"
#include "summary/summary.h"
#include "summary/summary_csv.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using summary::MethodSummary;

/// Methods of the front of error and time, by what there must be in the frame: the mesh, or images
/// of its depth and normals.
constexpr const char* kOfMesh =
    "label8,surface8,surface8_depth,surface_lookup,id_lookup,edge_hash,ids,two_sums,mote4";
constexpr const char* kOfImages = "roberts,roberts_tuned,sobel,decaudin,plane_distance";
/// Of the mesh, where ink is asked for.
constexpr const char* kOfInk = "strokes,chords";

constexpr double kBandwidth_gb_s = 400;  ///< of a middling GPU of 2024
constexpr const char* kFolder = "inkbench-out/advise";

struct AdviseArgs : MeasureArgs {
    AdviseArgs() : MeasureArgs("advise", "") {
        experiment::Experiment& usual = options.usual();
        usual.crosscheck = false;
        usual.compare.full_scores = false;
        usual.budget_ms = harness::MeasureOptions{}.budget_s * 1e3;
        // Half of what compare allows: views that are not measured take the other half.
        usual.compare.answer.f_margin = summary::AnswerRule{}.f_margin / 2;
    }

    std::string have = "mesh";
    std::string picture;
    bool json = false;
};

std::string methods_for(const std::string& have, bool coverage) {
    const std::vector<std::string> words = core::split_list(have);
    const auto has = [&](const char* word) { return std::ranges::count(words, word) > 0; };
    const bool is_known = std::ranges::all_of(words, [](const std::string& word) {
        return word == "mesh" || word == "depth" || word == "normals";
    });
    const std::string of_mesh = std::string(kOfMesh) + (coverage ? std::string(",") + kOfInk : "");
    if (is_known && has("mesh")) return of_mesh + "," + kOfImages;
    if (is_known && has("depth") && has("normals")) return kOfImages;
    throw core::Error(
        "--have", fmt::format("no method draws from '{}' alone", have), "mesh, or depth,normals");
}

/// Gives the rows of crowded views the score in which crowded pixels count too.
void count_crowded(std::vector<harness::Row>& rows) {
    for (harness::Row& row : rows) {
        if (row.is_ok() || !row.with_crowded_2px) continue;
        row.status = "ok";
        row.k_2px = row.with_crowded_2px->k;
        row.n_pred = row.with_crowded_2px->n_pred;
        row.n_truth = row.with_crowded_2px->n_truth;
        row.f_2px = row.with_crowded_2px->f();
    }
}

struct Advice {
    experiment::Experiment asked;
    std::vector<harness::Row> rows;
    bool is_crowded = false;  ///< every view is: crowded pixels count
    bool is_beyond = false;   ///< none is within the budget: the answer is the fastest
    summary::Comparison comparison = {};
    summary::Answer answer = {};  ///< of these
    std::string picture = {};
    std::string next = {};

    [[nodiscard]] method::MethodConfig config() const {
        const auto configs = configs_of(asked);
        return *std::ranges::find_if(configs, [&](const method::MethodConfig& config) {
            return config.info->name == answer.method->method;
        });
    }
    /// What a frame moves between memory and the processor, if each of its pixels is covered once.
    [[nodiscard]] double bytes() const {
        const method::MethodConfig chosen = config();
        const method::Cost cost = chosen.info->make(chosen.settings)->cost();
        const method::PixelBytes bytes = cost.fill + cost.filter;
        const double px = 1.0 * asked.sizes[0].width_px * asked.sizes[0].height_px;
        return px * (bytes.read + bytes.written + cost.buffer_bytes_per_px);
    }
    [[nodiscard]] double bandwidth_ms() const { return bytes() / (kBandwidth_gb_s * 1e6); }
};

std::string ms_text(const MethodSummary& s) {
    return fmt::format("{} {:.3f} in {} ms",
                       report::measure_text(s.measure()),
                       *s.judged().all,
                       report::format_ms(s.draw_ms));
}

/// 0 of nothing.
double percent_without(std::int64_t part, std::int64_t whole) {
    return whole == 0 ? 0 : 100 * (1 - static_cast<double>(part) / static_cast<double>(whole));
}

/// Which class of lines most of what it misses is of; "" where it misses next to nothing.
std::string missing_text(const Advice& advice) {
    std::string text;
    double most_px = 0;
    for (const core::Term& line_class : core::vocabulary().classes) {
        const std::string name(line_class.name);
        double missing_px = 0;
        double all_px = 0;
        for (const harness::Row& row : advice.rows) {
            const auto found = row.by_class.find(name);
            if (row.method != advice.answer.method->method || found == row.by_class.end()) continue;
            all_px += static_cast<double>(found->second.n_truth);
            missing_px += static_cast<double>(found->second.n_truth - found->second.k);
        }
        if (missing_px <= most_px || missing_px < 0.0005 * all_px) continue;
        most_px = missing_px;
        text = ", most on " + name;
    }
    return text;
}

std::string as_text(const Advice& advice) {
    const MethodSummary& use = *advice.answer.method;
    const MethodSummary* other = advice.answer.other();
    const std::string alike = advice.is_beyond
                                  ? fmt::format("the fastest, as none takes at most {:g} ms",
                                                advice.asked.compare.answer.budget_ms)
                                  : report::times_text(advice.answer, report::Markup::none);
    const bool is_ink = use.measure() == summary::Measure::soft_f;
    const std::string shader = shader_text(use.method);
    const score::CurveCount of_model = use.judged().counts_of_scene.begin()->second;
    return fmt::format(
        "use        {}{}\n"
        "expect     {} on one thread here, over {} view{}{}: it misses {:.1f} % of the {}; "
        "{:.1f} % of what it draws is false: {}\n"
        "runner-up  {}\n"
        "moves      {:.1f} MB a frame of {}x{} if each pixel is covered once: {:.3f} ms at {:g} "
        "GB/s, an estimate for a GPU{}\n"
        "next       {}\n",
        use.method,
        alike.empty() ? "" : ": " + alike,
        ms_text(use),
        use.views,
        use.views == 1 ? "" : "s",
        advice.is_crowded ? ", with lines too dense to score" : "",
        percent_without(of_model.k, of_model.n_truth),
        is_ink ? "ink" : "lines" + missing_text(advice),
        percent_without(of_model.k, of_model.n_pred),
        advice.picture,
        other == nullptr ? "none" : fmt::format("{}: {}", other->method, ms_text(*other)),
        advice.bytes() / 1e6,
        advice.asked.sizes[0].width_px,
        advice.asked.sizes[0].height_px,
        advice.bandwidth_ms(),
        kBandwidth_gb_s,
        shader.empty() ? "" : "; its shader: " + shader,
        advice.next);
}

Json as_json(const Advice& advice) {
    const auto method_json = [](const MethodSummary* s) -> Json {
        if (s == nullptr) return nullptr;
        Json method = {{"method", s->method},
                       {"f_2px", or_null(s->f.all)},
                       {"precision_2px", or_null(s->precision)},
                       {"recall_2px", or_null(s->recall)},
                       {"recall_by_class", s->recall_by_class},
                       {"draw_ms", or_null(s->draw_ms)},
                       {"views", s->views}};
        if (s->soft_f.all) method["soft_f"] = *s->soft_f.all;
        return method;
    };
    Json as_cheap = Json::array();
    for (const MethodSummary* s : advice.answer.as_cheap)
        as_cheap.push_back(s->method);
    return {{"use", method_json(advice.answer.method)},
            {"within_budget", !advice.is_beyond},
            {"as_cheap", std::move(as_cheap)},
            {"runner_up", method_json(advice.answer.other())},
            {"measure", summary::name(advice.answer.method->measure())},
            {"counts_crowded", advice.is_crowded},
            {"picture", advice.picture},
            {"bytes_per_frame", advice.bytes()},
            {"bandwidth_gb_s", kBandwidth_gb_s},
            {"bandwidth_ms", advice.bandwidth_ms()},
            {"shader_instructions", shader_json(advice.answer.method->method)},
            {"next", advice.next}};
}

/// What is right and wrong of the method, in colour, on the first view that has a score.
void write_picture(const fs::path& cache, const Advice& advice) {
    const auto row = std::ranges::find_if(advice.rows, [&](const harness::Row& r) {
        return r.method == advice.answer.method->method && r.is_scored();
    });
    const TracedView traced(
        harness::load_one_view(advice.asked.scenes[0], row->view, views_of(advice.asked)),
        trace_of(advice.asked, cache));
    const method::MethodConfig config = advice.config();
    const draw::Drawing drawing = draw::make_drawing(traced.scene_views, config, {});
    draw::MarkOptions marks;
    marks.threshold = method::threshold_of(config);
    const auto labels =
        advice.is_crowded ? traced.truth.with_crowded->labels : traced.truth.counted_labels();
    const auto marked = draw::mark_errors(labels, drawing.edge_responses, marks);
    image_io::write_png(draw::error_image(marked), advice.picture);
}

/// The rows of every method on every view; the run lives in `folder`.
std::vector<harness::Row> measure(const experiment::Plan& plan, const fs::path& folder) {
    experiment::RunOptions options;
    options.out = folder;
    if (run_experiment(plan, options).is_interrupted) end_interrupted("nothing is written");
    return experiment::read_run(folder).tables.rows;
}

/// The comparison of the two methods, on more views unless views were asked for.
std::string next_command(const CLI::App& command, const Advice& advice, const std::string& out) {
    const summary::Answer& answer = advice.answer;
    std::string line = recorded_command(
        command, {"--have", "--out", "--json", advice.is_beyond ? "--budget-ms" : ""});
    line.replace(line.find("advise"), std::string("advise").size(), "compare");
    if (command.count("--views") + command.count("--eye") == 0) line += " --views 8";
    line += fmt::format(" --out {} --methods {}", out, answer.method->method);
    return answer.other() == nullptr ? line : line + "," + answer.other()->method;
}

void run_advise(AdviseArgs& args, const CLI::App& command) {
    args.methods = {methods_for(args.have, command.count("--coverage") > 0)};
    Advice advice{args.read(), {}};
    advice.asked.scenes = {one_scene(args.scenes, "advise")};
    if (!args.picture.empty()) check_output_path(args.picture, {".png"});
    const core::InterruptGuard guard("nothing is written");
    const core::ScratchFolder scratch("advise");
    fs::path cache = cache_folder(args.cache);
    if (cache.empty()) cache = scratch.path() / "truths";  // of which the picture needs one again
    advice.rows = measure(make_plan(advice.asked, cache), scratch.path() / "run");
    const auto unscored = summary::unscored_cells(advice.rows);
    advice.is_crowded = summary::is_all_unscored(advice.rows) &&
                        std::ranges::none_of(unscored, summary::is_failure);
    if (advice.is_crowded) count_crowded(advice.rows);
    advice.comparison = {advice.asked.compare.answer, summary::summarise(advice.rows)};
    advice.answer = advice.comparison.answer();
    if (advice.answer.method == nullptr && advice.answer.fastest != nullptr) {
        advice.is_beyond = true;
        advice.comparison.rule.budget_ms = *advice.answer.fastest->draw_ms;
        advice.answer = advice.comparison.answer();
    }
    if (advice.answer.method == nullptr) {
        fmt::print(
            stderr,
            "{}inkbench: {}\n",
            summary::unscored_text(unscored),
            report::answer_text(advice.rows, advice.comparison, report::Markup::none).whole());
        throw CLI::RuntimeError(1);
    }
    const std::string own = kFolder + ("/" + harness::file_name(advice.rows[0].scene));
    if (args.picture.empty()) fs::create_directories(kFolder);
    advice.picture = args.picture.empty() ? own + ".png" : args.picture;
    advice.next = next_command(command, advice, own);
    write_picture(cache, advice);
    fmt::print("{}", args.json ? as_json(advice).dump(2) + "\n" : as_text(advice));
    const std::string busy = harness::uncertain_times(advice.rows);
    if (!busy.empty()) fmt::print(stderr, "inkbench: {}\n", busy);
}

}  // namespace

void add_advise_command(CLI::App& app) {
    auto args = std::make_shared<AdviseArgs>();
    auto* command = app.add_subcommand(
        "advise", "Say in five lines which method to use for a model, by measuring on it");
    add_one_scene_options(*command, args->scenes);
    CommandRows rows(*command);
    // clang-format off
    rows.text("--have", args->have, "mesh|depth,normals",
              "What a frame has: the mesh, or no more than images of depth and normals");
    args->options.add_to(*command, {"answer.f_margin", "answer.budget_ms"});
    args->options.add_to(*command, {"measure.coverage", "measure.line_width_px"});
    args->options.add_to(*command, experiment::view_rows());
    args->options.add_to(*command, truth_rows());
    rows.text("-o,--out", args->picture, "FILE",
              "Picture of what it misses and what is false (default: MODEL.png in " +
                  std::string(kFolder) + ")");
    rows.flag("--json", args->json, "Print JSON instead of text");
    // clang-format on
    add_quiet_option(*command);
    add_cache_options(*command, args->cache);
    command->footer(
        "The answer is the cheapest method whose F is at most --f-margin below the best within "
        "--budget-ms; of those that take less than 1.3 times as long, the most exact. With "
        "--coverage methods that draw ink take part, and soft F decides.\n"
        "Example: inkbench advise bunny.obj --budget-ms 1 --size 1920x1080\n"
        "Beyond the budget it is the fastest.\n"
        "Exit codes: 0 done, 1 no method has a score, 2 bad input, 130 interrupted.");
    command->callback([args, command] { run_advise(*args, *command); });
}

}  // namespace ink::cli
