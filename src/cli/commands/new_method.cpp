#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "cli/commands/commands.h"
#include "core/error.h"
#include "core/named.h"
#include "core/whole_file.h"
#include "methods/registry.h"

namespace ink::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTemplateName = "my_method";
constexpr const char* kTemplateClass = "MyMethod";

void check_method_name(const std::string& name) {
    const bool is_word = !name.empty() && std::islower(static_cast<unsigned char>(name[0])) != 0 &&
                         std::all_of(name.begin(), name.end(), [](unsigned char c) {
                             return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_';
                         });
    if (!is_word || name == kTemplateName) {
        throw core::Error("new-method",
                          "a method cannot be called '" + name + "'",
                          "small letters, digits and underscores, a letter first");
    }
    if (core::find_named(methods::registry(), name) != nullptr)
        throw core::Error("new-method", "there is a method '" + name + "' already");
}

std::string source_text(const fs::path& path) {
    auto text = core::read_whole_file(path);
    if (text) return *std::move(text);
    throw core::Error(path.string(),
                      "it cannot be read, so this is no source tree of Inkbench",
                      "run it in the source tree, or name the tree with --root");
}

/// "two_sums" as "TwoSums".
std::string class_name(const std::string& name) {
    std::string text;
    bool is_first = true;
    for (const char c : name) {
        if (c == '_') {
            is_first = true;
            continue;
        }
        text += is_first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        is_first = false;
    }
    return text;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// Puts `line` before the first line that holds `mark`.
void insert_before(std::string& text,
                   const std::string& mark,
                   const std::string& line,
                   const fs::path& file) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos)
        throw core::Error(file.string(), "it has no line with '" + mark + "'");
    text.insert(at == 0 ? 0 : text.rfind('\n', at) + 1, line + "\n");
}

/// Adds a method called `name` to the source tree at `root`: a copy of methods/_template with its
/// names changed, and its lines in methods/registry.cpp and methods/CMakeLists.txt. Returns the
/// files that are new or changed, relative to `root`.
///
/// A name is of small letters, digits and underscores, begins with a letter and is no word of C++
/// that the template has. Throws core::Error, with nothing written, for another name, one that is
/// taken, or a `root` that is no source tree of Inkbench.
std::vector<fs::path> add_new_method(const fs::path& root, const std::string& name) {
    check_method_name(name);
    const fs::path folder = fs::path("methods") / name;
    if (fs::exists(root / folder))
        throw core::Error((root / folder).string(), "this folder is there already");
    // All is read and changed before anything is written.
    std::map<fs::path, std::string> files;
    for (const char* ending : {".cpp", ".toml"}) {
        const fs::path from = root / "methods/_template" / (std::string(kTemplateName) + ending);
        const std::string text = replace_all(source_text(from), kTemplateClass, class_name(name));
        files[folder / (name + ending)] = replace_all(text, kTemplateName, name);
    }
    const auto list = [&](const fs::path& file, const char* mark, const std::string& line) {
        std::string& lines = files[file] = source_text(root / file);
        insert_before(lines, mark, line, file);
    };
    list("methods/registry.cpp", "    X(auto)", "    X(" + name + ") \\");
    list("methods/CMakeLists.txt", "    auto", "    " + name);

    std::vector<fs::path> changed;
    fs::create_directories(root / folder);
    for (const auto& [path, text] : files) {
        core::write_whole_file(root / path, text);
        changed.push_back(path);
    }
    return changed;
}

struct NewMethodArgs {
    std::string name;
    std::string root = ".";
};

}  // namespace

void add_new_method_command(CLI::App& app) {
    auto args = std::make_shared<NewMethodArgs>();
    auto* command = app.add_subcommand(
        "new-method", "Add a method of your own to the source tree, to begin from a template");
    command->add_option("name", args->name, "As tables and options will call it: small_letters")
        ->required();
    command->add_option("--root", args->root, "The source tree (default: this folder)")
        ->type_name("DIR");
    command->footer(
        "It draws at once: lines where the surface turns or ends. Change it, build, compare:\n"
        "methods/README.md says how a method is put together.\n"
        "Example: inkbench new-method my_lines && ./bootstrap build && \\\n"
        "         build/release/inkbench compare --scenes torus --methods my_lines,mote4\n"
        "Exit codes: 0 done, 2 bad input.");
    command->callback([args] {
        for (const auto& path : add_new_method(args->root, args->name))
            fmt::print("{}\n", path.string());
        fmt::print("next: ./bootstrap build, then inkbench compare --methods {},mote4\n",
                   args->name);
    });
}

}  // namespace ink::cli
