#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

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
    static const std::regex kWord("[a-z][a-z0-9_]*");
    if (!std::regex_match(name, kWord) || name == kTemplateName) {
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
    std::istringstream words(name);
    std::string text;
    for (std::string word; std::getline(words, word, '_');) {
        if (!word.empty()) word[0] = static_cast<char>(std::toupper(word[0]));
        text += word;
    }
    return text;
}

/// Adds a method called `name` to the source tree at `root`: a copy of methods/_template with its
/// names changed, and its lines in methods/registry.cpp and methods/CMakeLists.txt. Prints the
/// files that are new or changed, relative to `root`.
///
/// A name is of small letters, digits and underscores, begins with a letter and is no word of C++
/// that the template has. Throws core::Error, with nothing written, for another name, one that is
/// taken, or a `root` that is no source tree of Inkbench.
void add_new_method(const fs::path& root, const std::string& name) {
    check_method_name(name);
    const fs::path folder = fs::path("methods") / name;
    if (fs::exists(root / folder))
        throw core::Error((root / folder).string(), "this folder is there already");
    // All is read and changed before anything is written.
    std::map<fs::path, std::string> files;
    for (const char* ending : {".cpp", ".toml"}) {
        const fs::path from = root / "methods/_template" / (std::string(kTemplateName) + ending);
        const std::string text =
            std::regex_replace(source_text(from), std::regex(kTemplateClass), class_name(name));
        files[folder / (name + ending)] = std::regex_replace(text, std::regex(kTemplateName), name);
    }
    const auto list = [&](const fs::path& file, const std::string& next, const std::string& line) {
        std::string& lines = files[file] = source_text(root / file);
        const std::size_t at = lines.find(next);
        if (at == std::string::npos)
            throw core::Error(file.string(), "it has no line with '" + next + "'");
        lines.insert(at, line + "\n");
    };
    list("methods/registry.cpp", "    X(auto)", "    X(" + name + ") \\");
    list("methods/CMakeLists.txt", "    auto", "    " + name);

    fs::create_directories(root / folder);
    for (const auto& [path, text] : files) {
        core::write_whole_file(root / path, text);
        fmt::print("{}\n", path.string());
    }
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
        add_new_method(args->root, args->name);
        fmt::print("next: ./bootstrap build, then inkbench compare --methods {},mote4\n",
                   args->name);
    });
}

}  // namespace ink::cli
