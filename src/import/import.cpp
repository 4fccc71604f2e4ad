#include "import/import.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <system_error>
#include <utility>

#include "core/error.h"
#include "core/program_folder.h"
#include "import/child_process.h"
#include "import/imported_scene.h"
#include "import/other_formats.h"
#include "import/printable.h"

namespace ink::import {
namespace {

constexpr const char* kChildName = "inkbench_import";
constexpr const char* kWholeFile = "a whole, valid model file";
constexpr int kCannotStart = 127;  // of the dynamic loader, and of a failed exec
constexpr std::size_t kMostReasonChars = 320;

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

std::string with_unit(std::uint64_t bytes) {
    constexpr std::array kUnits{"bytes", "KiB", "MiB", "GiB"};
    std::size_t unit = 0;
    auto amount = static_cast<double>(bytes);
    for (; amount >= 1024 && unit + 1 < kUnits.size(); ++unit)
        amount /= 1024;
    return fmt::format("{:.4g} {}", amount, kUnits[unit]);
}

/// Throws unless the file is one that can be read at all.
void check_file(const std::filesystem::path& path, const Complaint& complain) {
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
    if (status.st_size == 0) complain("the file is empty", std::string(kReadEndings));
}

std::filesystem::path find_child(const ImportLimits& limits) {
    std::filesystem::path child = limits.child;
    if (child.empty()) child = core::program_folder() / kChildName;
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
             std::string(kReadEndings));
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

/// Throws unless the reply holds a scene.
void check_reply(const ImportReply& reply, const ImportLimits& limits, const Complaint& complain) {
    switch (reply.status) {
        case ImportStatus::unknown_format:
            complain("is not a kind of model file that can be read", std::string(kReadEndings));
        case ImportStatus::wrong_content:
            complain("its content is not what its extension says, nor any other model", kWholeFile);
        case ImportStatus::damaged:
            complain("is damaged; " + printable(reply.reason, kMostReasonChars));
        case ImportStatus::refused:
            complain(printable(reply.reason, kMostReasonChars));
        case ImportStatus::out_of_memory:
            complain(fmt::format("reading it takes more memory than {}",
                                 with_unit(limits.memory_bytes)));
        case ImportStatus::scene:
            break;
    }
}

/// As many as it has positions, or none; (0,0) for what is no number.
std::vector<glm::vec2> take_texcoords(ImportedMesh& mesh) {
    std::vector<glm::vec2> taken = std::move(mesh.texcoords);
    if (!taken.empty()) taken.resize(mesh.positions.size());
    for (glm::vec2& uv : taken)
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = glm::vec2(0);
    return taken;
}

}  // namespace

ImportedModel import_model(const std::filesystem::path& path,
                           const ModelChoice& choice,
                           const ImportLimits& limits) {
    const Complaint complain(path);
    check_file(path, complain);
    const std::filesystem::path child = find_child(limits);
    std::vector<std::string> arguments{path.string(), choice.animation};
    if (choice.has_texcoords) arguments.emplace_back("texcoords");
    ChildOutcome outcome = run_child(child,
                                     arguments,
                                     {.wall_s = limits.wall_s,
                                      .memory_bytes = limits.memory_bytes,
                                      .output_bytes = limits.output_bytes});
    ImportReply reply = reply_of(outcome, complain, limits);
    outcome.output = {};
    check_reply(reply, limits, complain);
    FilePlaces places;
    for (const ImportedInstance& instance : reply.instances)
        places.node_of_instance.push_back(instance.file_node);
    std::vector<std::vector<glm::vec2>> texcoords;
    for (ImportedMesh& mesh : reply.meshes) {
        places.parts_of_mesh.push_back(mesh.parts);
        texcoords.push_back(take_texcoords(mesh));
    }
    std::vector<glm::vec4> colors = std::move(reply.base_colors);
    for (glm::vec4& color : colors) {
        for (int k = 0; k < 4; ++k)
            color[k] = color[k] >= 0 ? std::min(color[k], 1.0F) : 1;  // 1 where it is no number
    }
    scene::Scene scene =
        scene_from_reply(std::move(reply), path, limits.triangles, choice.material_seams);
    return {std::move(scene), std::move(places), std::move(colors), std::move(texcoords)};
}

scene::Scene import_scene(const std::filesystem::path& path,
                          const ModelChoice& choice,
                          const ImportLimits& limits) {
    return import_model(path, choice, limits).scene;
}

}  // namespace ink::import
