#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/figure_views.h"
#include "report/picture_grid.h"

namespace ink::report {

/// A grid of pictures with what its colours mean.
struct GridFigure {
    std::vector<GridBand> bands;
    std::vector<std::vector<LegendEntry>> legend;
};

/// Scenes by methods: the truth, then every method with its errors in colour and F below, the best
/// of a scene in bold. More than six methods go on in bands below.
[[nodiscard]] GridFigure strips_figure(const std::vector<FigureView>& views);

/// A band a scene: what the methods with a `packed` layer have inside, that layer over the
/// `filtered` one over their errors; to the left depth and normals of the first method that has
/// such layers, over the truth. No bands if no method has any of them.
[[nodiscard]] GridFigure buffers_figure(const std::vector<FigureView>& views);

/// Where on the picture two methods differ most: of all windows of this size the one in which one
/// has most wrong pixels more than the other; of equal ones the one in their middle. Where no
/// window tells them apart, the one with the most wrong pixels of both; without any, the middle.
struct Window {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};
[[nodiscard]] Window most_different(const draw::Marks& a,
                                    const draw::Marks& b,
                                    int width,
                                    int height);

inline constexpr int kZoom = 6;  ///< pixels a pixel

/// A band a scene: the window in which the two methods differ most, six times enlarged, with the
/// truth's sub-pixel lines over it: whole picture with the window, truth, both methods, and below
/// what each has inside there. Scenes on which one of the two failed are left out.
[[nodiscard]] GridFigure zoom_figure(const std::vector<FigureView>& views,
                                     const std::pair<std::string, std::string>& methods);

}  // namespace ink::report
