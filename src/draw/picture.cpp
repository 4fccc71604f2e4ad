#include "draw/picture.h"

#include "image_io/image_file.h"

namespace ink::draw {
void write_drawing(const RgbImage& picture, const std::filesystem::path& path) {
    image_io::write_png(picture, path);
}

void write_strengths(const edge::EdgeImage& strengths, const std::filesystem::path& path) {
    image_io::write_png(strengths, path);
}

void write_truth_labels(const truth::Truth& truth, const std::filesystem::path& path) {
    image_io::write_png(truth.labels, path);
}

void write_truth_picture(const truth::Truth& truth, const std::filesystem::path& path) {
    image_io::write_png(truth_picture(truth.labels), path);
}

}  // namespace ink::draw
