#include "draw/image_output.h"

#include "image_io/image_file.h"

namespace ink::draw {
void write_drawing(const RgbImage& image, const std::filesystem::path& path) {
    image_io::write_png(image, path, {{image_io::kMixedText, "linear"}});
}

void write_colours(const RgbImage& image, const std::filesystem::path& path) {
    image_io::write_png(image, path);
}

void write_responses(const edge::EdgeImage& edge_responses, const std::filesystem::path& path) {
    image_io::write_png(edge_responses, path);
}

void write_truth_image(const core::Image<std::uint8_t>& labels, const std::filesystem::path& path) {
    image_io::write_png(truth_image(labels), path);
}

}  // namespace ink::draw
