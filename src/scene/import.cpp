#include "scene/import.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "scene/child_process.h"
#include "scene/file_claims.h"
#include "scene/scene_stream.h"

namespace ink::scene {
namespace {

constexpr const char* kChildName = "inkbench_import";
constexpr const char* kSomeFormats =
    ".obj, .ply, .stl, .off, .3ds, .glb, .gltf, .fbx, .dae, .md2, .md3, .mdl and others that "
    "Assimp "
    "reads";
constexpr const char* kWholeFile = "a whole, valid model file";
constexpr int kCannotStart = 127;  // of the dynamic loader, and of a failed exec
constexpr std::size_t kHeadBytes = 64 << 10;
constexpr std::size_t kTailBytes = 4 << 10;
constexpr std::size_t kMostNameChars = 80;
constexpr std::size_t kMostReasonChars = 160;

/// Throws about one file.
class Complaint {
  public:
    explicit Complaint(std::filesystem::path path) : where_(path.string()) {}
    [[noreturn]] void operator()(const std::string& what, const std::string& accepted = {}) const {
        throw core::Error(where_, what, accepted);
    }

  private:
    std::string where_;
};

/// Foreign text as one printable line of plain characters, shortened to `most`.
std::string printable(const std::string& text, std::size_t most) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isspace(byte) != 0 || byte == 0) {
            if (!line.empty() && line.back() != ' ') line.push_back(' ');
        } else {
            line.push_back(byte > 0x20 && byte < 0x7f ? c : '?');
        }
    }
    while (!line.empty() && line.back() == ' ')
        line.pop_back();
    if (line.size() > most) line = line.substr(0, most - 3) + "...";
    return line;
}

std::string lower_case(std::string text) {
    for (char& c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string with_unit(std::uint64_t bytes) {
    constexpr std::array kUnits{"bytes", "KiB", "MiB", "GiB"};
    std::size_t unit = 0;
    auto amount = static_cast<double>(bytes);
    for (; amount >= 1024 && unit + 1 < kUnits.size(); ++unit)
        amount /= 1024;
    return fmt::format("{:.4g} {}", amount, kUnits[unit]);
}

/// The file's size, if it is one that can be read at all.
std::uint64_t readable_size(const std::filesystem::path& path, const Complaint& complain) {
    // Without O_NONBLOCK the opening of a pipe would wait for its writer.
    const int fd = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) {
        if (errno == ENOENT) complain("no such file", "the path of a model");
        complain(fmt::format("cannot be opened: {}", std::generic_category().message(errno)));
    }
    struct stat status {};
    const bool is_known = fstat(fd, &status) == 0;
    close(fd);
    if (is_known && S_ISDIR(status.st_mode)) complain("is a folder", "the path of a model file");
    if (!is_known || !S_ISREG(status.st_mode)) complain("is not a regular file");
    if (status.st_size == 0) complain("the file is empty", kSomeFormats);
    return static_cast<std::uint64_t>(status.st_size);
}

/// The number of lines, the last one counted even without its end.
std::uint64_t count_lines(std::ifstream& file) {
    file.clear();
    file.seekg(0);
    std::uint64_t lines = 0;
    std::vector<char> block(kHeadBytes);
    char last = '\n';
    while (file.read(block.data(), static_cast<std::streamsize>(block.size())) ||
           file.gcount() > 0) {
        const auto end = block.begin() + file.gcount();
        lines += static_cast<std::uint64_t>(std::count(block.begin(), end, '\n'));
        last = *(end - 1);
    }
    return lines + (last == '\n' ? 0 : 1);
}

std::vector<std::byte> read_at(std::ifstream& file, std::uint64_t offset, std::size_t most) {
    std::vector<std::byte> bytes(most);
    file.clear();
    file.seekg(static_cast<std::streamoff>(offset));
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(most));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return bytes;
}

/// What the header promises; throws at once if the file is too short for it.
FileClaims claims_of(const std::filesystem::path& path, const Complaint& complain) {
    const std::uint64_t size = readable_size(path, complain);
    std::ifstream file(path, std::ios::binary);
    const auto head = read_at(file, 0, kHeadBytes);
    const auto tail = read_at(file, size > kTailBytes ? size - kTailBytes : 0, kTailBytes);
    const FileClaims claims = read_claims(head, tail, size, lower_case(path.extension().string()));
    if (claims.bytes && size < *claims.bytes) {
        complain(fmt::format("the file is cut short: its header promises {} bytes, it has {}",
                             *claims.bytes,
                             size),
                 kWholeFile);
    }
    if (claims.lines && count_lines(file) < *claims.lines) {
        complain(fmt::format("the file is cut short: its header promises {} lines", *claims.lines),
                 kWholeFile);
    }
    if (claims.ends_early) complain("the file is cut short: its end mark is missing", kWholeFile);
    return claims;
}

