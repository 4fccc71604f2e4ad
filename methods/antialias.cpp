#include "methods/antialias.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <utility>

#include "core/error.h"
#include "edge/set_pixels.h"
#include "shade/compose.h"

namespace ink::methods {
namespace {

/// By how many samples a line is wider than the pen that follows its samples, for these lie up to
/// half a sample beside it. Measured: true lines (id_lookup) come out 0.58 to 0.84 wider, with pens
/// of 2 to 6 samples on torus, chess, gear and hand at 1280x720.
constexpr double kBeyondPen = 0.75;

/// How the samples of a method become grey lines.
struct Resolve {
    int samples = 1;    ///< on a pixel's side
    int threshold = 1;  ///< of a sample's edge response
    int pen = 1;        ///< samples: the diameter of the pen that follows those that are drawn
};

/// Adds each sample that is drawn to the count of its pixel, `shift` samples further right and
/// down.
void count_drawn(const edge::EdgeImage& lines,
                 int n,
                 int shift,
                 core::Image<std::uint16_t>& counts) {
    for (int y = 0; y + shift < lines.height_px(); ++y) {
        std::uint16_t* of_row = counts.row((y + shift) / n);
        edge::visit_set_pixels(lines.row(y), lines.width_px(), [&](int x) {
            if (x + shift < lines.width_px()) ++of_row[(x + shift) / n];
        });
    }
}

/// The share of each pixel that a round pen covers, of 255, whose middle follows the samples that
/// are not 0.
edge::EdgeImage grey_lines(const edge::EdgeImage& samples, const Resolve& resolve) {
    const int n = resolve.samples;
    const edge::EdgeImage lines = shade::widen(samples, resolve.pen);
    core::Image<std::uint16_t> counts(lines.width_px() / n, lines.height_px() / n);
    // An even pen lies half a sample up and left: it and one half a sample down and right count
    // half.
    const int shifts = resolve.pen % 2 == 0 ? 2 : 1;
    for (int shift = 0; shift < shifts; ++shift)
        count_drawn(lines, n, shift, counts);
    const int all = n * n * shifts;
    return core::mapped<std::uint8_t>(counts,
                                      [=](int count) { return (255 * count + all / 2) / all; });
}

/// A method that draws samples.
class GreyMethod : public method::Method {
  public:
    GreyMethod(std::unique_ptr<method::Method> base, const Resolve& resolve)
        : base_(std::move(base)), resolve_(resolve) {}

    void prepare(const scene::PreparedScene& scene) override { base_->prepare(scene); }
    void pose(const scene::PreparedScene& scene) override { base_->pose(scene); }
    void draw(const method::Frame& frame, edge::EdgeImage& out) override {
        const scene::View view = enlarged(frame.view, resolve_.samples);
        if (samples_.width_px() != view.width_px || samples_.height_px() != view.height_px)
            samples_ = edge::EdgeImage(view.width_px, view.height_px);
        base_->draw({view, frame.threads, frame.skips}, samples_);
        std::transform(samples_.data(),
                       samples_.data() + samples_.size(),
                       samples_.data(),
                       [least = resolve_.threshold](int response) {
                           return static_cast<std::uint8_t>(response >= least ? 255 : 0);
                       });
        out = grey_lines(samples_, resolve_);
    }
    [[nodiscard]] int bytes_per_px() const override {
        return base_->bytes_per_px() * resolve_.samples * resolve_.samples;
    }
    [[nodiscard]] raster::SkipCounts skip_counts() const override { return base_->skip_counts(); }
    [[nodiscard]] std::vector<method::PlanLine> plan() const override { return base_->plan(); }

