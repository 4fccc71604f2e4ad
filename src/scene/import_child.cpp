// inkbench_import FILE: reads one model with Assimp and writes it to standard output as a scene
// stream.
//
// A program of its own because Assimp may crash, hang or eat memory on a damaged file; the parent
// (import.cpp) sets the limits before it starts this one. The only file that includes Assimp.

#include <assimp/camera.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <iterator>
#include <new>
#include <utility>

#include "scene/camera_3ds.h"
#include "scene/scene_stream.h"
#ifdef INK_IMPORT_FAULTS
#include "scene/import_faults.h"
#endif

namespace ink::scene {
namespace {

static_assert(sizeof(aiVector3D) == sizeof(glm::vec3),
              "an Assimp built for doubles loses nothing here");

enum ExitCode { kSuccess = 0, kWriteFailed = 1, kUsage = 2 };

struct PlacedNode {
    const aiNode* node;
    glm::dmat4 world_from_node;
};

/// Where the stream goes, and an answer kept ready for the moment in which nothing can be
/// allocated.
struct Output {
    int fd = -1;
    std::array<char, 256> out_of_memory{};
    std::size_t out_of_memory_bytes = 0;
};
Output output;  // NOLINT: a new-handler takes no arguments

void write_all(const void* data, std::size_t size) {
    const char* next = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t n = write(output.fd, next, size);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) _exit(kWriteFailed);  // the parent has gone
        next += n;
        size -= static_cast<std::size_t>(n);
    }
}

/// Assimp swallows bad_alloc and goes on with half a scene; so it must not be thrown.
[[noreturn]] void answer_out_of_memory() {
    write_all(output.out_of_memory.data(), output.out_of_memory_bytes);
    _exit(kSuccess);
}

/// Keeps the stream for us alone: whatever a library prints to standard output is dropped.
void prepare_output() {
    output.fd = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    ImportReply reply;
    reply.status = ImportStatus::out_of_memory;
    write_reply(reply, [](const void* data, std::size_t size) {
        std::memcpy(output.out_of_memory.data() + output.out_of_memory_bytes, data, size);
        output.out_of_memory_bytes += size;
    });
    std::set_new_handler(answer_out_of_memory);
}

glm::dvec3 to_glm(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

/// The affine part of an Assimp matrix (which is row by row), in double.
glm::dmat4 to_glm(const aiMatrix4x4& m) {
    return glm::transpose(glm::dmat4(
        m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, 0, 0, 0, 1));
}

/// All nodes, parents first, in the file's order. No recursion: a hostile tree is deep.
std::vector<PlacedNode> placed_nodes(const aiScene& scene) {
    std::vector<PlacedNode> placed;
    if (scene.mRootNode == nullptr) return placed;
    std::vector<PlacedNode> open{{scene.mRootNode, to_glm(scene.mRootNode->mTransformation)}};
    while (!open.empty()) {
        const PlacedNode current = open.back();
        open.pop_back();
        placed.push_back(current);
        for (unsigned c = current.node->mNumChildren; c-- > 0;) {
            const aiNode* child = current.node->mChildren[c];
            open.push_back({child, current.world_from_node * to_glm(child->mTransformation)});
        }
    }
    return placed;
}

/// The triangles of a mesh with its vertices untouched; faces of fewer corners are left out.
Mesh convert_mesh(const aiMesh& from) {
    Mesh mesh;
    mesh.name = from.mName.C_Str();
    const auto copy = [&](const aiVector3D* vectors, std::vector<glm::vec3>& to) {
        if (vectors == nullptr) return;
        to.resize(from.mNumVertices);
        if (!to.empty()) std::memcpy(to.data(), vectors, to.size() * sizeof(glm::vec3));
    };
    copy(from.mVertices, mesh.positions);
    copy(from.mNormals, mesh.normals);
    mesh.triangles.reserve(from.mNumFaces);
    for (unsigned f = 0; f < from.mNumFaces; ++f) {
        const aiFace& face = from.mFaces[f];
        if (face.mNumIndices != 3) continue;
        mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
    mesh.materials.assign(mesh.triangles.empty() ? 0 : 1,
                          from.mMaterialIndex);  // one stands for all
    return mesh;
}

/// Meshes with triangles, and one instance for each use of one by a node.
void convert_meshes(const aiScene& scene,
                    const std::vector<PlacedNode>& nodes,
                    ImportReply& reply) {
    constexpr std::uint32_t kDropped = ~0U;
    std::vector<std::uint32_t> index_of(scene.mNumMeshes, kDropped);
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        Mesh mesh = convert_mesh(*scene.mMeshes[m]);
        if (mesh.triangles.empty()) continue;
        index_of[m] = static_cast<std::uint32_t>(reply.meshes.size());
        reply.meshes.push_back(std::move(mesh));
    }
    for (const PlacedNode& placed : nodes) {
        for (unsigned i = 0; i < placed.node->mNumMeshes; ++i) {
            const unsigned m = placed.node->mMeshes[i];
            if (m >= scene.mNumMeshes || index_of[m] == kDropped) continue;
            std::string name = placed.node->mName.C_Str();
            if (placed.node->mNumMeshes > 1) name += '/' + reply.meshes[index_of[m]].name;
            reply.instances.push_back({index_of[m], placed.world_from_node, std::move(name)});
        }
    }
}

/// The name of the reader that took the file, such as "glTF2 Importer".
std::string reader_name(const Assimp::Importer& importer) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* about =
        index < 0 ? nullptr : importer.GetImporterInfo(static_cast<std::size_t>(index));
    return about == nullptr ? std::string{} : about->mName;
}

