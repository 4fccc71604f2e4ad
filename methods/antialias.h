#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/param.h"
#include "method/method_config.h"
#include "scene/scene.h"

namespace ink::methods {

/// How many samples of a pixel a method draws: 1, 2 x 2 or 4 x 4. They are averaged.
enum class Antialias { none, resolve4, resolve16 };

/// "none", "resolve4", "resolve16": the spelling of options, files and names of methods.
inline constexpr std::array<std::string_view, 3> kAntialiasNames = {
    "none", "resolve4", "resolve16"};

/// The choices that texts spell, each once. Throws core::Error (where = the text's) that lists them
/// for another text, and for one that is named twice.
[[nodiscard]] std::vector<Antialias> parse_antialias(const std::vector<core::GivenText>& names);

/// Samples on a pixel's side: 1, 2 or 4.
[[nodiscard]] int samples_per_side(Antialias antialias);

/// The view drawn at n x n its size. Throws core::Error (where = "--antialias") if that is too
/// large.
[[nodiscard]] scene::View enlarged(scene::View view, int n);

/// The share of a pixel, of 255, at which a grey line is scored as drawn where a score needs a yes
/// or no. A line of a pixel or more covers half of one pixel at least wherever it lies.
inline constexpr int kGreyThreshold = 128;

/// The configuration as a method of its own that draws grey lines, called NAME_resolve4 or
/// NAME_resolve16; for `none`, and if it draws ink, as it is.
///
/// It runs whole at the size of the samples, its filter and threshold included: no code is
/// averaged. What is drawn is then all or nothing a sample, and the mean over each pixel is the
/// edge response. A method with parameters width*_px draws lines `line_width_px` wide, or as wide
/// as the user set, times the samples on a side, up to what the parameter accepts. What others draw
/// is followed by a round pen, of whole samples, with which a line of one sample comes out about so
/// wide, and one of k samples k - 1 samples wider.
///
/// Its parameters are those of the method, whose threshold is called `sample_threshold`, the
/// `antialias`, and the `threshold` of grey lines (kGreyThreshold). Drawing throws as enlarged()
/// does. Not for methods from outside.
[[nodiscard]] method::MethodConfig antialiased(const method::MethodConfig& config,
                                               Antialias antialias,
                                               double line_width_px);

/// All methods at the first choice of samples, then at the next. Those from outside, and those that
/// draw ink, are what they are, and come once.
[[nodiscard]] std::vector<method::MethodConfig> at_each_antialias(
    const std::vector<method::MethodConfig>& configs,
    const std::vector<Antialias>& choices,
    double line_width_px);

}  // namespace ink::methods
