#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "score/motion.h"

namespace ink::studies {

/// How one method's lines behave on one sequence: a line of motion.csv.
struct MotionRow {
    std::string scene;
    std::string path;  ///< scene::name of its kind
    std::string method = {};
    std::string params = {};
    std::string status = "ok";
    int width_px = 0;
    int height_px = 0;
    int threads = 1;
    int frames = 0;
    double frames_per_s = 60;
    double step_px = 0;  ///< by which the image moves a frame
    score::Flicker flicker = {};
    score::PopCount pops = {};
    std::vector<std::int64_t> lives = {};  ///< of false lines: entry i lived i + 1 frames
    std::int64_t lives_cut = 0;            ///< of them those that may live longer than was seen
    std::string images_hash = {};          ///< of all its images
    std::string split = {};                ///< of the scene: train | heldout | real
    std::int64_t triangles = 0;            ///< of the scene, instances counted

    [[nodiscard]] bool is_ok() const { return status == "ok"; }
};

/// A sentence for each sequence on which the truth itself flickers, pops or has false lines: a run
/// with one is invalid.
[[nodiscard]] std::vector<std::string> motion_faults(const std::vector<MotionRow>& rows);

}  // namespace ink::studies
