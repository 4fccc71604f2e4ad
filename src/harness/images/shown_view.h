#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/attribution.h"

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

}  // namespace ink::harness
