// inkbench_import FILE [ANIMATION [texcoords]]: reads one model and writes it to standard output as
// a scene stream.
//
// A program of its own because a reader, or a library that it uses, may crash, hang or eat memory
// on a damaged file; the parent (import.cpp) sets the limits before it starts this one.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "import/fbx/fbx_reader.h"
#include "import/gltf/gltf_reader.h"
#include "import/meshes/mesh_readers.h"
#include "import/model_bytes.h"
#include "import/other_formats.h"
#include "import/quake_models.h"
#include "import/scene_stream.h"

namespace ink::import {

#ifdef INK_IMPORT_FAULTS
void provoke_fault(const std::string& path, int output_fd);  // tests/import/import_faults.cpp
#endif

namespace {

ImportReply reply_of(ImportStatus status) {
    ImportReply reply;
    reply.status = status;
    return reply;
}

bool is_ply(std::string_view file) {
    return file.starts_with("ply\n") || file.starts_with("ply\r") || file.starts_with("ply ");
}

/// Files in the folder of `model`, whatever folders a name in the model speaks of.
FilesBeside beside(const std::filesystem::path& model) {
    return [folder = model.parent_path()](const std::string& name) {
        return std::string(text_of(bytes_of(folder / std::filesystem::path(name).filename())));
    };
}

using Reader = ImportReply (*)(std::string_view, const std::string&);

constexpr Reader read_obj_alone = read_obj;

/// Who reads a file that begins with `head`; nobody here if none does.
Reader reader_of(std::string_view head, const std::string& extension) {
    const std::string_view text = without_mark(head);
    if (is_ply(text) || extension == ".ply") return read_ply;
    if (is_off(text) || extension == ".off") return read_off;
    if (extension == ".stl" || is_stl_text(text)) return read_stl;
    return extension == ".obj" ? read_obj_alone : nullptr;
}

/// The model in a PLY, STL, OFF or OBJ file; nothing for other files. PLY, OFF and STL text are
/// told by content, whatever the file is called; binary STL and OBJ by their endings, as they have
/// no mark. A UTF-8 mark is read over, UTF-16 refused. Throws core::Error for a damaged file.
std::optional<ImportReply> read_mesh_file(const std::filesystem::path& path, bool has_texcoords) {
    const std::string head = head_of(path);
    const Reader reader = reader_of(head, lower_case(path.extension().string()));
    if (reader == nullptr) {
        refuse_by_content(head);
        return std::nullopt;
    }
    const std::vector<std::byte> bytes = bytes_of(path);
    const std::string_view file = text_of(bytes);
    const std::string name = path.stem().string();
    if (reader == read_stl && is_binary_stl(file)) return reader(file, name);
    refuse_by_content(head);
    if (is_utf16(file)) throw Refusal("", "is UTF-16 text, which is not read", "UTF-8");
    if (reader == read_obj_alone && head.find('\0') != head.npos)
        return reply_of(ImportStatus::wrong_content);
    if (reader == read_obj_alone)
        return read_obj(without_mark(file), name, beside(path), has_texcoords);
    return reader(without_mark(file), name);
}

/// A format that writes its whole length at a fixed place behind a magic word, little endian.
struct LengthField {
    std::string_view magic;
    std::size_t offset;
};
constexpr std::array kLengthFields{
    LengthField{"glTF", 8},    // glTF 2.0 binary, 5.1 "Header"
    LengthField{"IDP2", 64},   // MD2: ofs_end
    LengthField{"IDP3", 104},  // MD3: ofs_eof
};

/// Throws core::Error if a file is shorter than its own header says. Knows binary glTF, MD2 and
/// MD3, whose readers may stop early and say nothing.
void check_length(const std::filesystem::path& path) {
    const std::string head = head_of(path);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    for (const LengthField& field : kLengthFields) {
        if (!head.starts_with(field.magic) || head.size() < field.offset + 4) continue;
        const auto promised =
            number_at<std::uint32_t>(std::as_bytes(std::span(head)), field.offset);
        if (error || promised <= size) return;
        throw core::Error("",
                          "the file is cut short: its header promises " + std::to_string(promised) +
                              " bytes, it has " + std::to_string(size),
                          "a whole, valid model file");
    }
}

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

/// A library might swallow bad_alloc and go on with half a scene; so it must not be thrown.
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
    write_reply(reply_of(ImportStatus::out_of_memory), [](const void* data, std::size_t size) {
        std::memcpy(output.out_of_memory.data() + output.out_of_memory_bytes, data, size);
        output.out_of_memory_bytes += size;
    });
    std::set_new_handler(answer_out_of_memory);
}

ImportReply answer(ImportStatus status, const core::Error& error) {
    ImportReply reply = reply_of(status);
    reply.reason = error.what_happened();
    if (!error.accepted().empty()) reply.reason += " (accepted: " + error.accepted() + ")";
    return reply;
}

/// By the first reader that knows the file; what none knows is refused, by name if it has one.
ImportReply read_known(const std::filesystem::path& path, const ModelChoice& choice) {
    check_length(path);
    if (auto reply = read_quake_model(path)) return std::move(*reply);
    if (auto reply = read_gltf(path, choice)) return std::move(*reply);
    if (auto reply = read_mesh_file(path, choice.has_texcoords)) return std::move(*reply);
    if (auto reply = read_fbx(path, choice)) return std::move(*reply);
    refuse_by_ending(path, head_of(path));
    return reply_of(has_read_ending(path) ? ImportStatus::wrong_content
                                          : ImportStatus::unknown_format);
}

ImportReply read_model(const std::filesystem::path& path, const ModelChoice& choice) {
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
    if (argc < 2 || argc > 4) {
        std::fputs(
            "usage: inkbench_import FILE [ANIMATION [texcoords]] > STREAM\n"
            "inkbench starts it; see --help there.\n",
            stderr);
        return kUsage;
    }
    prepare_output();
#ifdef INK_IMPORT_FAULTS
    provoke_fault(argv[1], output.fd);
#endif
    const ModelChoice choice{.animation = argc > 2 ? argv[2] : "", .has_texcoords = argc > 3};
    write_reply(read_model(argv[1], choice), write_all);
    return kSuccess;
}
