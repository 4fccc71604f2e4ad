#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "edge/edge_image.h"
#include "score/attribution.h"

namespace ink::harness {

/// What one method drew on a view.
struct MethodImage {
    std::string method;
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
};

}  // namespace ink::harness
