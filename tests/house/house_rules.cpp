#include "tests/house/house_rules.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace ink::house {
namespace {

using Names = std::set<std::string>;

/// Section 2 of the design. A room may always include itself. cli names core beside lab because
/// lab's own headers speak in core's errors and parameters.
const std::map<std::string, Names>& arrows() {
    static const std::map<std::string, Names> table = {
        {"core", {}},
        {"image_io", {"core"}},
        {"scene", {"core"}},
        {"raster", {"core", "scene"}},
        {"edge", {"core"}},
        {"shade", {"core", "scene", "raster"}},
        {"truth", {"core", "scene", "edge"}},
        {"score", {"core", "edge", "truth/line_class.h"}},
        {"lab",
         {"core",
          "image_io",
          "scene",
          "raster",
          "edge",
          "shade",
          "truth",
          "score",
          "methods"}},
        {"cli", {"core", "lab"}},
        {"methods", {"core", "scene", "raster", "edge", "shade"}},
    };
    return table;
}

/// A library and where it may be included.
struct LibraryRule {
    std::string name;
    std::string prefix;  ///< of the included path
    Names folders;       ///< path prefixes in which any file may; elsewhere `others` files may
    int others = 0;
};

const std::vector<LibraryRule>& library_rules() {
    static const std::vector<LibraryRule> rules = {
        {"Embree", "embree", {"bench/"}, 1},
        {"OpenImageIO", "OpenImageIO/", {}, 1},
        {"Assimp", "assimp/", {}, 1},
        {"OpenCV", "opencv2/", {"src/score/", "src/lab/", "methods/", "tests/", "bench/"}, 0},
        {"CLI11", "CLI/", {"src/cli/"}, 0},
    };
    return rules;
}

struct Include {
    int line = 0;
    std::string path;
};

bool starts_with(const std::string& text, const std::string& prefix) {
    return text.compare(0, prefix.size(), prefix) == 0;
}

bool ends_with(const std::string& text, const std::string& suffix) {
    return text.size() >= suffix.size() &&
           text.compare(text.size() - suffix.size(), suffix.size(), suffix) == 0;
}

bool is_code(const SourceFile& file) {
    return ends_with(file.path, ".h") || ends_with(file.path, ".cpp") ||
           ends_with(file.path, ".h.in");
}

void for_each_line(const SourceFile& file,
                   const std::function<void(int, const std::string&)>& visit) {
    std::istringstream lines(file.text);
    int number = 0;
    for (std::string line; std::getline(lines, line);)
        visit(++number, line);
}

std::vector<Include> includes_of(const SourceFile& file) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<Include> found;
    for_each_line(file, [&](int number, const std::string& line) {
        std::smatch match;
        if (line.find("include") != std::string::npos && std::regex_search(line, match, pattern)) {
            found.push_back({number, match[1]});
        }
    });
    return found;
}

std::string at(const SourceFile& file, int line) {
    return file.path + ":" + std::to_string(line) + ": ";
}

/// The first part of a path, and the second: "a" and "b" of "a/b/c".
std::pair<std::string, std::string> first_two(const std::string& path) {
    const auto slash = path.find('/');
    if (slash == std::string::npos) return {path, ""};
    const auto next = path.find('/', slash + 1);
    if (next == std::string::npos) return {path.substr(0, slash), ""};
    return {path.substr(0, slash), path.substr(slash + 1, next - slash - 1)};
}

/// The room a file belongs to, or "" outside src/ and methods/.
std::string room_of(const std::string& path) {
    const auto [top, second] = first_two(path);
    if (top == "methods") return "methods";
    return top == "src" ? second : "";
}

/// The method a path of the form methods/<name>/... belongs to, or "".
std::string method_of(const std::string& path) {
    const auto [top, second] = first_two(path);
    return top == "methods" ? second : "";
}

/// Why `file` may not include `path`, or "".
std::string breach(const SourceFile& file, const std::string& path) {
    if (path.find("..") != std::string::npos) return "is not by path from src/ or the root";
    const std::string from = room_of(file.path);
    const std::string to = first_two(path).first;
    const Names& allowed = arrows().at(from);
    if (starts_with(path, "src/") || starts_with(path, "tests/") || starts_with(path, "bench/")) {
        return "is none of the rooms' includes";
    }
    if (to == "methods" && from == "methods") {
        const std::string other = method_of(path);
        const bool is_own = other.empty() || other == method_of(file.path);
        return is_own || file.path == "methods/registry.cpp" ? "" : "is another method";
    }
    if (to == from || arrows().count(to) == 0 || allowed.count(to) != 0 ||
        allowed.count(path) != 0) {
        return "";
    }
    return "is not allowed in " + from;
}

