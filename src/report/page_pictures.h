#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/report.h"

namespace ink::report {

/// One picture of the page: whole for the stage, tiny for the picker, both data: URIs.
struct PagePicture {
    std::string method;  ///< "" for the truth
    std::string whole;
    std::string thumb;

    [[nodiscard]] std::size_t size() const { return whole.size() + thumb.size(); }
};

/// The pictures of one shown view, truth first.
struct PageScene {
    const harness::ShownView* view = nullptr;
    std::vector<PagePicture> images;
};

/// All pictures that fit on the page.
struct PageScenes {
    std::vector<PageScene> scenes;
    int shrink_factor = 1;     ///< pictures are at 1/factor of their size
    std::size_t left_out = 0;  ///< views that had no room even so
};

/// Draws truth and errors of `views` and encodes them, on as many threads as there are. Pictures
/// are shrunk by a common factor of 1, 2, 4 or 8 until all URIs together take at most
/// `budget_bytes`; if 8 is not enough, the last views are left out.
[[nodiscard]] PageScenes encode_scenes(const std::vector<harness::ShownView>& views,
                                       std::size_t budget_bytes);

}  // namespace ink::report
