#pragma once

#include <string>
#include <vector>

#include "report/svg.h"

namespace ink::report {

/// Something on a drawing that has a name.
struct Named {
    std::string name;
    double x = 0;
    double y = 0;
};

/// Where a name stands.
struct LabelPlace {
    Box box;
    bool has_leader = false;  ///< so far off that a line must lead to it
};

/// What labels must keep to.
struct LabelRoom {
    Box inside;                     ///< no label leaves this
    std::vector<Box> taken = {};    ///< nor covers one of these
    std::vector<Box> avoided = {};  ///< or one of these, if it can be helped
    double size = 12;               ///< of the letters
    double radius = 6;              ///< of the markers; no label covers one
};

/// A place for each name, near its marker and clear of the others, in the order of `named`. Crowded
/// markers choose first. Where there is no free place a label takes the one with the least overlap.
[[nodiscard]] std::vector<LabelPlace> place_labels(const std::vector<Named>& named,
                                                   const LabelRoom& room);

}  // namespace ink::report