Names methods_in(const SourceTree& tree) {
    Names methods;
    for (const std::string& folder : tree.folders) {
        const std::string prefix = "methods/";
        if (starts_with(folder, prefix) && folder.find('/', prefix.size()) == std::string::npos) {
            methods.insert(folder.substr(prefix.size()));
        }
    }
    return methods;
}

bool has_word(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("\\b" + word + "\\b"));
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

Findings check_arrows(const SourceTree& tree) {
    Findings findings;
    for (const SourceFile& file : tree.files) {
        const std::string room = room_of(file.path);
        if (!is_code(file) || arrows().count(room) == 0) continue;
        for (const Include& include : includes_of(file)) {
            const std::string why = breach(file, include.path);
            if (!why.empty()) findings.push_back(at(file, include.line) + include.path + " " + why);
        }
    }
    return findings;
}

Findings check_libraries(const SourceTree& tree) {
    Findings findings;
    for (const LibraryRule& rule : library_rules()) {
        std::vector<std::string> others;
        for (const SourceFile& file : tree.files) {
            const bool is_free = std::any_of(rule.folders.begin(),
                                             rule.folders.end(),
                                             [&](const auto& f) { return starts_with(file.path, f); });
            if (!is_code(file) || is_free) continue;
            for (const Include& include : includes_of(file)) {
                if (!starts_with(include.path, rule.prefix)) continue;
                if (others.empty() || others.back() != file.path) others.push_back(file.path);
            }
        }
        if (static_cast<int>(others.size()) <= rule.others) continue;
        for (const std::string& path : others) {
            findings.push_back(path + ": includes " + rule.name + ", which at most " +
                               std::to_string(rule.others) + " file(s) here may");
        }
    }
    return findings;
}

Findings check_folders(const SourceTree& tree) {
    static const Names forbidden = {"util", "utils", "common", "helper", "helpers", "misc"};
    Findings findings;
    for (const std::string& folder : tree.folders) {
        if (forbidden.count(folder.substr(folder.rfind('/') + 1)) != 0) {
            findings.push_back(folder + ": a drawer, not a room");
        }
        const bool is_in_src = starts_with(folder, "src/") && folder.find('/', 4) == folder.npos;
        const bool is_room = is_in_src && arrows().count(folder.substr(4)) != 0;
        if (is_in_src && !is_room) findings.push_back(folder + ": no room of this name");
    }
    for (const auto& [room, allowed] : arrows()) {
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

Findings check_methods(const SourceTree& tree) {
    Findings findings;
    const SourceFile* registry = tree.find("methods/registry.cpp");
    const SourceFile* cmake = tree.find("methods/CMakeLists.txt");
    if (registry == nullptr || cmake == nullptr) {
        return {"methods: registry.cpp or CMakeLists.txt is missing"};
    }
    for (const std::string& name : methods_in(tree)) {
        const std::string stem = "methods/" + name + "/" + name;
        for (const char* ending : {".h", ".cpp", ".md"}) {
            if (tree.find(stem + ending) == nullptr) {
                findings.push_back(stem + ending + ": missing");
            }
        }
        if (registry->text.find("\"" + stem + ".h\"") == std::string::npos ||
            !has_word(registry->text, name + "\\(\\),")) {
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
        std::regex("-m(arch|tune|cpu)=native"), std::regex("-f(fast-math|associative-math)|-Ofast")};
    return grep(tree, patterns, is_build_file);
}

Findings check_words(const SourceTree& tree) {
    // Each pattern holds a bracket that its own text does not match, so this file passes.
    static const std::vector<std::regex> patterns = {
        std::regex("(^|[^A-Za-z0-9_.)}-])/[w]ork/"),
        std::regex("/tmp/[b]ash_jobs"),
        std::regex("/home/[a-z_][a-z0-9_-]*/"),
        std::regex("[p]kg\\.dev\\b|[r]egistry\\.npmjs|[p]ypi\\.org|[f]iles\\.pythonhosted"),
        std::regex("[d]eb\\.debian\\.org|[s]napshot\\.debian\\.org|[p]roxy\\.golang\\.org"),
        std::regex("[c]rates\\.io|[a]rtifactory|[a]rtifact-registry"),
    };
    return grep(tree, patterns, [](const std::string&) { return true; });
}

}  // namespace ink::house
