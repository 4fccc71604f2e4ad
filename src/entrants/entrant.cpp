#include "entrants/entrant.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

#include "core/error.h"
#include "entrants/image_folder.h"
#include "entrants/outside_program.h"
#include "harness/row.h"

namespace ink::entrants {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWhere = "--entrant";
constexpr const char* kAccepted = "NAME=FOLDER of images, or NAME=PROGRAM";

void check_entrant_name(const std::string& name, const std::string& text) {
    const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
    });
    if (!is_word) {
        throw core::Error(
            kWhere, fmt::format("'{}' has no name", text), "letters, digits, _ and - before the =");
    }
    const auto& methods = methods::registry();
    const bool is_taken = harness::is_baseline(name) ||
                          std::any_of(methods.begin(), methods.end(), [&](const auto& info) {
                              return info.name == name;
                          });
    if (is_taken) {
        throw core::Error(
            kWhere, fmt::format("there is a method '{}' already", name), "a name of its own");
    }
}

/// The parameters of every entrant.
struct EntrantParams {
    int threshold = 128;
};

core::ParamTable<EntrantParams> entrant_table() {
    core::ParamTable<EntrantParams> table;
    return table.number(&EntrantParams::threshold,
                        "threshold",
                        {1, 255},
                        "",
                        "Least edge response of a line pixel.");
}

}  // namespace

Entrant parse_entrant(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == std::string::npos)
        throw core::Error(kWhere, fmt::format("'{}' is no entrant", text), kAccepted);
    Entrant entrant{text.substr(0, equals), text.substr(equals + 1)};
    check_entrant_name(entrant.name, text);
    std::error_code error;
    if (fs::is_directory(entrant.path, error)) return entrant;
    entrant.is_program = true;
    if (!fs::is_regular_file(entrant.path, error)) {
        throw core::Error(kWhere,
                          fmt::format("there is no folder or program '{}'", entrant.path.string()),
                          kAccepted);
    }
    if (access(entrant.path.c_str(), X_OK) != 0) {
        throw core::Error(kWhere,
                          fmt::format("'{}' cannot be executed", entrant.path.string()),
                          "a program with its x bit set (chmod +x)");
    }
    return entrant;
}

harness::MethodConfig entrant_config(const Entrant& entrant, const EntrantLimits& limits) {
    auto info = std::make_shared<method::MethodInfo>();
    info->name = entrant.name;
    info->source = fmt::format("outside: {}", entrant.path.string());
    info->summary = entrant.is_program ? "a program from outside" : "images from outside";
    info->params = entrant_table().params();
    info->family = method::Family::other;
    info->marker = method::Marker::cross;
    info->make = [entrant, limits](const core::ParamValues& values) {
        (void)entrant_table().read(values, entrant.name);
        return std::make_unique<harness::OutsideMethod>(entrant.is_program
                                                            ? program_source(entrant.path, limits)
                                                            : image_folder_source(entrant.path));
    };
    const std::string content =
        entrant.is_program ? file_hash(entrant.path) : folder_hash(entrant.path);
    info->complete = [entrant, content](const core::ParamValues& values) {
        const auto table = entrant_table();
        core::ParamValues all = table.write(table.read(values, entrant.name));
        all["entrant"] = entrant.path.string();
        all["content"] = content;
        return all;
    };
    return {info.get(), {}, info, true};
}

}  // namespace ink::entrants
