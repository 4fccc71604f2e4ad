#include "lab/picture.h"

#include <memory>

#include "image_io/image_file.h"
#include "lab/palette.h"
#include "shade/compose.h"
#include "shade/gouraud.h"

namespace ink::lab {
namespace {

int threshold_of(const Entrant& entrant) {
    return std::stoi(entrant.info->complete(entrant.settings).at("threshold"));
}

}  // namespace

edge::EdgeImage draw_strengths(const Subject& subject,
                               const Entrant& entrant,
                               int threads,
                               const raster::SkipSet& skips) {
    const scene::View& view = subject.views.front();
    const std::unique_ptr<methods::Method> method = entrant.info->make(entrant.settings);
    edge::EdgeImage strengths(view.width_px, view.height_px);
    method->prepare(subject.scene);
    method->pose(subject.scene);
    method->draw({view, threads, skips}, strengths);
    return strengths;
}

RgbImage compose_drawing(const Subject& subject,
                         const Entrant& entrant,
                         const edge::EdgeImage& strengths,
                         Shading shading) {
    const shade::Ink ink{kInk.rgb, threshold_of(entrant)};
    if (shading == Shading::none) return shade::compose(strengths, kPaper.rgb, ink);
    const auto light = shade::draw_gouraud(subject.scene, subject.views.front(), {});
    return shade::compose(strengths, shade::to_8_bit(light), ink);
}

void write_drawing(const Subject& subject,
                   const Entrant& entrant,
                   const edge::EdgeImage& strengths,
                   Shading shading,
                   const std::filesystem::path& path) {
    image_io::write_png(compose_drawing(subject, entrant, strengths, shading), path);
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

}  // namespace ink::lab
