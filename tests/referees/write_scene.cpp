// Writes a catalogue scene as OBJ, for tests that are to share nothing with the program but a file.
//
//     write_scene NAME FILE.obj   writes it, an `o` for each instance; prints its first camera

#include <fmt/format.h>

#include <cstddef>
#include <fstream>
#include <glm/trigonometric.hpp>
#include <string>

#include "catalogue/catalogue.h"
#include "core/error.h"

namespace {

using ink::scene::Scene;

std::string numbers(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", v.x, v.y, v.z);
}

void write_obj(const Scene& scene, std::ofstream& file) {
    std::size_t first = 1;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const ink::scene::Instance& instance = scene.instances[i];
        const ink::scene::Mesh& mesh = scene.meshes[instance.mesh];
        file << fmt::format("o part{}\n", i);
        for (const glm::vec3& p_object : mesh.positions) {
            const glm::vec3 p{ink::scene::to_world(instance, p_object)};
            file << fmt::format("v {:.12f} {:.12f} {:.12f}\n", p.x, p.y, p.z);
        }
        for (const auto& t : mesh.triangles)
            file << fmt::format("f {} {} {}\n", first + t[0], first + t[1], first + t[2]);
        first += mesh.positions.size();
    }
}

void print_camera(const ink::scene::Camera& camera) {
    const glm::dmat3 world_from_view = glm::transpose(camera.view_from_world);
    fmt::print(R"({{"eye": {}, "forward": {}, "up": {}, "fov_deg": {}}})"
               "\n",
               numbers(camera.eye_world),
               numbers(-world_from_view[2]),
               numbers(world_from_view[1]),
               glm::degrees(camera.fov_y_rad));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const Scene scene = ink::catalogue::make_catalogue_scene(argv[1]);
        std::ofstream file(argv[2]);
        write_obj(scene, file);
        print_camera(scene.cameras.front());
        return file.good() ? 0 : 1;
    } catch (const ink::core::Error& error) {
        fmt::print(stderr, "write_scene: {}\n", error.what());
        return 2;
    }
}
