#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/rows/row.h"
#include "harness/scores/evaluations.h"
#include "harness/truths/tracing.h"
#include "method/method.h"

namespace ink::harness {

/// What methods drew on a view: an image is there once.
struct MethodImage {
    edge::EdgeImage edge_response;
    int threshold = 128;                        ///< the edge response at which it was scored
    std::vector<score::WrongPixel> wrong = {};  ///< its wrong pixels and why
};

/// One view that is shown whole: truth and methods side by side.
struct ShownView {
    std::string scene;
    std::string view;
    core::Image<std::uint8_t> labels;  ///< truth labels (truth::LineClass)
    std::vector<MethodImage> images;
    std::map<std::string, std::size_t> image_of;  ///< of each method the number of its image
};

/// What a method has inside for one view.
struct MethodLayers {
    std::string method;
    std::vector<method::Layer> layers;
};

/// The layers that image_files keeps of a method: `packed` and `filtered`, or `depth` and `normal`.
/// Empty for a method that shows none of them, or that failed.
[[nodiscard]] MethodLayers buffer_layers(PreparedMethod& method, const method::Frame& frame);

/// The images of one view as PNG files: path inside the run folder, and bytes.
///
/// In `images/<scene>/<view>/`: `truth.png` holds the label of each pixel (0 none, 1 contour, ...,
/// 7 ignore), `<method>.png` the edge response of a method (0..255) and `<method>.errors.png` why
/// each wrong pixel is wrong (0: it is not wrong; else 1 + score::Cause), both for `sampled` and
/// `exact_corner` too;
/// `<method>.layer_<name>.png` each of `layers`: `packed` (the codes as grey or colour) and
/// `filtered` (the edge response, middle grey at the threshold) of methods with a packed buffer,
/// `depth` (near is bright) and `normal` (view space, -1..1 as 0..255) of those with full buffers;
/// `layer_object.png`, `layer_patch.png` and `layer_facing.png` what the truth sees at pixel
/// centres: a colour for each object and smooth patch, |n.v| as grey. Cells that failed have none.
[[nodiscard]] std::map<std::string, std::string> image_files(
    const ViewTruth& truth,
    const scene::Scene& scene,
    const std::vector<Evaluation>& evaluations,
    const std::vector<MethodLayers>& layers = {});

/// `text` as part of a file's name: letters, digits, `.`, `-`, `_` and `+` stay, the rest becomes
/// `_`; never empty, hidden, or longer than 201 characters.
[[nodiscard]] std::string file_name(const std::string& text);

/// The folder of a view's images inside the run folder; characters that do not belong in a file's
/// name become '_'.
[[nodiscard]] std::filesystem::path image_folder(const std::string& scene, const std::string& view);

/// The images that the run folder `run` holds of one view, by `rows` of that view, which say
/// methods and thresholds; nothing if it holds none. Rows of another size than the images are left
/// out. Throws core::Error (where = the file) for an image that cannot be read or has not the size
/// of its truth.
[[nodiscard]] std::optional<ShownView> read_shown_view(const std::filesystem::path& run,
                                                       const std::vector<Row>& rows);

/// Makes the folder that results go to, with those above it; one that is there is left alone. Asked
/// before any work. Throws core::Error (where = the folder) if it cannot be made.
void make_out_folder(const std::filesystem::path& folder);

}  // namespace ink::harness
