// inkbench_import FILE [ANIMATION]: reads one model and writes it to standard output as a scene
// stream.
//
// A program of its own because Assimp may crash, hang or eat memory on a damaged file; the parent
// (import.cpp) sets the limits before it starts this one.

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "core/error.h"
#include "import/animation_choice.h"
#include "import/assimp/assimp_reader.h"
#include "import/file_length.h"
#include "import/gltf/gltf_reader.h"
#include "import/meshes/mesh_files.h"
#include "import/other_formats.h"
#include "import/quake_models.h"
#include "import/refusal.h"
#include "import/scene_stream.h"

namespace ink::import {

#ifdef INK_IMPORT_FAULTS
void provoke_fault(const std::string& path, int output_fd);  // tests/import/import_faults.cpp
#endif

namespace {

enum ExitCode { kSuccess = 0, kWriteFailed = 1, kUsage = 2 };

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

ImportReply answer(ImportStatus status, const core::Error& error) {
    ImportReply reply;
    reply.status = status;
    reply.reason = error.what_happened();
    if (!error.accepted().empty()) reply.reason += " (accepted: " + error.accepted() + ")";
    return reply;
}

/// By our own readers what they know, all else by Assimp.
ImportReply read_known(const std::filesystem::path& path, const ImportChoice& choice) {
    check_length(path);
    if (auto reply = read_quake_model(path)) return std::move(*reply);
    if (auto reply = read_gltf(path, choice)) return std::move(*reply);
    if (auto reply = read_mesh_file(path)) return std::move(*reply);
    refuse_other_format(path);
    return read_with_assimp(path, choice, 0);
}

ImportReply read_model(const std::filesystem::path& path, const ImportChoice& choice) {
#ifdef INK_IMPORT_FAULTS
    // Our readers are tested against Assimp's, frame by frame.
    if (const char* frame = std::getenv("INKBENCH_TEST_ASSIMP_FRAME"); frame != nullptr)
        return read_with_assimp(path, choice, std::atoi(frame));
#endif
    try {
        ImportReply reply = read_known(path, choice);
        // Of readers that know no animations none was chosen, which must not pass unnoticed.
        if (reply.status == ImportStatus::scene)
            (void)choose_animation(reply.animation_names, choice.animation);
        return reply;
    } catch (const Refusal& refusal) {
        return answer(ImportStatus::refused, refusal);
    } catch (const core::Error& error) {
        return answer(ImportStatus::damaged, error);
    }
}

}  // namespace
}  // namespace ink::import

int main(int argc, char** argv) {
    using namespace ink::import;
    if (argc != 2 && argc != 3) {
        std::fputs(
            "usage: inkbench_import FILE [ANIMATION] > STREAM\n"
            "inkbench starts it; see --help there.\n",
            stderr);
        return kUsage;
    }
    prepare_output();
#ifdef INK_IMPORT_FAULTS
    provoke_fault(argv[1], output.fd);
#endif
    write_reply(read_model(argv[1], {.animation = argc == 3 ? argv[2] : ""}), write_all);
    return kSuccess;
}