  private:
    std::unique_ptr<method::Method> base_;
    Resolve resolve_;
    edge::EdgeImage samples_;
};

bool is_line_width(const core::Param& param) {
    return param.name.starts_with("width") && param.unit == "px";
}

/// The settings of a method that draws its lines n samples a pixel wide.
core::ParamValues in_samples(const method::MethodConfig& config, int n, double line_width_px) {
    core::ParamValues settings = config.settings;
    for (const core::Param& param : config.info->params) {
        if (!is_line_width(param)) continue;
        const auto own = settings.find(param.name);
        const double width_px = own == settings.end()
                                    ? line_width_px
                                    : core::parse_param(param, own->second, config.info->name);
        settings[param.name] =
            core::format_param(param, std::clamp(width_px * n, param.min, param.max));
    }
    return settings;
}

/// What alone is set of a method of grey lines.
struct GreyParams {
    int threshold = kGreyThreshold;
};

core::ParamTable<GreyParams> grey_table() {
    core::ParamTable<GreyParams> table;
    method::add_threshold(table, "Least share of a line pixel, of 255.");
    return table;
}

}  // namespace

std::vector<Antialias> parse_antialias(const std::vector<core::GivenText>& names) {
    const auto& known = kAntialiasNames;
    std::vector<Antialias> choices;
    for (const core::GivenText& name : names) {
        const auto at = std::find(known.begin(), known.end(), name.text) - known.begin();
        const auto choice = static_cast<Antialias>(at);
        const bool is_known = at < std::ssize(known);
        if (!is_known || std::find(choices.begin(), choices.end(), choice) != choices.end()) {
            throw core::Error(name.where,
                              is_known ? fmt::format("'{}' is named twice", name.text)
                                       : fmt::format("there is no antialias '{}'", name.text),
                              fmt::format("{}, each once", fmt::join(known, ", ")));
        }
        choices.push_back(choice);
    }
    return choices;
}

int samples_per_side(Antialias antialias) {
    return 1 << static_cast<int>(antialias);
}

scene::View enlarged(scene::View view, int n) {
    const std::int64_t width = std::int64_t{view.width_px} * n;
    const std::int64_t height = std::int64_t{view.height_px} * n;
    if (width > 16384 || height > 16384 || width * height > (std::int64_t{1} << 27)) {
        throw core::Error(
            "--antialias",
            fmt::format("{} times {}x{} is too large", n, view.width_px, view.height_px),
            "at most 16384 a side and 2^27 pixels in all");
    }
    view.width_px = static_cast<int>(width);
    view.height_px = static_cast<int>(height);
    return view;
}

method::MethodConfig antialiased(const method::MethodConfig& config,
                                 Antialias antialias,
                                 double line_width_px) {
    const bool is_ink = config.info->draws_ink;
    if (antialias == Antialias::none || is_ink) {
        method::MethodConfig own = config;
        own.is_grey = is_ink;
        return own;
    }
    const std::string_view word = kAntialiasNames[static_cast<std::size_t>(antialias)];
    const auto& params = config.info->params;
    const int n = samples_per_side(antialias);
    const bool has_width = std::any_of(params.begin(), params.end(), is_line_width);
    const int pen = std::max(1, static_cast<int>(std::lround(line_width_px * n - kBeyondPen)));
    const Resolve resolve{n, method::threshold_of(config), has_width ? 1 : pen};
    const method::MethodConfig base = method::with(config, in_samples(config, n, line_width_px));

    auto info = std::make_shared<method::MethodInfo>(*config.info);
    info->name = fmt::format("{}_{}", config.info->name, word);
    info->summary = fmt::format(
        "{} with {} samples a pixel: {}", config.info->name, n * n, config.info->summary);
    info->params = grey_table().params();
    info->tunables = {};
    info->sum_limits = {};
    info->sweep = {};
    info->preset_of = config.info->name;
    info->make = [base, resolve, name = info->name](const core::ParamValues& values) {
        (void)grey_table().read(values, name);
        return std::make_unique<GreyMethod>(base.info->make(base.settings), resolve);
    };
    info->complete = [base, word, name = info->name](const core::ParamValues& values) {
        core::ParamValues all = grey_table().complete(values, name);
        core::ParamValues of_samples = base.info->complete(base.settings);
        all["sample_threshold"] = of_samples.at("threshold");
        all["antialias"] = word;
        all.merge(of_samples);  // but its threshold, which is there
        return all;
    };
    method::MethodConfig grey{info.get(), {}, info};
    grey.is_grey = true;
    return grey;
}

std::vector<method::MethodConfig> at_each_antialias(
    const std::vector<method::MethodConfig>& configs,
    const std::vector<Antialias>& choices,
    double line_width_px) {
    std::vector<method::MethodConfig> all;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        for (const method::MethodConfig& config : configs) {
            if ((config.is_outside || config.info->draws_ink) && i > 0) continue;
            all.push_back(config.is_outside ? config
                                            : antialiased(config, choices[i], line_width_px));
        }
    }
    return all;
}

}  // namespace ink::methods
