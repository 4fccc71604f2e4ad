#pragma once

#include <filesystem>

#include "draw/error_image.h"
#include "edge/edge_image.h"

namespace ink::draw {

/// Writes a finished drawing as PNG, which says how its ink is mixed. Throws core::Error if the
/// file cannot be written.
void write_drawing(const RgbImage& image, const std::filesystem::path& path);

/// The same of colours that are no ink on paper: a buffer, an error image, shading alone.
void write_colours(const RgbImage& image, const std::filesystem::path& path);

/// Writes bare edge responses as an 8-bit grey PNG, which `inkbench score` takes.
void write_responses(const edge::EdgeImage& edge_responses, const std::filesystem::path& path);

/// Writes truth labels as an image with a colour per class on white.
void write_truth_image(const core::Image<std::uint8_t>& labels, const std::filesystem::path& path);

}  // namespace ink::draw
