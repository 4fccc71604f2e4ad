#include "image_io/exr_file.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <set>

#include "core/error.h"
#include "core/whole_file.h"
#include "image_io/open_image_io.h"

namespace ink::image_io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAcceptedExr = "an OpenEXR file";

/// A channel's pixels as they lie in memory, and the type that a file has them in.
struct Held {
    const void* data = nullptr;
    int width_px = 0;
    int height_px = 0;
    OIIO::TypeDesc type;
    OIIO::TypeDesc type_in_file;

    [[nodiscard]] bool is_empty() const { return width_px == 0 || height_px == 0; }
};

template <class T>
Held held_of(const core::Image<T>& image, OIIO::TypeDesc type, OIIO::TypeDesc type_in_file) {
    return {image.data(), image.width_px(), image.height_px(), type, type_in_file};
}

Held held_of(const ExrChannel& channel) {
    using OIIO::TypeDesc;
    if (const auto* half = std::get_if<HalfImage>(&channel.pixels))
        return held_of(half->pixels, TypeDesc::FLOAT, TypeDesc::HALF);
    if (const auto* whole = std::get_if<core::Image<std::uint32_t>>(&channel.pixels))
        return held_of(*whole, TypeDesc::UINT32, TypeDesc::UINT32);
    const auto& image = std::get<core::Image<float>>(channel.pixels);
    return held_of(image, TypeDesc::FLOAT, TypeDesc::FLOAT);
}

OIIO::ImageSpec spec_of(const ExrFile& file) {
    const Held first = held_of(file.channels.front());
    OIIO::ImageSpec spec(first.width_px,
                         first.height_px,
                         static_cast<int>(file.channels.size()),
                         OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (const ExrChannel& channel : file.channels) {
        spec.channelnames.push_back(channel.name);
        spec.channelformats.push_back(held_of(channel).type_in_file);
    }
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "");  // else it is the clock's, and no file is the same twice
    for (const ExrAttribute& attribute : file.attributes) {
        if (const auto* text = std::get_if<std::string>(&attribute.value)) {
            spec.attribute(attribute.name, *text);
        } else if (const auto* number = std::get_if<double>(&attribute.value)) {
            spec.attribute(attribute.name, OIIO::TypeDesc::DOUBLE, number);
        } else {
            spec.attribute(attribute.name,
                           OIIO::TypeMatrix,
                           std::get<std::array<float, 16>>(attribute.value).data());
        }
    }
    return spec;
}

/// All channels pixel by pixel, each in its own type: what a file with mixed types takes.
std::vector<std::uint8_t> interleave(const ExrFile& file, const OIIO::ImageSpec& spec) {
    const std::size_t pixel_bytes = spec.pixel_bytes(true);
    const auto pixels = static_cast<std::size_t>(spec.image_pixels());
    std::vector<std::uint8_t> all(pixels * pixel_bytes);
    std::size_t offset = 0;
    for (const ExrChannel& channel : file.channels) {
        const Held held = held_of(channel);
        const auto from = static_cast<OIIO::stride_t>(held.type.size());
        const auto to = static_cast<OIIO::stride_t>(pixel_bytes);
        OIIO::convert_image(1,
                            held.width_px,
                            held.height_px,
                            1,
                            held.data,
                            held.type,
                            from,
                            from * held.width_px,
                            OIIO::AutoStride,
                            all.data() + offset,
                            held.type_in_file,
                            to,
                            to * held.width_px,
                            OIIO::AutoStride);
        offset += held.type_in_file.size();
    }
    return all;
}

[[maybe_unused]] bool is_well_formed(const ExrFile& file) {
    std::set<std::string> names;
    return std::ranges::all_of(file.channels, [&](const ExrChannel& c) {
        const Held held = held_of(c), first = held_of(file.channels.front());
        return held.width_px == first.width_px && held.height_px == first.height_px &&
               names.insert(c.name).second;
    });
}

template <class T>
core::Image<T> read_image(OpenFile& file, int index) {
    core::Image<T> image(file.width_px, file.height_px);
    const std::vector<T> samples = read_samples<T>(file, index, index + 1);
    std::ranges::copy(samples, image.data());
    return image;
}

ExrChannel read_channel(OpenFile& file, int index) {
    ExrChannel channel{file.spec.channelnames[static_cast<std::size_t>(index)], {}};
    const OIIO::TypeDesc type = file.spec.channelformat(index);
    if (type == OIIO::TypeDesc::UINT32) {
        channel.pixels = read_image<std::uint32_t>(file, index);
    } else if (type == OIIO::TypeDesc::HALF) {
        channel.pixels = HalfImage{read_image<float>(file, index)};
    } else {
        channel.pixels = read_image<float>(file, index);
    }
    return channel;
}

std::vector<ExrAttribute> attributes_of(const OIIO::ImageSpec& spec) {
    std::vector<ExrAttribute> attributes;
    for (const OIIO::ParamValue& param : spec.extra_attribs) {
        const std::string name = param.name().string();
        if (param.type() == OIIO::TypeDesc::STRING) {
            attributes.push_back({name, param.get_string()});
        } else if (param.type() == OIIO::TypeDesc::DOUBLE) {
            attributes.push_back({name, *static_cast<const double*>(param.data())});
        } else if (param.type() == OIIO::TypeDesc::FLOAT || param.type() == OIIO::TypeDesc::INT) {
            attributes.push_back({name, static_cast<double>(param.get_float())});
        } else if (param.type() == OIIO::TypeMatrix) {
            std::array<float, 16> matrix{};
            std::memcpy(matrix.data(), param.data(), sizeof matrix);
            attributes.push_back({name, matrix});
        }
    }
    return attributes;
}

}  // namespace

void write_exr(const ExrFile& file, const fs::path& path) {
    if (file.channels.empty() || held_of(file.channels.front()).is_empty()) {
        throw core::Error(path.string(), "the image is empty", "a channel of at least 1 x 1 px");
    }
    assert(is_well_formed(file));
    const OIIO::ImageSpec spec = spec_of(file);
    std::vector<std::uint8_t> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("picture.exr", &memory);
    if (!output) throw core::Error(path.string(), "no EXR writer: " + one_line(OIIO::geterror()));
    if (!output->open("picture.exr", spec) ||
        !output->write_image(OIIO::TypeDesc::UNKNOWN, interleave(file, spec).data()) ||
        !output->close()) {
        throw core::Error(path.string(), "cannot be encoded: " + one_line(output->geterror()));
    }
    core::write_whole_file(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

ExrFile read_exr(const fs::path& path) {
    OpenFile opened = open_image(path, kAcceptedExr);
    if (std::string_view(opened.input->format_name()) != "openexr") {
        throw core::Error(path.string(), "this is not such a file", kAcceptedExr);
    }
    ExrFile file;
    for (int i = 0; i < opened.spec.nchannels; ++i)
        file.channels.push_back(read_channel(opened, i));
    std::ranges::sort(file.channels, [](const auto& a, const auto& b) { return a.name < b.name; });
    file.attributes = attributes_of(opened.spec);
    return file;
}

}  // namespace ink::image_io
