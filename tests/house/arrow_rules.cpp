#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "tests/house/house_rules.h"

namespace ink::house {
namespace {

using Names = std::set<std::string>;

/// The rooms that measure and what they measure with.
const Names& measuring() {
    static const Names rooms = {"core",
                                "image_io",
                                "scene",
                                "catalogue",
                                "import",
                                "raster",
                                "edge",
                                "shade",
                                "method",
                                "buffers",
                                "methods",
                                "truth",
                                "crosscheck",
                                "score",
                                "statistics"};
    return rooms;
}

Names measuring_and(const Names& more) {
    Names rooms = measuring();
    rooms.insert(more.begin(), more.end());
    return rooms;
}

/// Section 2 of the design: for each room the rooms, and the single headers, that it may include.
/// A room may always include itself.
const std::map<std::string, Names>& arrows() {
    static const std::map<std::string, Names> table = {
        {"core", {}},
        {"image_io", {"core"}},
        {"scene", {"core"}},
        {"catalogue", {"core", "scene"}},
        {"import", {"core", "scene"}},
        {"raster", {"core", "scene"}},
        {"edge", {"core"}},
        {"shade", {"core", "scene", "raster"}},
        {"method", {"core", "scene", "raster", "edge"}},
        {"buffers", {"core", "scene", "raster", "edge", "method"}},
        {"methods", {"core", "scene", "raster", "edge", "shade", "method", "buffers"}},
        {"truth", {"core", "scene", "edge"}},
        // Nothing else of truth: so it finds the outline without truth's help.
        {"crosscheck", {"core", "scene", "truth/line_class.h", "truth/embree.h"}},
        {"score", {"core", "edge", "truth/line_class.h", "truth/curve.h"}},
        {"statistics", {"core", "score", "edge/thin.h"}},
        {"harness", measuring()},
        {"linear_code", measuring_and({"harness"})},
        {"studies", measuring_and({"harness", "linear_code/roll_prediction.h"})},
        {"experiment", measuring_and({"harness", "studies", "linear_code"})},
        {"tune", measuring_and({"harness", "linear_code", "experiment"})},
        {"draw", measuring_and({"harness"})},
        // From what a run folder holds: its tables and its images.
        {"report",
         {"core",
          "image_io",
          "truth/line_class.h",
          "statistics",
          "harness",
          "experiment",
          "draw/error_image.h",
          "draw/crosscheck_report.h"}},
        {"cli",
         measuring_and(
             {"harness", "studies", "linear_code", "experiment", "tune", "draw", "report"})},
        {"python", measuring_and({"harness", "draw/drawing.h"})},
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
        {"Assimp", "assimp/", {"src/import/assimp/"}, 0},
        {"Draco", "draco/", {"tests/import/"}, 1},
        {"meshoptimizer", "meshoptimizer", {"tests/import/"}, 1},
        {"OpenCV", "opencv2/", {"src/score/", "src/draw/", "methods/", "tests/", "bench/"}, 0},
        {"CLI11", "CLI/", {"src/cli/"}, 0},
        {"pybind11", "pybind11/", {"src/python/"}, 0},
        {"NLopt", "nlopt", {"src/tune/"}, 0},
        {"toml++", "toml++/", {"src/experiment/", "src/tune/", "methods/", "tests/"}, 0},
    };
    return rules;
}

struct Include {
    int line = 0;
    std::string path;
    bool is_quoted = false;
};

std::vector<Include> includes_of(const SourceFile& file) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
    std::vector<Include> found;
    for_each_line(file, [&](int number, const std::string& line) {
        std::smatch match;
        if (line.find("include") != std::string::npos && std::regex_search(line, match, pattern)) {
            found.push_back({number, match[1], line.find('"') != std::string::npos});
        }
    });
    return found;
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

/// Why `file` may not include this, or "".
std::string breach(const SourceFile& file, const Include& include) {
    const std::string& path = include.path;
    const bool is_bare = include.is_quoted && path.find('/') == std::string::npos;
    if (is_bare || path.find("..") != std::string::npos) {
        return "is not by path from src/ or the root";
    }
    const std::string from = room_of(file.path);
    const std::string to = first_two(path).first;
    const Names& allowed = arrows().at(from);
    if (starts_with(path, "src/") || starts_with(path, "tests/") || starts_with(path, "bench/")) {
        return "is none of the rooms' includes";
    }
    if (to == "methods" && from == "methods") {
        const std::string other = method_of(path);
        // The template speaks of the method that a copy of it becomes.
        const bool is_own = other.empty() || other == method_of(file.path) ||
                            starts_with(file.path, "methods/_template/");
        return is_own || file.path == "methods/registry.cpp" ? "" : "is another method";
    }
    if (to == from || arrows().count(to) == 0 || allowed.count(to) != 0 ||
        allowed.count(path) != 0) {
        return "";
    }
    return "is not allowed in " + from;
}

}  // namespace

std::vector<std::string> room_names() {
    std::vector<std::string> names;
    for (const auto& [room, allowed] : arrows())
        names.push_back(room);
    return names;
}

Findings check_arrows(const SourceTree& tree) {
    Findings findings;
    for (const SourceFile& file : tree.files) {
        const std::string room = room_of(file.path);
        if (!is_code(file) || arrows().count(room) == 0) continue;
        for (const Include& include : includes_of(file)) {
            const std::string why = breach(file, include);
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
            const bool is_free =
                std::any_of(rule.folders.begin(), rule.folders.end(), [&](const auto& f) {
                    return starts_with(file.path, f);
                });
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

}  // namespace ink::house