std::filesystem::path find_child(const ImportLimits& limits) {
    std::filesystem::path child = limits.child;
    if (child.empty()) {
        std::error_code error;
        child = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / kChildName;
    }
    if (access(child.c_str(), X_OK) != 0) {
        throw core::Error(
            child.string(),
            "the program that reads models is missing",
            fmt::format("{} in the folder of inkbench, as the build puts it", kChildName));
    }
    return child;
}

[[noreturn]] void complain_of_time(const Complaint& complain, const ImportLimits& limits) {
    complain(fmt::format("reading it took longer than {:g} s and was stopped", limits.wall_s));
}

[[noreturn]] void complain_of_signal(const Complaint& complain,
                                     int number,
                                     const ImportLimits& limits) {
    const char* abbreviation = sigabbrev_np(number);
    const std::string name = abbreviation == nullptr ? fmt::format("signal {}", number)
                                                     : fmt::format("SIG{}", abbreviation);
    if (number == SIGXCPU) complain_of_time(complain, limits);
    if (number == SIGINT || number == SIGTERM || number == SIGHUP || number == SIGQUIT) {
        complain(fmt::format("reading it was interrupted ({})", name));
    }
    if (number == SIGKILL) {
        complain(
            "its reader was killed from outside (SIGKILL); the machine may be short of memory");
    }
    complain(fmt::format(
                 "it crashed its reader ({}); the file is damaged or its format unsupported", name),
             kSomeFormats);
}

/// The whole reply of a child that came to a good end.
ImportReply reply_of(const ChildOutcome& outcome,
                     const Complaint& complain,
                     const ImportLimits& limits) {
    switch (outcome.end) {
        case ChildEnd::not_started:
            complain(fmt::format("its reader could not be started: {}",
                                 std::generic_category().message(outcome.code)));
        case ChildEnd::timed_out:
            complain_of_time(complain, limits);
        case ChildEnd::flooded:
            complain(
                fmt::format("it holds more scene data than {}", with_unit(limits.output_bytes)));
        case ChildEnd::signalled:
            complain_of_signal(complain, outcome.code, limits);
        case ChildEnd::exited:
            break;
    }
    if (outcome.code == kCannotStart) {
        complain(fmt::format("its reader cannot start within {}", with_unit(limits.memory_bytes)));
    }
    if (outcome.code != 0) {
        complain(fmt::format("its reader failed without an answer (exit code {})", outcome.code));
    }
    auto reply = read_reply(outcome.output);
    if (!reply) complain("its reader gave a damaged answer");
    return std::move(*reply);
}

/// Throws unless the reply holds a scene with all that the file's header promised.
void check_reply(const ImportReply& reply, const FileClaims& claims, const Complaint& complain) {
    switch (reply.status) {
        case ImportStatus::unknown_format:
            complain("is not a kind of model file that can be read", kSomeFormats);
        case ImportStatus::wrong_content:
            complain("its content is not what its extension says, nor any other model", kWholeFile);
        case ImportStatus::not_readable:
            complain(fmt::format("cannot be read as a model; Assimp says \"{}\"",
                                 printable(reply.reason, kMostReasonChars)),
                     kWholeFile);
        case ImportStatus::out_of_memory:
        case ImportStatus::scene:
            break;
    }
    if (claims.vertices && reply.vertices_read < *claims.vertices) {
        complain(fmt::format("only {} of the {} vertices in its header could be read",
                             reply.vertices_read,
                             *claims.vertices),
                 kWholeFile);
    }
    if (claims.faces && reply.faces_read < *claims.faces) {
        complain(fmt::format("only {} of the {} faces in its header could be read",
                             reply.faces_read,
                             *claims.faces),
                 kWholeFile);
    }
}

bool is_usable_normal(const glm::vec3& n) {
    const double length = glm::length(glm::dvec3(n));
    return std::isfinite(length) && length > 0;
}

bool has_area(const Mesh& mesh, const Triangle& triangle) {
    const glm::dvec3 a = mesh.positions[triangle[0]];
    const glm::dvec3 b = mesh.positions[triangle[1]];
    const glm::dvec3 c = mesh.positions[triangle[2]];
    return glm::length(glm::cross(b - a, c - a)) > 0;
}

/// Makes the normals unit, or drops them all if a triangle that can be seen uses one that is none
/// (many STL writers leave zeros): a mesh has normals or it has not.
void tidy_normals(Mesh& mesh) {
    const auto is_bad = [&](std::uint32_t v) { return !is_usable_normal(mesh.normals[v]); };
    const bool has_bad =
        std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& triangle) {
            return !mesh.normals.empty() && std::any_of(triangle.begin(), triangle.end(), is_bad) &&
                   has_area(mesh, triangle);
        });
    if (has_bad) mesh.normals.clear();
    for (glm::vec3& n : mesh.normals) {
        n = is_usable_normal(n) ? glm::vec3(glm::normalize(glm::dvec3(n))) : glm::vec3(0, 0, 1);
    }
}

