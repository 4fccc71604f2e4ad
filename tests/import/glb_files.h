#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace ink::import {

using Json = nlohmann::json;

/// A .glb under construction: its JSON, and one buffer that its accessors fill.
struct GlbFile {
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
    std::string data;

    /// Adds an entry to a list of the JSON; returns its number.
    std::size_t put(const char* list, Json entry) {
        json[list].push_back(std::move(entry));
        return json[list].size() - 1;
    }
    /// Adds bytes as a bufferView.
    std::size_t view(const std::string& bytes) {
        data.resize((data.size() + 3) / 4 * 4);
        const std::size_t offset = data.size();
        data += bytes;
        return put("bufferViews",
                   {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    }
    /// Adds an accessor to `values`, of "VEC3" and the like; `more` are further members of it.
    template <class T>
    std::size_t accessor(const std::vector<T>& values,
                         const std::string& type,
                         const Json& more = Json::object()) {
        const std::size_t width = width_of(type);
        Json entry = {
            {"bufferView",
             view({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)})},
            {"componentType", code_of<T>()},
            {"count", values.size() / width},
            {"type", type}};
        entry.update(more);
        return put("accessors", entry);
    }
    [[nodiscard]] std::string bytes() const {
        Json whole = json;
        if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", data.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string binary = data;
        binary.resize((binary.size() + 3) / 4 * 4);
        return word(0x46546c67) + word(2) + word(28 + text.size() + binary.size()) +
               word(text.size()) + "JSON" + text + word(binary.size()) + std::string("BIN\0", 4) +
               binary;
    }

    static std::size_t width_of(const std::string& type) {
        return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
    }
    template <class T>
    static int code_of() {
        if constexpr (std::is_same_v<T, float>) return 5126;
        return (sizeof(T) == 1 ? 5120 : sizeof(T) == 2 ? 5122 : 5124) + std::is_unsigned_v<T>;
    }
    static std::string word(std::size_t value) {
        const auto bits = static_cast<std::uint32_t>(value);
        return {reinterpret_cast<const char*>(&bits), sizeof bits};
    }
};

inline const Json kUnits = {{"normalized", true}};

/// The corners of a cube 0..1, x fastest, scaled.
template <class T>
std::vector<T> cube_corners(int size = 1) {
    std::vector<T> corners;
    for (int v = 0; v < 8; ++v)
        for (int axis = 0; axis < 3; ++axis)
            corners.push_back(static_cast<T>((v >> axis & 1) * size));
    return corners;
}

inline const std::vector<std::uint16_t> kCubeIndices{0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
                                                     0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7,
                                                     0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};

/// A primitive of a cube's triangles on positions that are there already.
inline Json cube_primitive(GlbFile& file, std::size_t positions) {
    return {{"attributes", {{"POSITION", positions}}},
            {"indices", file.accessor(kCubeIndices, "SCALAR")}};
}

/// The file with one mesh, a cube 0..1.
inline GlbFile cube_file() {
    GlbFile file;
    const std::size_t positions = file.accessor(cube_corners<float>(), "VEC3");
    file.put("meshes", {{"primitives", {cube_primitive(file, positions)}}});
    return file;
}

/// Adds an animation of one channel.
inline void animate(GlbFile& file,
                    std::size_t node,
                    const std::string& path,
                    std::size_t output,
                    const std::vector<float>& times_s,
                    const std::string& interpolation = "LINEAR") {
    file.put("animations",
             {{"name", path},
              {"samplers",
               {{{"input", file.accessor(times_s, "SCALAR")},
                 {"output", output},
                 {"interpolation", interpolation}}}},
              {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
}

}  // namespace ink::import
