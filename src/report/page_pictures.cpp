#include "report/page_pictures.h"

#include <algorithm>

#include "core/parallel.h"
#include "draw/error_image.h"
#include "image_io/image_file.h"
#include "report/html.h"

namespace ink::report {
namespace {

constexpr int kThumbWidth_px = 208;  // shown at half of that: sharp on dense screens

std::string uri_of(const draw::RgbImage& image) {
    return png_uri(image_io::encode_png(image));
}

int thumb_factor(int width_px) {
    return std::max(1, (width_px + kThumbWidth_px / 2) / kThumbWidth_px);
}

PagePicture truth_of(const harness::ShownView& view, int factor) {
    const auto whole = factor == 1 ? draw::thicken(view.labels) : draw::shrink(view.labels, factor);
    const auto thumb = draw::shrink(view.labels, thumb_factor(view.labels.width_px()));
    return {"", uri_of(draw::truth_image(whole)), uri_of(draw::truth_image(thumb))};
}

PagePicture errors_of(const harness::ShownView& view,
                      const harness::MethodImage& image,
                      int factor) {
    const draw::Marks marks = draw::mark_errors(
        view.labels, image.edge_response, {.threshold = image.threshold, .wrong = image.wrong});
    const draw::Marks whole = factor == 1 ? draw::thicken(marks) : draw::shrink(marks, factor);
    const draw::Marks thumb = draw::shrink(marks, thumb_factor(view.labels.width_px()));
    return {image.method, uri_of(draw::error_image(whole)), uri_of(draw::error_image(thumb))};
}

std::vector<PageScene> encode_at(const std::vector<harness::ShownView>& views, int factor) {
    struct Job {
        std::size_t view;
        std::size_t image;
    };
    std::vector<PageScene> scenes;
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::size_t count = views[i].images.size() + 1;
        scenes.push_back({&views[i], std::vector<PagePicture>(count)});
        for (std::size_t j = 0; j < count; ++j)
            jobs.push_back({i, j});
    }
    core::parallel_for(jobs.size(), core::hardware_threads(), [&](std::size_t index) {
        const auto [i, j] = jobs[index];
        PagePicture& out = scenes[i].images[j];
        out = j == 0 ? truth_of(views[i], factor)
                     : errors_of(views[i], views[i].images[j - 1], factor);
    });
    return scenes;
}

std::size_t size_of(const PageScene& scene) {
    std::size_t size = 0;
    for (const PagePicture& image : scene.images)
        size += image.size();
    return size;
}

std::size_t size_of(const std::vector<PageScene>& scenes) {
    std::size_t size = 0;
    for (const PageScene& scene : scenes)
        size += size_of(scene);
    return size;
}

}  // namespace

PageScenes encode_scenes(const std::vector<harness::ShownView>& views, std::size_t budget_bytes) {
    PageScenes scenes;
    for (const int factor : {1, 2, 4, 8}) {
        scenes.scenes = encode_at(views, factor);
        scenes.shrink_factor = factor;
        if (size_of(scenes.scenes) <= budget_bytes) return scenes;
    }
    while (size_of(scenes.scenes) > budget_bytes) {
        scenes.scenes.pop_back();
        ++scenes.left_out;
    }
    return scenes;
}

}  // namespace ink::report