/// Assimp's glTF reader before 5.3 multiplies the angle by the aspect (its issue 4435).
bool multiplies_gltf_angles() {
    return aiGetVersionMajor() < 5 || (aiGetVersionMajor() == 5 && aiGetVersionMinor() < 3);
}

/// The camera's vertical angle. Assimp's documentation speaks of half the horizontal angle, its
/// readers (glTF, FBX, Collada; its issue 2256) store all of it. Where a file names no aspect, the
/// glTF reader hands on the vertical angle as it is, which an aspect of 1 undoes; for the others it
/// is a guess.
double vertical_fov_rad(const aiCamera& camera, bool is_gltf) {
    const double aspect = camera.mAspect > 0.05F && camera.mAspect < 20 ? camera.mAspect : 1;
    if (is_gltf && multiplies_gltf_angles()) return camera.mHorizontalFOV / aspect;
    return 2 * std::atan(std::tan(camera.mHorizontalFOV / 2.0) / aspect);
}

ImportedCamera convert_camera(const aiCamera& from,
                              const std::vector<PlacedNode>& nodes,
                              bool is_gltf) {
    const auto home = std::find_if(nodes.begin(), nodes.end(), [&](const PlacedNode& placed) {
        return placed.node->mName == from.mName;
    });
    const glm::dmat4 world = home == nodes.end() ? glm::dmat4{1} : home->world_from_node;
    // A glTF camera sits in its node's origin; Assimp writes the node's translation here once more.
    const glm::dvec3 eye_node = is_gltf ? glm::dvec3{0} : to_glm(from.mPosition);
    const glm::dvec3 eye = world * glm::dvec4(eye_node, 1);
    return {.name = from.mName.C_Str(),
            .eye_world = eye,
            .target_world = eye + glm::dmat3(world) * to_glm(from.mLookAt),
            .up_world = glm::dmat3(world) * to_glm(from.mUp),
            .fov_y_rad = vertical_fov_rad(from, is_gltf)};
}

/// The cameras of a 3DS file by our own reader, turned and scaled as Assimp turned the model.
std::vector<ImportedCamera> cameras_of_3ds(const std::filesystem::path& path,
                                           const glm::dmat4& root) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    std::vector<ImportedCamera> cameras = read_3ds_cameras(std::as_bytes(std::span(bytes)));
    for (ImportedCamera& camera : cameras) {
        camera.eye_world = root * glm::dvec4(camera.eye_world, 1);
        camera.target_world = root * glm::dvec4(camera.target_world, 1);
        camera.up_world = glm::dmat3(root) * camera.up_world;
    }
    return cameras;
}

std::vector<ImportedCamera> convert_cameras(const aiScene& scene,
                                            const std::vector<PlacedNode>& nodes,
                                            bool is_gltf) {
    std::vector<ImportedCamera> cameras;
    for (unsigned c = 0; c < scene.mNumCameras; ++c) {
        const aiCamera& camera = *scene.mCameras[c];
        const bool is_parallel = camera.mOrthographicWidth > 0;  // we have no such camera
        if (!is_parallel) cameras.push_back(convert_camera(camera, nodes, is_gltf));
    }
    return cameras;
}

ImportReply refusal(const Assimp::Importer& importer, const std::filesystem::path& path) {
    ImportReply reply;
    reply.reason = importer.GetErrorString();
    reply.status = ImportStatus::not_readable;
    if (reply.reason.starts_with("No suitable reader found")) {
        const bool is_known = importer.IsExtensionSupported(path.extension().string());
        reply.status = is_known ? ImportStatus::wrong_content : ImportStatus::unknown_format;
    }
    return reply;
}

ImportReply read_model(const std::filesystem::path& path) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(path.string(), 0);
    if (scene == nullptr) return refusal(importer, path);
    ImportReply reply;
    // Counted before triangulation: these are what the file's header promises.
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        reply.faces_read += scene->mMeshes[m]->mNumFaces;
        reply.vertices_read += scene->mMeshes[m]->mNumVertices;
    }
    if (reply.faces_read == 0) return reply;  // the validation would only say it less clearly
    // Points and lines stay in and are dropped with the faces that are no triangles: Assimp's own
    // sorting by kind would split meshes and reorder vertices.
    scene = importer.ApplyPostProcessing(aiProcess_ValidateDataStructure | aiProcess_Triangulate);
    if (scene == nullptr) return refusal(importer, path);
    const std::vector<PlacedNode> nodes = placed_nodes(*scene);
    convert_meshes(*scene, nodes, reply);
    const std::string reader = reader_name(importer);
    const bool is_3ds = reader.starts_with("Discreet 3DS") && !nodes.empty();
    reply.cameras = is_3ds ? cameras_of_3ds(path, nodes.front().world_from_node)
                           : convert_cameras(*scene, nodes, reader.starts_with("glTF2"));
    return reply;
}

}  // namespace
}  // namespace ink::scene

int main(int argc, char** argv) {
    using namespace ink::scene;
    if (argc != 2) {
        std::fputs("usage: inkbench_import FILE > STREAM\ninkbench starts it; see --help there.\n",
                   stderr);
        return kUsage;
    }
    prepare_output();
#ifdef INK_IMPORT_FAULTS
    provoke_fault(argv[1], output.fd);
#endif
    write_reply(read_model(argv[1]), write_all);
    return kSuccess;
}
