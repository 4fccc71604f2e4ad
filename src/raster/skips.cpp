#include "raster/skips.h"

namespace ink::raster {

const std::array<SkipInfo, kSkipCount>& skip_infos() {
    static constexpr std::array<SkipInfo, kSkipCount> kInfos = {{
        {Skip::attributes, "attributes", "channels", "Channels that the code gives no weight."},
        {Skip::frustum_culling,
         "frustum_culling",
         "clusters",
         "Clusters of triangles outside the image."},
        {Skip::back_face_culling,
         "back_face_culling",
         "clusters",
         "Back-facing clusters of solids that are watertight but for holes elsewhere."},
        {Skip::no_sample, "no_sample", "triangles", "Triangles that cover no pixel centre."},
        {Skip::occlusion_culling,
         "occlusion_culling",
         "triangles",
         "Triangles behind what was already drawn."},
        {Skip::empty_tiles, "empty_tiles", "tiles", "Tiles to which nothing is drawn."},
        {Skip::flat_tiles, "flat_tiles", "tiles", "Tiles inside one plane: the filter gives 0."},
        {Skip::temporal_reuse,
         "temporal_reuse",
         "tiles",
         "Tiles in which nothing moved since the last frame."},
    }};
    return kInfos;
}

}  // namespace ink::raster
