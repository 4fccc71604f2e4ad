#include "given_images/score_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <variant>

#include "core/error.h"
#include "core/parse_number.h"
#include "draw/exr_layers.h"
#include "image_io/exr_file.h"
#include "image_io/image_file.h"

namespace ink::given_images {
namespace {

/// The channel called `name`, or null.
template <class T>
const core::Image<T>* find_channel(const image_io::ExrFile& file, std::string_view name) {
    for (const image_io::ExrChannel& channel : file.channels) {
        if (channel.name == name) return std::get_if<core::Image<T>>(&channel.pixels);
    }
    return nullptr;
}

template <class T>
std::optional<T> find_attribute(const image_io::ExrFile& file, std::string_view name) {
    for (const image_io::ExrAttribute& attribute : file.attributes) {
        if (attribute.name != name) continue;
        if (const T* value = std::get_if<T>(&attribute.value)) return *value;
    }
    return std::nullopt;
}

std::optional<int> find_number(const image_io::Texts& texts, const char* name) {
    const auto found = texts.find(name);
    return found == texts.end() ? std::nullopt : core::parse_number<int>(found->second);
}

TruthLabels read_exr_labels(const std::filesystem::path& path, score::Intersections intersections) {
    const image_io::ExrFile file = image_io::read_exr(path);
    const auto* labels = find_channel<std::uint32_t>(file, "class.label");
    if (labels == nullptr) {
        throw core::Error(path.string(),
                          "it has no channel class.label of whole numbers",
                          "the file of inkbench truth -o truth.exr");
    }
    TruthLabels truth{core::mapped<std::uint8_t>(*labels,
                                                 [](std::uint32_t label) {
                                                     return static_cast<std::uint8_t>(
                                                         std::min<std::uint32_t>(label, 255));
                                                 }),
                      find_attribute<double>(file, "ink:ignore_label"),
                      find_attribute<double>(file, "ink:band_px"),
                      true,
                      find_attribute<std::string>(file, "ink:command").value_or("")};
    if (const auto* coverage = find_channel<float>(file, draw::kCoverageChannel)) {
        truth.coverage = *coverage;
        const auto* const end = coverage->data() + coverage->size();
        const auto* const wrong =
            std::find_if(coverage->data(), end, [](float v) { return !std::isfinite(v); });
        if (wrong != end) {
            const auto at = static_cast<int>(wrong - coverage->data());
            throw core::Error(path.string(),
                              fmt::format("channel {} is {} at pixel {},{}",
                                          draw::kCoverageChannel,
                                          *wrong,
                                          at % coverage->width_px(),
                                          at / coverage->width_px()),
                              "finite numbers");
        }
        truth.line_width_px = find_attribute<double>(file, draw::kLineWidthAttribute).value_or(0);
    }
    const auto* below = find_channel<std::uint32_t>(file, "class.below_crease");
    if (below == nullptr) return truth;
    const auto is_below =
        core::mapped<std::uint8_t>(*below, [](std::uint32_t value) { return value != 0; });
    truth.labels = score::counted_labels(truth.labels, is_below, intersections);
    return truth;
}

}  // namespace

TruthLabels read_truth_labels(const std::filesystem::path& path,
                              score::Intersections intersections) {
    if (path.extension() == ".exr") return read_exr_labels(path, intersections);
    image_io::GrayFile file = image_io::read_gray_file(path);
    if (file.has_colour) {
        throw core::Error(path.string(),
                          "it is in colour: a preview for people, no truth",
                          "an image of class numbers, or the .exr, of inkbench truth -o");
    }
    const auto command = file.texts.find("ink:command");
    return {std::move(file.pixels),
            find_number(file.texts, "ink:ignore_label"),
            find_number(file.texts, "ink:band_px"),
            file.texts.contains("ink:labels"),
            command == file.texts.end() ? "" : command->second,
            find_number(file.texts, "ink:below_crease_px").value_or(0)};
}

}  // namespace ink::given_images
