#include "harness/images/view_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

#include "core/error.h"
#include "core/hash.h"
#include "core/parallel.h"
#include "core/whole_file.h"
#include "edge/set_pixels.h"
#include "image_io/image_file.h"
#include "truth/truth.h"

namespace ink::harness {
namespace {

namespace fs = std::filesystem;
using Gray = core::Image<std::uint8_t>;
using Rgb = core::Image<glm::u8vec3>;

constexpr const char* kTruth = "truth.png";
constexpr const char* kDrawn = ".png";
constexpr const char* kErrors = ".errors.png";

/// Layers of methods that are kept: what a filter reads or leaves. Others (ids, edges) show what
/// the truth's own layers show, or nothing that belongs to one view's pixels.
constexpr std::array<std::string_view, 4> kKeptLayers = {"packed", "filtered", "depth", "normal"};

/// PNGs by the images that they hold.
class PngStore {
  public:
    /// Where the PNG of an image will be once all are there.
    template <class T>
    const std::string* put(const core::Image<T>& image) {
        // Grey and colours are not to be taken for each other.
        const std::string hash = fmt::format("{} {}", sizeof(T), core::image_hash(image));
        std::unique_lock lock(mutex_);
        const auto [found, is_new] = pngs_.try_emplace(hash);
        lock.unlock();
        if (is_new) {
            const std::vector<std::uint8_t> bytes = image_io::encode_png(image);
            found->second.assign(bytes.begin(), bytes.end());
        }
        return &found->second;
    }

  private:
    std::mutex mutex_;
    std::map<std::string, std::string> pngs_;
};

/// A file, and what puts its image into the store.
struct Picture {
    std::string file;
    std::function<const std::string*(PngStore&)> put;
};

template <class Make>
Picture picture(std::string file, Make make) {
    return {std::move(file), [make](PngStore& store) { return store.put(make()); }};
}

Gray errors_of(const Evaluation& evaluation) {
    Gray errors(evaluation.image.width_px(), evaluation.image.height_px());
    for (const score::WrongPixel& wrong : evaluation.scored.attribution.pixels) {
        errors.at(wrong.pixel.x_px, wrong.pixel.y_px) =
            static_cast<std::uint8_t>(1 + static_cast<int>(wrong.cause));
    }
    return errors;
}

/// A colour that tells a number from its neighbours; sky is white.
glm::u8vec3 colour_of(std::uint32_t number) {
    if (number == truth::kNoTriangle) return {255, 255, 255};
    std::uint32_t mixed = (number + 1) * 2654435761u;  // Knuth's multiplicative hash
    mixed ^= mixed >> 15;
    return {static_cast<std::uint8_t>(64 + mixed % 160),
            static_cast<std::uint8_t>(64 + (mixed >> 8) % 160),
            static_cast<std::uint8_t>(64 + (mixed >> 16) % 160)};
}

/// The object of every global triangle.
std::vector<std::uint32_t> objects_of(const scene::Scene& scene) {
    std::vector<std::uint32_t> objects;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const std::size_t triangles = scene.meshes[scene.instances[i].mesh].triangles.size();
        objects.insert(objects.end(), triangles, static_cast<std::uint32_t>(i));
    }
    return objects;
}

Rgb object_layer(const truth::Layers& layers, const scene::Scene& scene) {
    const std::vector<std::uint32_t> objects = objects_of(scene);
    return core::mapped<glm::u8vec3>(layers.triangle, [&](std::uint32_t triangle) {
        return colour_of(triangle < objects.size() ? objects[triangle] : triangle);
    });
}

Rgb patch_layer(const truth::Layers& layers) {
    return core::mapped<glm::u8vec3>(layers.patch, colour_of);
}

Gray facing_layer(const truth::Layers& layers) {
    return core::mapped<std::uint8_t>(layers.n_dot_v, [](float n_dot_v) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(n_dot_v, 0.0f, 1.0f)));
    });
}

/// none and oracle are blank and the truth itself.
bool is_kept(const Row& row) {
    return row.is_ok() && row.method != "none" && row.method != kOracle;
}

Gray read_sized(const fs::path& file, const Gray& truth) {
    Gray image = image_io::read_gray(file);
    if (image.width_px() == truth.width_px() && image.height_px() == truth.height_px())
        return image;
    throw core::Error(
        file.string(),
        fmt::format("it is {}x{} px", image.width_px(), image.height_px()),
        fmt::format("{}x{} px, as its truth.png", truth.width_px(), truth.height_px()));
}

std::vector<score::WrongPixel> wrong_pixels(const fs::path& file, const Gray& truth) {
    std::vector<score::WrongPixel> wrong;
    const Gray errors = read_sized(file, truth);
    edge::visit_set_pixels(errors, [&](int x, int y) {
        const int code = errors.at(x, y);
        if (code > static_cast<int>(score::kCauseCount)) {
            throw core::Error(file.string(),
                              fmt::format("pixel {},{} holds {}", x, y, code),
                              fmt::format("0..{}", score::kCauseCount));
        }
        wrong.push_back({{x, y}, static_cast<score::Cause>(code - 1)});
    });
    return wrong;
}

}  // namespace

