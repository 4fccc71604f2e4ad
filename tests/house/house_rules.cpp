#include "tests/house/house_rules.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <regex>
#include <set>

namespace ink::house {
namespace {

std::set<std::string> methods_in(const SourceTree& tree) {
    std::set<std::string> methods;
    for (const std::string& folder : tree.folders) {
        const std::string prefix = "methods/";
        // One that begins with _ is a template; `outside` has programs that drive others' methods.
        if (starts_with(folder, prefix) && folder[prefix.size()] != '_' &&
            folder != prefix + "outside" && folder.find('/', prefix.size()) == std::string::npos) {
            methods.insert(folder.substr(prefix.size()));
        }
    }
    return methods;
}

/// Whether the registry's list has an entry that calls the function `name`, or `name`_method where
/// the name is a word of the language.
bool is_listed(const SourceFile& registry, const std::string& name) {
    return std::regex_search(registry.text, std::regex("\\b" + name + "(_method)?\\(\\),"));
}

/// Paths of one machine and hosts of packages, in two halves each so that this file holds none.
const std::vector<std::string>& forbidden_words() {
    const auto word = [](const char* head, const char* tail) { return std::string(head) + tail; };
    static const std::vector<std::string> words = {
        word("/wo", "rk/"),
        word("/ho", "me/"),
        word("/tm", "p/bash_jobs"),
        word("deb.debian", ".org"),
        word("snapshot.debian", ".org"),
        word("pypi", ".org"),
        word("files.pythonhosted", ".org"),
        word("registry.np", "mjs.org"),
        word("proxy.golang", ".org"),
        word("crates", ".io"),
        word("pkg", ".dev"),
        word("artifact", "-registry"),
        word("artif", "actory"),
    };
    return words;
}

/// Whether `line` holds `word`; one that begins with a slash counts only where a path begins.
bool has_forbidden(const std::string& line, const std::string& word) {
    const auto found = line.find(word);
    if (found == std::string::npos || found == 0 || word[0] != '/') return found != line.npos;
    const char before = line[found - 1];
    const bool goes_on = std::isalnum(static_cast<unsigned char>(before)) != 0 ||
                         std::string("_.-)}~/").find(before) != std::string::npos;
    return !goes_on || has_forbidden(line.substr(found + 1), word);
}

bool is_build_file(const std::string& path) {
    return ends_with(path, "CMakeLists.txt") || ends_with(path, ".cmake") ||
           path == "CMakePresets.json" || path == "bootstrap" || starts_with(path, ".ci/");
}

/// Findings wherever a line of a file that `is_meant` matches one of `patterns`.
Findings grep(const SourceTree& tree,
              const std::vector<std::regex>& patterns,
              const std::function<bool(const std::string&)>& is_meant) {
    Findings findings;
    for (const SourceFile& file : tree.files) {
        if (!is_meant(file.path)) continue;
        for_each_line(file, [&](int number, const std::string& line) {
            std::smatch match;
            for (const std::regex& pattern : patterns) {
                if (std::regex_search(line, match, pattern)) {
                    findings.push_back(at(file, number) + match.str());
                }
            }
        });
    }
    return findings;
}

}  // namespace

Findings check_folders(const SourceTree& tree) {
    static const std::set<std::string> forbidden = {
        "util", "utils", "common", "helper", "helpers", "misc"};
    const std::vector<std::string> rooms = room_names();
    Findings findings;
    for (const std::string& folder : tree.folders) {
        if (forbidden.count(folder.substr(folder.rfind('/') + 1)) != 0) {
            findings.push_back(folder + ": a drawer, not a room");
        }
        const bool is_in_src = starts_with(folder, "src/") && folder.find('/', 4) == folder.npos;
        const bool is_room =
            is_in_src && std::count(rooms.begin(), rooms.end(), folder.substr(4)) != 0;
        if (is_in_src && !is_room) findings.push_back(folder + ": no room of this name");
    }
    for (const std::string& room : rooms) {
        const std::string folder = room == "methods" ? room : "src/" + room;
        if (!tree.has_folder(folder)) findings.push_back(folder + ": this room is missing");
    }
    for (const std::string& folder : tree.folders) {
        const bool is_room = starts_with(folder, "src/") && folder.find('/', 4) == folder.npos;
        const bool is_top = folder == "methods" || folder == "tests" || folder == "bench";
        if ((is_room || is_top) && tree.find(folder + "/CMakeLists.txt") == nullptr) {
            findings.push_back(folder + ": no CMakeLists.txt");
        }
    }
    return findings;
}

namespace {

/// A preset has a page and a line in the build, and no code: its rows run another method's.
void note_preset_gaps(const SourceTree& tree, const std::string& name, Findings& findings) {
    const std::string stem = "methods/" + name + "/" + name;
    if (tree.find(stem + ".md") == nullptr) findings.push_back(stem + ".md: missing");
    for (const char* ending : {".h", ".cpp"}) {
        if (tree.find(stem + ending) != nullptr) {
            findings.push_back(stem + ending + ": a preset has no code");
        }
    }
    const SourceFile* cmake = tree.find("methods/CMakeLists.txt");
    if (cmake->text.find(name + "/" + name + ".toml") == std::string::npos) {
        findings.push_back("methods/CMakeLists.txt: no line for " + name);
    }
}

}  // namespace

Findings check_methods(const SourceTree& tree) {
    Findings findings;
    const SourceFile* registry = tree.find("methods/registry.cpp");
    const SourceFile* cmake = tree.find("methods/CMakeLists.txt");
    if (registry == nullptr || cmake == nullptr) {
        return {"methods: registry.cpp or CMakeLists.txt is missing"};
    }
    for (const std::string& name : methods_in(tree)) {
        const std::string stem = "methods/" + name + "/" + name;
        if (tree.find(stem + ".toml") != nullptr) {
            note_preset_gaps(tree, name, findings);
            continue;
        }
        for (const char* ending : {".h", ".cpp", ".md"}) {
            if (tree.find(stem + ending) == nullptr) {
                findings.push_back(stem + ending + ": missing");
            }
        }
        if (registry->text.find("\"" + stem + ".h\"") == std::string::npos ||
            !is_listed(*registry, name)) {
            findings.push_back("methods/registry.cpp: no line for " + name);
        }
        if (cmake->text.find(name + "/" + name + ".cpp") == std::string::npos) {
            findings.push_back("methods/CMakeLists.txt: no line for " + name);
        }
    }
    return findings;
}

Findings check_headers(const SourceTree& tree) {
    Findings findings;
    for (const SourceFile& file : tree.files) {
        if (!ends_with(file.path, ".h") && !ends_with(file.path, ".h.in")) continue;
        bool is_decided = false;
        for_each_line(file, [&](int number, const std::string& line) {
            if (is_decided || line.empty() || starts_with(line, "//")) return;
            is_decided = true;
            if (line != "#pragma once") {
                findings.push_back(at(file, number) + "code before #pragma once");
            }
        });
        if (!is_decided) findings.push_back(file.path + ": an empty header");
    }
    return findings;
}

Findings check_flags(const SourceTree& tree) {
    static const std::vector<std::regex> patterns = {
        std::regex("-m(arch|tune|cpu)=native"),
        std::regex("-f(fast-math|associative-math)|-Ofast")};
    return grep(tree, patterns, is_build_file);
}

Findings check_words(const SourceTree& tree) {
    Findings findings;
    for (const SourceFile& file : tree.files) {
        for_each_line(file, [&](int number, const std::string& line) {
            for (const std::string& word : forbidden_words()) {
                if (has_forbidden(line, word)) findings.push_back(at(file, number) + word);
            }
        });
    }
    return findings;
}

}  // namespace ink::house
