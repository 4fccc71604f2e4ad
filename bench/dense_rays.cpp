#include "bench/dense_rays.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "truth/embree.h"

namespace ink::bench {
namespace {

constexpr int kGrid = 16;    ///< rays a pixel, each way
constexpr int kPacket = 16;  ///< a square of 4 x 4 rays
constexpr int kBlock = 4;    ///< its side
alignas(64) constexpr std::array<int, kPacket> kAll = {
    -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

using Ids = std::array<std::uint32_t, kPacket>;

bool is_one(const Ids& ids, std::uint32_t id) {
    return std::all_of(ids.begin(), ids.end(), [id](std::uint32_t i) { return i == id; });
}

}  // namespace

struct DenseRays::Tree {
    scene::View view;
    scene::Projection projection;
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = rtcNewScene(device);

    explicit Tree(const scene::View& view_) : view(view_), projection(view_) {}
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    /// The triangles seen by 4 x 4 rays of the sub-pixel grid from (x, y) on, `step` apart.
    [[nodiscard]] Ids cast(double x_px, double y_px, double step_px) const {
        RTCRayHit16 packet{};
        for (int i = 0; i < kPacket; ++i) {
            const glm::dvec3 d =
                projection.ray_world(x_px + step_px * (i % kBlock), y_px + step_px * (i / kBlock));
            packet.ray.dir_x[i] = static_cast<float>(d.x);
            packet.ray.dir_y[i] = static_cast<float>(d.y);
            packet.ray.dir_z[i] = static_cast<float>(d.z);
            packet.ray.tnear[i] = static_cast<float>(view.camera.near);
            packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
            packet.ray.mask[i] = 0xffffffffU;
            packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
        }
        truth::embree::Context context;
        truth::embree::init_context(context);
        truth::embree::intersect_16(kAll.data(), scene, context, nullptr, packet);
        Ids ids;
        std::copy(packet.hit.primID, packet.hit.primID + kPacket, ids.begin());
        return ids;
    }

    /// All 256 rays of a pixel; whether they see more than one thing.
    [[nodiscard]] bool is_mixed(int x, int y) const {
        constexpr double kStep = 1.0 / kGrid;
        bool is_pure = true;
        std::uint32_t first = 0;
        for (int block = 0; block < kPacket; ++block) {
            const Ids ids = cast(x + (block % kBlock * kBlock + 0.5) * kStep,
                                 y + (block / kBlock * kBlock + 0.5) * kStep,
                                 kStep);
            if (block == 0) first = ids[0];
            is_pure = is_pure && is_one(ids, first);
        }
        return !is_pure;
    }
};

DenseRays::DenseRays(const scene::Scene& scene, const scene::View& view)
    : tree_(std::make_unique<Tree>(view)) {
    rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    std::vector<float> positions;
    std::vector<std::uint32_t> indices;
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const auto first = static_cast<std::uint32_t>(positions.size() / 3);
        for (const glm::vec3& p_object : mesh.positions) {
            const glm::dvec3 p = scene::to_world(instance, p_object) - view.camera.eye_world;
            for (int i = 0; i < 3; ++i)
                positions.push_back(static_cast<float>(p[i]));
        }
        for (const scene::Triangle& t : mesh.triangles) {
            for (const std::uint32_t v : t)
                indices.push_back(first + v);
        }
    }
    auto* vertex_buffer = static_cast<float*>(rtcSetNewGeometryBuffer(geometry,
                                                                      RTC_BUFFER_TYPE_VERTEX,
                                                                      0,
                                                                      RTC_FORMAT_FLOAT3,
                                                                      3 * sizeof(float),
                                                                      positions.size() / 3));
    std::copy(positions.begin(), positions.end(), vertex_buffer);
    auto* index_buffer =
        static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry,
                                                            RTC_BUFFER_TYPE_INDEX,
                                                            0,
                                                            RTC_FORMAT_UINT3,
                                                            3 * sizeof(std::uint32_t),
                                                            indices.size() / 3));
    std::copy(indices.begin(), indices.end(), index_buffer);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tree_->scene);
}

DenseRays::~DenseRays() = default;

DenseCounts DenseRays::cast_everywhere() const {
    DenseCounts counts;
    for (int y = 0; y < tree_->view.height_px; ++y) {
        for (int x = 0; x < tree_->view.width_px; ++x)
            counts.mixed_px += tree_->is_mixed(x, y) ? 1U : 0U;
    }
    counts.rays = static_cast<std::size_t>(tree_->view.width_px) * tree_->view.height_px * 256;
    return counts;
}

DenseCounts DenseRays::cast_adaptive() const {
    // Rays at the pixels' own corners are shared by four pixels: a pixel whose corners and those of
    // its eight neighbours see one triangle is taken to show nothing else.
    const int width = tree_->view.width_px, height = tree_->view.height_px;
    const int columns = (width + 1 + kBlock) / kBlock * kBlock;
    const int rows = (height + 1 + kBlock) / kBlock * kBlock;
    std::vector<std::uint32_t> corner(static_cast<std::size_t>(columns) * rows);
    for (int y = 0; y < rows; y += kBlock) {
        for (int x = 0; x < columns; x += kBlock) {
            const Ids ids = tree_->cast(x, y, 1);
            for (int i = 0; i < kPacket; ++i)
                corner[static_cast<std::size_t>(y + i / kBlock) * columns + x + i % kBlock] =
                    ids[static_cast<std::size_t>(i)];
        }
    }
    DenseCounts counts;
    counts.rays = corner.size();
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::uint32_t id = corner[static_cast<std::size_t>(y) * columns + x];
            bool is_pure = true;
            for (int j = std::max(0, y - 1); j <= y + 2 && is_pure; ++j) {
                for (int i = std::max(0, x - 1); i <= x + 2; ++i)
                    is_pure = is_pure && corner[static_cast<std::size_t>(j) * columns + i] == id;
            }
            if (is_pure) continue;
            counts.rays += 256;
            counts.mixed_px += tree_->is_mixed(x, y) ? 1U : 0U;
        }
    }
    return counts;
}

}  // namespace ink::bench