/// The checks of check_scene that must come before anything walks the meshes, and those that it
/// leaves out.
void check_counts(const Scene& scene, const ImportLimits& limits, const Complaint& complain) {
    const auto is_placed = [&](const Instance& instance) {
        return instance.mesh < scene.meshes.size();
    };
    if (!std::all_of(scene.instances.begin(), scene.instances.end(), is_placed)) {
        complain("its reader placed a mesh that it did not hand over");
    }
    const std::size_t triangles = triangle_count(scene);
    if (triangles == 0) complain("it holds no triangle", "a model with at least one");
    if (triangles > limits.triangles) {
        complain(fmt::format("it holds {} triangles", triangles),
                 fmt::format("up to {}", limits.triangles));
    }
}

/// check_scene, with the path in front of what it says.
void check_numbers(const Scene& scene, const Complaint& complain) {
    try {
        check_scene(scene);
    } catch (const core::Error& error) {
        // "name, mesh 3" without the name, for the path stands there already.
        const std::size_t name_end = std::min(error.where().size(), scene.name.size() + 2);
        const std::string place = error.where().substr(name_end);
        complain((place.empty() ? place : place + ": ") + error.what_happened(), error.accepted());
    }
    const Sphere bounds = bounding_sphere(scene);
    if (!std::isfinite(bounds.radius)) complain("its extent is not finite", "finite numbers");
}

/// A camera's name as a word fit for tables and file names, not yet in `taken`.
std::string camera_name(const std::string& wanted, std::set<std::string>& taken) {
    std::string base = wanted.substr(0, kMostNameChars);
    for (char& c : base) {
        const bool is_plain =
            (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        if (!is_plain && c != '-') c = '_';
    }
    if (base.empty()) base = "camera";
    std::string name = base;
    for (int i = 2; !taken.insert(name).second; ++i)
        name = fmt::format("{}_{}", base, i);
    return name;
}

std::vector<Camera> usable_cameras(const std::vector<ImportedCamera>& imported,
                                   const Sphere& bounds) {
    std::vector<Camera> cameras;
    std::set<std::string> taken;
    for (const ImportedCamera& from : imported) {
        constexpr double kLeastFov_rad = 1e-3;
        constexpr double kMostFov_rad = std::numbers::pi - 1e-3;
        if (!(from.fov_y_rad >= kLeastFov_rad && from.fov_y_rad <= kMostFov_rad)) continue;
        try {
            Camera camera =
                look_at(from.eye_world, from.target_world, from.up_world, from.fov_y_rad);
            camera.name = camera_name(from.name, taken);
            fit_clip_range(camera, bounds);
            cameras.push_back(std::move(camera));
        } catch (const core::Error&) {
            continue;  // it looks nowhere, which does not make the model worse
        }
    }
    return cameras;
}

}  // namespace

Scene import_scene(const std::filesystem::path& path, const ImportLimits& limits) {
    const Complaint complain(path);
    const FileClaims claims = claims_of(path, complain);
    const std::filesystem::path child = find_child(limits);
    ChildOutcome outcome =
        run_child(child, path.string(), {limits.wall_s, limits.memory_bytes, limits.output_bytes});
    ImportReply reply = reply_of(outcome, complain, limits);
    outcome.output = {};
    if (reply.status == ImportStatus::out_of_memory) {
        complain(
            fmt::format("reading it takes more memory than {}", with_unit(limits.memory_bytes)));
    }
    check_reply(reply, claims, complain);

    Scene scene;
    scene.name = path.stem().string();
    scene.meshes = std::move(reply.meshes);
    scene.instances = std::move(reply.instances);
    check_counts(scene, limits, complain);
    // Bad normals are dropped, bad vertices are not forgiven; indices are checked before both are
    // read.
    std::vector<std::vector<glm::vec3>> normals;
    for (Mesh& mesh : scene.meshes) {
        mesh.name = printable(mesh.name, kMostNameChars);
        normals.push_back(std::exchange(mesh.normals, {}));
    }
    for (Instance& instance : scene.instances)
        instance.name = printable(instance.name, kMostNameChars);
    check_numbers(scene, complain);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
        if (normals[m].size() != scene.meshes[m].positions.size()) continue;
        scene.meshes[m].normals = std::move(normals[m]);
        tidy_normals(scene.meshes[m]);
    }
    scene.cameras = usable_cameras(reply.cameras, bounding_sphere(scene));
    return scene;
}

}  // namespace ink::scene
