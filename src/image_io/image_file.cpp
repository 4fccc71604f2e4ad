#include "image_io/image_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

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

constexpr std::int64_t kMaxPixels = std::int64_t{1} << 27;
constexpr const char* kAcceptedImage = "an 8-bit grey or colour image, such as a PNG";

/// What the file system alone can tell to be wrong.
void check_file(const fs::path& path, const char* accepted) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw core::Error(path.string(), "no such file", accepted);
    if (!fs::is_regular_file(status)) throw core::Error(path.string(), "not a file", accepted);
    if (fs::file_size(path, error) == 0 && !error) {
        throw core::Error(path.string(), "the file is empty", accepted);
    }
}

std::uint32_t big_endian(const std::array<unsigned char, 8>& bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
           std::uint32_t{bytes[2]} << 8 | bytes[3];
}

/// Refuses a PNG whose chunks do not reach to its end mark. Its own library would notice, but talks
/// to stderr past everybody when it does.
void check_not_cut(const fs::path& path, const char* accepted) {
    std::ifstream file(path, std::ios::binary);
    std::array<unsigned char, 8> head{};
    const auto read_head = [&] {
        return static_cast<bool>(file.read(reinterpret_cast<char*>(head.data()), std::ssize(head)));
    };
    constexpr std::array<unsigned char, 8> kSignature = {
        0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    if (!read_head() || head != kSignature) return;  // another format, or none: not for us to say
    constexpr std::int64_t kChecksumBytes = 4;
    const auto size = static_cast<std::int64_t>(fs::file_size(path));
    while (read_head()) {
        const std::int64_t next =
            static_cast<std::int64_t>(file.tellg()) + big_endian(head) + kChecksumBytes;
        if (next > size) break;
        if (std::equal(head.begin() + 4, head.end(), "IEND")) return;
        file.seekg(next);
    }
    throw core::Error(path.string(), "the file is cut off", accepted);
}

void check_size(int width_px, int height_px, int depth, const fs::path& path) {
    const std::int64_t pixels = std::int64_t{width_px} * height_px;
    if (width_px >= 1 && height_px >= 1 && depth <= 1 && pixels <= kMaxPixels) return;
    throw core::Error(path.string(),
                      fmt::format("its size is {} x {} px", width_px, height_px),
                      "1 x 1 px to 2^27 px in all");
}

/// Refuses what cannot become 8-bit grey without a guess.
void check_is_gray(const OIIO::ImageSpec& spec, const fs::path& path) {
    if (spec.format != OIIO::TypeDesc::UINT8) {
        throw core::Error(path.string(),
                          fmt::format("its pixels are {}, not 8-bit", spec.format.c_str()),
                          kAcceptedImage);
    }
    if (spec.nchannels < 1 || spec.nchannels > 4) {
        throw core::Error(
            path.string(), fmt::format("it has {} channels", spec.nchannels), kAcceptedImage);
    }
}

GrayFile to_gray(const std::vector<std::uint8_t>& samples, const OIIO::ImageSpec& spec) {
    GrayFile gray{core::Image<std::uint8_t>(spec.width, spec.height)};
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    if (channels == 1) std::copy(samples.begin(), samples.end(), gray.pixels.data());
    for (std::size_t i = 0; channels > 1 && i < gray.pixels.size(); ++i) {
        const std::uint8_t* pixel = samples.data() + i * channels;
        gray.pixels.data()[i] = channels < 3 ? pixel[0] : luma(Rgb(pixel[0], pixel[1], pixel[2]));
        if (channels >= 3 && (pixel[0] != pixel[1] || pixel[1] != pixel[2])) gray.has_colour = true;
    }
    gray.texts = texts_of(spec);
    return gray;
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

Texts texts_of(const OIIO::ImageSpec& spec) {
    Texts texts;
    for (const OIIO::ParamValue& param : spec.extra_attribs) {
        if (param.type() == OIIO::TypeDesc::STRING)
            texts[param.name().string()] = param.get_string();
    }
    return texts;
}

OpenFile open_image(const fs::path& path, const char* accepted) {
    check_file(path, accepted);
    check_not_cut(path, accepted);
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    OpenFile file{OIIO::ImageInput::open(path.string(), &wishes), {}, path.string(), accepted};
    if (!file.input) {
        throw core::Error(path.string(), "not an image: " + one_line(OIIO::geterror()), accepted);
    }
    const OIIO::ImageSpec& spec = file.spec = file.input->spec();
    check_size(spec.width, spec.height, spec.depth, path);
    file.width_px = spec.width;
    file.height_px = spec.height;
    if (std::string_view(file.input->format_name()) != "openexr") return file;
    check_size(spec.full_width, spec.full_height, spec.full_depth, path);
    file.width_px = spec.full_width;
    file.height_px = spec.full_height;
    file.left_px = spec.x - spec.full_x;
    file.top_px = spec.y - spec.full_y;
    return file;
}

GrayFile read_gray_file(const fs::path& path) {
    OpenFile file = open_image(path, kAcceptedImage);
    check_is_gray(file.spec, path);
    return to_gray(read_samples<std::uint8_t>(file, 0, file.spec.nchannels), file.spec);
}

std::vector<std::uint8_t> encode_png(const PngPixels& image,
                                     const Texts& texts,
                                     const std::string& where) {
    if (image.width_px == 0 || image.height_px == 0) {
        throw core::Error(where, "the image is empty", "at least 1 x 1 px");
    }
    std::vector<std::uint8_t> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("picture.png", &memory);
    if (!output) throw core::Error(where, "no PNG writer: " + one_line(OIIO::geterror()));
    OIIO::ImageSpec spec(image.width_px, image.height_px, image.channels, OIIO::TypeDesc::UINT8);
    // A run writes thousands of images: the fastest level. Most rows repeat the one above, so that
    // differences to it are runs of 0.
    constexpr int kUpFilter = 0x20;  // PNG_FILTER_UP
    spec.attribute("png:compressionLevel", 1);
    spec.attribute("png:filter", kUpFilter);
    spec.attribute("compression", "rle");
    for (const auto& [name, text] : texts)
        spec.attribute(name, text);
    if (!output->open("picture.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, image.data) || !output->close()) {
        throw core::Error(where, "cannot be encoded: " + one_line(output->geterror()));
    }
    return bytes;
}

}  // namespace ink::image_io
