#pragma once

#include <array>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/import.h"
#include "scene/scene.h"

namespace ink::harness {

/// A camera as the user asks for it, in the file's own coordinates (Scene::origin); near and far
/// are fitted to the scene.
struct CameraRequest {
    glm::dvec3 eye_world{0};
    std::optional<glm::dvec3> target_world;  ///< default: the scene's centre
    glm::dvec3 up_world{0, 1, 0};
    double fov_deg = 40;                      ///< of a pinhole, vertical
    std::optional<double> height_world = {};  ///< seen by a parallel camera, instead
};

/// Which axis of a file's coordinates stands upright in views by name: "x", "y" or "z".
enum class UpAxis { x, y, z };
inline constexpr std::array<std::string_view, 3> kUpAxisNames{"x", "y", "z"};
[[nodiscard]] constexpr std::string_view name(UpAxis up) {
    return kUpAxisNames[static_cast<std::size_t>(up)];
}

/// What the frame of a view round a scene is fitted to.
enum class Fit {
    sphere,  ///< the bounding sphere, as a whole
    box      ///< what the view shows of the scene, as near as it goes
};

/// What a list says of a model file.
struct ListedModel {
    std::string file;  ///< its name, without a folder
    std::string kind;  ///< of thing
    scene::Split split = scene::Split::real;
};

/// From where scenes are seen.
struct ViewRequest {
    int width_px = 1280;
    int height_px = 720;
    std::optional<int> orbit_count = {};  ///< this many round the scene, instead of its own views
    std::vector<scene::NamedDirection> directions = {};  ///< these round the scene instead
    std::optional<UpAxis> up = {};  ///< in `directions`; default: z of .stl files, else y
    /// How views round a scene are framed; any of these asks for such views, three unless said.
    std::optional<Fit> fit = {};        ///< default: the sphere
    std::optional<double> margin = {};  ///< of the frame's size on either side, of Fit::box; .04
    std::vector<std::string> objects = {};  ///< the instances that are framed; none: all
    /// A model's own cameras, as they stand at the moment that is drawn (an error if it has none).
    bool file_cameras = false;
    std::vector<CameraRequest> cameras = {};  ///< these instead of all others
    /// How all of these look; two: both, and parallel ones of a pinhole are called `NAME.parallel`.
    /// None: as a file's camera has it, parallel for `directions`, else in perspective.
    std::vector<scene::ProjectionKind> projections = {};
    std::optional<double> height_world = {};  ///< of parallel views without `cameras`; else fitted
    std::optional<double> time_s = {};     ///< when an animated scene is seen; default: rest pose
    std::optional<int> frame = {};         ///< by a stored frame's number instead
    import::ModelChoice model = {};        ///< of model files
    std::vector<ListedModel> listed = {};  ///< give these files their kinds and splits
    import::ImportLimits limits = {};      ///< how far these are trusted, and who reads them
};

/// A scene with the views it is to be drawn from.
struct SceneViews {
    scene::Scene scene;
    std::vector<scene::View> views;
    UpAxis up = UpAxis::y;         ///< in views by name, whether these are such or not
    bool has_named_views = false;  ///< views by name are what was asked for
};

/// Loads what `what` names: a catalogue scene, or a model file.
///
/// A name that is both is the catalogue's; `./name` says the file. A model is called by its stem,
/// or by its file name where a built-in scene has that stem. Throws core::Error (where = `what`)
/// that lists the catalogue if it is neither.
[[nodiscard]] scene::Scene load_scene(const std::string& what,
                                      const import::ModelChoice& choice = {},
                                      const import::ImportLimits& limits = {});

/// The axis that stands upright in views by name of what `what` names: as asked, else as the format
/// of the file has it. STL, of CAD and printing, cannot say so itself and has
/// z up, all others have y.
[[nodiscard]] UpAxis up_of(const ViewRequest& request, const std::string& what);

/// What checked_fov_deg and checked_height accept.
inline constexpr const char* kFovs_deg = "1..170";
inline constexpr const char* kHeights = "a length above 0, in the scene's units";

/// The angle of a pinhole. Throws core::Error (where = "--fov") unless it is one of kFovs_deg.
[[nodiscard]] double checked_fov_deg(double fov_deg);

/// The height that a parallel camera sees. Throws core::Error (where = "--parallel") unless it is
/// above 0.
[[nodiscard]] double checked_height(double height_world);

/// The camera that `request` asks for on a scene of that origin (Scene::origin) and ball; without a
/// name. Throws core::Error as checked_fov_deg and scene::look_at do.
[[nodiscard]] scene::Camera make_camera(const CameraRequest& request,
                                        const glm::dvec3& origin,
                                        const scene::Sphere& bounds);

/// The views of `scene` that `request` asks for.
///
/// Without a request: a catalogue scene's own, a model's three from all around. Views by name are
/// turned with the axis that is up, as Collada turns them: with z up, front looks from -y and right
/// from +x; with x up, front from +z and right from -y. Without `up`
/// it is y here. Two scenes of one
/// name in a suite are the caller's to rename; one that is posed is called with its frame or time
/// (`knight.frame12`, `gear.1.5s`). Throws core::Error for a size outside 1..16384 a side or over
/// 2^27 pixels, a field of view outside 1..170 degrees, file cameras that are not there, a framed
/// object that is not there, or a moment that the scene's animation does not have.
[[nodiscard]] SceneViews make_scene_views(scene::Scene scene, const ViewRequest& request);

/// The scenes that `names` name (see load_scene); no names: the whole catalogue.
///
/// All are loaded before anything is drawn, so that a bad file among twenty costs no work. A second
/// scene of one name is called `name.2`.
[[nodiscard]] std::vector<SceneViews> load_scenes(const std::vector<std::string>& names,
                                                  const ViewRequest& request);

/// The scene that `what` names with one of its views: the one called `view_name`, "" for the first.
/// Where no views were asked for, that may be one of scene::drawing_views(), too. Throws
/// core::Error that lists the views' names if none is called so.
[[nodiscard]] SceneViews load_one_view(const std::string& what,
                                       const std::string& view_name,
                                       const ViewRequest& request);

/// Throws core::Error (where = "--size") unless an image of this size can be drawn.
void check_size(int width_px, int height_px);

}  // namespace ink::harness
