#pragma once

#include <filesystem>

#include "draw/error_picture.h"
#include "edge/edge_image.h"
#include "truth/truth.h"

namespace ink::draw {

/// Writes a finished drawing as PNG. Throws core::Error if the file cannot be written.
void write_drawing(const RgbImage& picture, const std::filesystem::path& path);

/// Writes bare strengths as an 8-bit grey PNG, which `inkbench score` takes.
void write_strengths(const edge::EdgeImage& strengths, const std::filesystem::path& path);

/// Writes a truth's labels as an 8-bit grey PNG of class numbers, which `inkbench score` takes, or
/// as a picture with a colour per class on white.
void write_truth_labels(const truth::Truth& truth, const std::filesystem::path& path);
void write_truth_picture(const truth::Truth& truth, const std::filesystem::path& path);

}  // namespace ink::draw
