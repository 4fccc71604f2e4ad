#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "scene/camera.h"

namespace ink::scene {

/// The ways in which a camera moves.
enum class PathKind {
    still,  ///< not at all: what moves then is the scene
    orbit,  ///< about the vertical through the middle of the scene, from +z towards +x
    dolly,  ///< along its view direction, towards the middle of the scene, which it never reaches
    pan,    ///< turns about its own up, to the right
    shake,  ///< turns by chance, in every frame anew, round where it started
    roll,   ///< turns about its view direction, to the left: the image turns clockwise
};

/// "still", "orbit", ...: the one spelling of options, columns and legends.
[[nodiscard]] std::string_view name(PathKind kind);

/// All kinds, in the order of the enum.
[[nodiscard]] std::span<const PathKind> path_kinds();

/// A camera that moves: its view is a function of the frame's number, in closed form, so that any
/// frame can be had alone. The same bits on every machine, as far as `start` is.
struct CameraPath {
    PathKind kind = PathKind::still;
    View start;            ///< frame 0; of a shake, where it rests
    Sphere bounds;         ///< of the scene, in all its poses: what is orbited and approached
    double turn_rad = 0;   ///< a frame: orbit, pan, roll; of a shake the most, either way
    double growth = 1;     ///< dolly: by how much the middle of the scene, or of a parallel camera
                           ///< everything, grows a frame
    int frame_count = 24;  ///< >= 1
    double frames_per_s = 60;
    std::uint64_t seed = 0;  ///< of a shake
};

/// One frame: when it is, for whoever poses an animated scene, and what is seen then.
struct PathFrame {
    double time_s = 0;
    View view;
};

/// A path from `start` on which the image moves by `step_px` a frame (a shake: by at most that
/// much from its rest, either way), negative for the other direction. What moves so far is
/// - orbit: the point of `bounds` that is nearest the eye;
/// - dolly, roll: a point in the plane of the ball's middle, half the image's height from the
///   middle of the image; a dolly's at its first frame, then a little more each frame;
/// - pan, shake: the middle of the image; of a parallel camera what is there as far away as the
///   middle of the ball.
/// Everything else moves about as far, the background of an orbit the other way.
///
/// Frame count, rate and seed are the defaults; a caller may overwrite `turn_rad` for a path of
/// given angles. Throws Error if `step_px` is not finite, the image has no height, a dolly leaves
/// the ball's middle behind it or would pass it (|step| of half the height or more), or an orbit
/// starts inside the ball or above its middle.
[[nodiscard]] CameraPath make_path(PathKind kind,
                                   const View& start,
                                   const Sphere& bounds,
                                   double step_px);

/// Frame number `frame` >= 0 of a path; numbers from frame_count on continue it. The camera is
/// called by kind and number ("orbit_007").
///
/// Near and far stay the start's, but reach nearer or farther where the moved ball needs it.
[[nodiscard]] PathFrame frame_at(const CameraPath& path, int frame);

}  // namespace ink::scene
