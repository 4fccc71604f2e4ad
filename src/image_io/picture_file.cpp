#include "image_io/picture_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/srgb.h"
#include "image_io/open_image_io.h"

namespace ink::image_io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAcceptedPicture = "a grey or colour image, such as a PNG or an EXR";

/// Which channels of a file are a picture; -1 where it has none.
struct PictureChannels {
    std::string layer;  ///< "" for the image itself
    std::array<int, 3> colour = {-1, -1, -1};
    int alpha = -1;
};

/// The channels of one layer; `colour` begins with -1 if they are no picture.
PictureChannels channels_of_layer(const OIIO::ImageSpec& spec, const std::string& layer) {
    const std::string dot = layer.empty() ? "" : layer + ".";
    const auto find = [&](const char* name) { return spec.channelindex(dot + name); };
    PictureChannels found{layer, {find("R"), find("G"), find("B")}, find("A")};
    const bool has_colours = std::all_of(
        found.colour.begin(), found.colour.end(), [](int channel) { return channel >= 0; });
    if (!has_colours) found.colour.fill(find("Y"));
    return found;
}

PictureChannels find_channels(const OIIO::ImageSpec& spec, const fs::path& path) {
    PictureChannels found = channels_of_layer(spec, "");
    if (found.colour[0] >= 0) return found;
    for (const std::string& channel : spec.channelnames) {
        const std::size_t dot = channel.rfind('.');
        if (dot == std::string::npos) continue;
        const PictureChannels layer = channels_of_layer(spec, channel.substr(0, dot));
        const bool is_better =
            layer.colour[0] >= 0 && (found.colour[0] < 0 || (found.colour[0] == found.colour[1] &&
                                                             layer.colour[0] != layer.colour[1]));
        if (is_better) found = layer;
    }
    if (found.colour[0] < 0 && spec.nchannels == 1) found.colour.fill(0);
    if (found.colour[0] < 0 || spec.channelformat(found.colour[0]) == OIIO::TypeDesc::UINT32) {
        throw core::Error(
            path.string(),
            fmt::format("its channels are no picture: {}", fmt::join(spec.channelnames, ", ")),
            "channels R, G, B or Y, alone or in a layer");
    }
    return found;
}

/// What a screen shows for light, 0..1.
float shown(float light) {
    if (light <= 0) return 0;
    if (light >= 1) return 1;
    return static_cast<float>(core::value_of(light));
}

std::uint8_t to_byte(float value) {
    return static_cast<std::uint8_t>(std::lround(value > 0 ? 255 * std::min(value, 1.0F) : 0));
}

float to_share(float sample) {
    return sample;
}
float to_share(std::uint8_t sample) {
    return static_cast<float>(sample) / 255;
}

[[noreturn]] void refuse_number(const OpenFile& file,
                                int channel,
                                float value,
                                std::array<int, 2> at_px) {
    throw core::Error(file.path,
                      fmt::format("channel {} is {} at pixel {},{}",
                                  file.spec.channelnames[static_cast<std::size_t>(channel)],
                                  std::isnan(value) ? "not a number" : "infinite",
                                  at_px[0],
                                  at_px[1]),
                      "finite numbers");
}

/// Reads the channels of a picture as numbers of type T. `is_light`: values are linear light,
/// multiplied by alpha.
template <class T>
void read_pixels(OpenFile& file, const PictureChannels& channels, bool is_light, Picture& picture) {
    std::vector<int> used(channels.colour.begin(), channels.colour.end());
    if (channels.alpha >= 0) used.push_back(channels.alpha);
    const int least = *std::min_element(used.begin(), used.end());
    const int end = *std::max_element(used.begin(), used.end()) + 1;
    const auto stride = static_cast<std::size_t>(end - least);
    const std::vector<T> samples = read_samples<T>(file, least, end);
    for (std::size_t i = 0; i < picture.colour.size(); ++i) {
        const int x = static_cast<int>(i) % file.width_px;
        const int y = static_cast<int>(i) / file.width_px;
        const auto at = [&](int channel) {
            const float value =
                to_share(samples[i * stride + static_cast<std::size_t>(channel - least)]);
            if (!std::isfinite(value)) refuse_number(file, channel, value, {x, y});
            return value;
        };
        const float held = file.holds(x, y) ? 1 : 0;
        const float alpha = channels.alpha < 0 ? held : at(channels.alpha);
        for (int c = 0; c < 3; ++c) {
            const float value = at(channels.colour[static_cast<std::size_t>(c)]);
            const float straight = is_light && alpha > 0 ? value / alpha : value;
            picture.colour.data()[i][c] = to_byte(is_light ? shown(straight) : straight);
        }
        if (!picture.alpha.is_empty()) picture.alpha.data()[i] = to_byte(alpha);
    }
}

}  // namespace

Picture read_picture(const fs::path& path) {
    OpenFile file = open_image(path, kAcceptedPicture);
    const PictureChannels channels = find_channels(file.spec, path);
    const OIIO::TypeDesc type = file.spec.channelformat(channels.colour[0]);
    const bool is_light = type.is_floating_point();  // whole numbers are what a screen gets
    Picture picture{core::Image<Rgb>(file.width_px, file.height_px), {}};
    picture.texts = texts_of(file.spec);
    if (channels.alpha >= 0 || !file.holds_all())
        picture.alpha = core::Image<std::uint8_t>(file.width_px, file.height_px);
    if (type == OIIO::TypeDesc::UINT8) {
        read_pixels<std::uint8_t>(file, channels, is_light, picture);
    } else {
        read_pixels<float>(file, channels, is_light, picture);
    }
    if (!channels.layer.empty())
        picture.notes.push_back(fmt::format("layer {} of it", channels.layer));
    if (!file.is_as_held()) {
        picture.notes.push_back(
            fmt::format("its display window, of which it holds {} x {} px "
                        "from {},{}",
                        file.spec.width,
                        file.spec.height,
                        file.left_px,
                        file.top_px));
    }
    if (is_light) {
        picture.notes.emplace_back("float values as a screen shows them (sRGB)");
    } else if (type != OIIO::TypeDesc::UINT8) {
        picture.notes.push_back(fmt::format("{} bits rounded to 8", 8 * type.size()));
    }
    return picture;
}

}  // namespace ink::image_io
