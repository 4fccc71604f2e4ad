#include "methods/registry.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/named.h"
#include "core/toml_reader.h"
#include "methods/presets.h"
#include "methods/shipped_texts.h"

// One line for each method, in the order in which tables show them. A static object of its own per
// method would register itself, and vanish with the object file that no other refers to when this
// is linked from a static library. Hence a list.
// clang-format off
#define INK_METHODS(X) \
    X(decaudin) \
    X(mote2) \
    X(mote4) \
    X(mote16) \
    X(two_sums) \
    X(label_plane) \
    X(polygon_offset) \
    X(edge_list) \
    X(back_faces) \
    X(edge_hash) \
    X(roberts) \
    X(sobel) \
    X(canny) \
    X(plane_distance) \
    X(rim) \
    X(ids) \
    X(ids_depth) \
    X(id_lookup) \
    X(inverted_hull) \
    X(jump_flood) \
    X(blurred_silhouette) \
    X(label8) \
    X(surface8) \
    X(surface8_depth) \
    X(surface_lookup) \
    X(strokes) \
    X(chords) \
    X(auto)
// clang-format on

namespace ink::methods {
namespace {

constexpr const char* kNeeded = "source, summary, family, marker";

/// The member of `all` that the text behind `key` names.
template <class All>
typename All::value_type named(const All& all, core::TomlReader& file, const char* key) {
    const std::string text = file.needed_text(key, kNeeded);
    std::vector<std::string> names;
    for (const auto each : all) {
        if (name_of(each) == text) return each;
        names.emplace_back(name_of(each));
    }
    throw core::Error(file.where(key),
                      fmt::format("there is no {} '{}'", key, text),
                      core::known_names(names, text));
}

method::SumLimit read_limit(core::TomlReader& table, const std::vector<core::Param>& params) {
    table.refuse_unknown({"params", "limit"});
    const auto names = table.texts("params");
    const auto limit = table.numbers("limit");
    if (!names || limit.size() != 1) {
        throw core::Error(
            table.where(), "this is no limit", "{params = [\"a\", \"b\"], limit = 255}");
    }
    method::SumLimit read{.params = {}, .limit = limit[0]};
    for (const core::TomlText& name : *names)
        read.params.push_back(core::param_of(params, name.text, table.where_line(name.line)).name);
    return read;
}

method::Tunable read_tunable(core::TomlReader& table,
                             const std::string& name,
                             const std::vector<core::Param>& params) {
    const core::Param& param = core::param_of(params, name, table.where(name));
    const auto ends = table.numbers(name);
    if (ends.empty() && table.texts(name)->front().text == "all") return {.param = name};
    const bool is_range =
        ends.size() == 2 && param.min <= ends[0] && ends[0] < ends[1] && ends[1] <= param.max;
    if (is_range) return {.param = name, .range = {{ends[0], ends[1]}}};
    throw core::Error(
        table.where(name),
        fmt::format("'{}' is searched over no such range", name),
        fmt::format("\"all\", or [low, high] within {}", core::accepted_values(param)));
}

}  // namespace

std::string ShippedFile::where() const {
    const std::string folder(name);
    return "methods/" + folder + "/" + folder + ".toml";
}

std::span<const ShippedFile> method_files() {
    return kMethodFiles;
}

std::span<const ShippedFile> shipped_presets() {
    return kPresetFiles;
}

method::MethodInfo described(method::MethodInfo info,
                             std::string_view text,
                             const std::string& where) {
    core::TomlReader file(text, where);
    file.refuse_unknown(
        {"source", "summary", "family", "marker", "sweep", "sum_limits", "tunables"});
    info.source = file.needed_text("source", kNeeded);
    info.summary = file.needed_text("summary", kNeeded);
    info.family = named(method::kFamilies, file, "family");
    info.marker = named(method::kMarkers, file, "marker");
    for (core::TomlReader& line : file.tables("sweep"))
        info.sweep.push_back(line.settings(info.params));
    for (core::TomlReader& limit : file.tables("sum_limits"))
        info.sum_limits.push_back(read_limit(limit, info.params));
    if (auto tunables = file.table("tunables")) {
        for (const std::string& name : tunables->keys())
            info.tunables.push_back(read_tunable(*tunables, name, info.params));
    }
    return info;
}

#define INK_DECLARE(name) method::MethodInfo name##_method();
INK_METHODS(INK_DECLARE)
#undef INK_DECLARE

namespace {

/// The method with what its file says.
method::MethodInfo with_data(method::MethodInfo info) {
    const auto files = method_files();
    const ShippedFile* file = core::find_named(files, info.name);
    if (file == nullptr)
        throw core::Error("methods/CMakeLists.txt", "it has no line '" + info.name + "'");
    return described(std::move(info), file->text, file->where());
}

std::vector<method::MethodInfo> all_methods() {
    std::vector<method::MethodInfo> methods;
#define INK_ADD(name) methods.push_back(with_data(name##_method()));
    INK_METHODS(INK_ADD)
#undef INK_ADD
    const std::vector<method::MethodInfo> bases = methods;
    for (const ShippedFile& preset : shipped_presets())
        methods.push_back(preset_method(parse_preset(preset.text, preset.where(), bases), bases));
    return methods;
}

}  // namespace

const std::vector<method::MethodInfo>& registry() {
    static const std::vector<method::MethodInfo> methods = all_methods();
    return methods;
}

const method::MethodInfo& find_method(const std::string& name) {
    if (const method::MethodInfo* found = core::find_named(registry(), name)) return *found;
    throw core::Error("methods",
                      "there is no method '" + name + "'",
                      core::known_names(core::names_of(registry()), name));
}

}  // namespace ink::methods