std::string file_name(const std::string& text) {
    constexpr std::size_t kLongest = 200;  // file systems allow 255, and an ending comes behind
    std::string name = text.substr(0, kLongest);
    for (char& c : name) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ||
                              c == '-' || c == '_' || c == '+';
        if (!is_plain) c = '_';
    }
    if (name.empty() || name.front() == '.') name.insert(name.begin(), '_');
    return name;
}

fs::path image_folder(const std::string& scene, const std::string& view) {
    return fs::path("images") / file_name(scene) / file_name(view);
}

MethodLayers buffer_layers(PreparedMethod& method, const method::Frame& frame) {
    MethodLayers kept{method.config().info->name, {}};
    if (!method.failure().empty()) return kept;
    for (method::Layer& layer : method.method().layers(frame)) {
        if (std::find(kKeptLayers.begin(), kKeptLayers.end(), layer.name) != kKeptLayers.end())
            kept.layers.push_back(std::move(layer));
    }
    return kept;
}

std::map<std::string, std::string> image_files(const ViewTruth& truth,
                                               const scene::Scene& scene,
                                               const std::vector<Evaluation>& evaluations,
                                               const std::vector<MethodLayers>& method_layers) {
    if (evaluations.empty()) return {};
    const fs::path folder =
        image_folder(evaluations.front().row.scene, evaluations.front().row.view);
    const truth::Layers& layers = truth.traced.layers;
    std::vector<Picture> pictures = {
        picture(kTruth, [&] { return truth.counted_labels(); }),
        picture("layer_object.png", [&] { return object_layer(layers, scene); }),
        picture("layer_patch.png", [&] { return patch_layer(layers); }),
        picture("layer_facing.png", [&] { return facing_layer(layers); }),
    };
    for (const Evaluation& evaluation : evaluations) {
        if (!is_kept(evaluation.row)) continue;
        const std::string name = file_name(evaluation.row.method);
        pictures.push_back(
            picture(name + kDrawn, [&]() -> const Gray& { return evaluation.image; }));
        pictures.push_back(picture(name + kErrors, [&] { return errors_of(evaluation); }));
    }
    for (const MethodLayers& of_method : method_layers) {
        for (const method::Layer& layer : of_method.layers) {
            pictures.push_back(
                picture(fmt::format("{}.layer_{}.png", file_name(of_method.method), layer.name),
                        [&]() -> const Rgb& { return layer.rgb; }));
        }
    }
    // Methods share their buffers' layers with others, and often draw the same.
    PngStore store;
    std::vector<const std::string*> pngs(pictures.size());
    core::parallel_for(pictures.size(), core::hardware_threads(), [&](std::size_t i) {
        pngs[i] = pictures[i].put(store);
    });
    std::map<std::string, std::string> files;
    for (std::size_t i = 0; i < pictures.size(); ++i)
        files[(folder / pictures[i].file).string()] = *pngs[i];
    return files;
}

std::optional<ShownView> read_shown_view(const fs::path& run, const std::vector<Row>& rows) {
    if (rows.empty()) return std::nullopt;
    const fs::path folder = run / image_folder(rows.front().scene, rows.front().view);
    if (!fs::exists(folder / kTruth)) return std::nullopt;
    ShownView view{
        rows.front().scene, rows.front().view, image_io::read_gray(folder / kTruth), {}, {}};
    const auto file_of = [&](const Row& row, const char* ending) {
        return folder / (file_name(row.method) + ending);
    };
    using Bytes = std::optional<std::string>;
    std::map<std::tuple<Bytes, Bytes, std::optional<int>>, std::size_t> known;
    std::vector<const Row*> shown;
    for (const Row& row : rows) {
        // Rows of other sizes and numbers of threads have no images of their own.
        const bool is_of_row =
            row.width == view.labels.width_px() && row.height == view.labels.height_px();
        if (!is_kept(row) || !is_of_row || view.image_of.contains(row.method)) continue;
        Bytes drawn = core::read_whole_file(file_of(row, kDrawn));
        if (!drawn) continue;
        // The same image may be wrong for other reasons.
        Bytes errors = core::read_whole_file(file_of(row, kErrors));
        const auto [found, is_new] =
            known.try_emplace({std::move(drawn), std::move(errors), row.threshold}, shown.size());
        if (is_new) shown.push_back(&row);
        view.image_of[row.method] = found->second;
    }
    view.images.resize(shown.size());
    core::parallel_for(shown.size(), core::hardware_threads(), [&](std::size_t i) {
        const Row& row = *shown[i];
        view.images[i] = {read_sized(file_of(row, kDrawn), view.labels),
                          row.threshold.value_or(128),
                          wrong_pixels(file_of(row, kErrors), view.labels)};
    });
    return view;
}

void make_out_folder(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder)) {
        throw core::Error(
            folder.string(),
            "this folder cannot be made" + (failure ? ": " + failure.message() : std::string()),
            "a place that can be written");
    }
}

}  // namespace ink::harness
