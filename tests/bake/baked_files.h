#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bake/mark.h"
#include "import/gltf/primitive.h"
#include "tests/import/glb_files.h"
#include "tests/import/model_files.h"

// What tests of baked files ask of them.

namespace ink::bake {

/// A glTF file that is open.
struct OpenFile {
    explicit OpenFile(const std::filesystem::path& path)
        : document(*import::open_gltf(path)), buffers(document), accessors(document, buffers) {}

    [[nodiscard]] import::GltfPrimitive primitive(std::size_t mesh, std::size_t number) {
        return {document,
                buffers,
                accessors,
                document.meshes[mesh].list("primitives", "primitive")[number]};
    }

    import::GltfDocument document;
    import::GltfBuffers buffers;
    import::GltfAccessors accessors;
};

/// A test that bakes files into a folder of its own.
class BakedFiles : public import::ModelFiles {
  protected:
    /// The file at `from`, baked to `to`; what was said of it.
    BakedFile bake_to(const std::filesystem::path& from,
                      const std::string& to,
                      const BakeOptions& options) const {
        BakedFile baked = bake(from, import::import_model(from), options, in_folder(to));
        (void)write(to, baked.bytes);
        return baked;
    }

    /// What bake complains of.
    [[nodiscard]] std::string complaint_of(const std::filesystem::path& from,
                                           const BakeOptions& options,
                                           const std::string& to = "out.glb") const {
        try {
            (void)bake(from, import::import_model(from), options, in_folder(to));
        } catch (const core::Error& error) {
            return error.what();
        }
        ADD_FAILURE() << from << " was baked";
        return {};
    }
};

/// Whether a value may differ: what leads from a primitive to its numbers, and how long a buffer
/// is.
inline bool may_change(const std::string& place) {
    return (place.find("/primitives/") != place.npos &&
            (place.find("/attributes/") != place.npos || place.find("/targets/") != place.npos ||
             place.ends_with("/indices") || place.ends_with("/mode"))) ||
           (place.starts_with("/buffers/") && place.ends_with("/byteLength"));
}

/// All that was in the JSON is there still; lists may be longer, objects have more.
inline void expect_additions_only(const nlohmann::json& before,
                                  const nlohmann::json& after,
                                  const std::string& place = "") {
    if (before.is_object() && after.is_object()) {
        for (const auto& [key, value] : before.items()) {
            ASSERT_TRUE(after.contains(key)) << place << '/' << key << " is gone";
            expect_additions_only(value, after[key], place + '/' + key);
        }
    } else if (before.is_array() && after.is_array()) {
        ASSERT_GE(after.size(), before.size()) << place;
        for (std::size_t i = 0; i < before.size(); ++i)
            expect_additions_only(before[i], after[i], place + '/' + std::to_string(i));
    } else if (!may_change(place)) {
        EXPECT_EQ(before, after) << place;
        EXPECT_EQ(before.type(), after.type()) << place;
    }
}

/// Every corner of every triangle of a primitive has the attributes and targets that it had, and
/// triangles are wound as they were.
inline void expect_same_corners(OpenFile& before,
                                OpenFile& after,
                                std::size_t mesh,
                                std::size_t number) {
    import::GltfPrimitive old = before.primitive(mesh, number);
    import::GltfPrimitive now = after.primitive(mesh, number);
    const auto old_triangles = old.triangles();
    const auto triangles = now.triangles();
    ASSERT_EQ(triangles.size(), old_triangles.size());
    // Per corner its numbers, one after the other.
    const auto corners = [](OpenFile& file, import::GltfPrimitive& primitive, const auto& names) {
        std::vector<std::vector<double>> numbers(primitive.vertices());
        const auto add = [&](const std::vector<double>& components) {
            const std::size_t width = components.size() / numbers.size();
            for (std::size_t v = 0; v < numbers.size(); ++v)
                for (std::size_t c = 0; c < width; ++c)
                    numbers[v].push_back(components[v * width + c]);
        };
        for (const std::string& name : names)
            add(primitive.components(name.c_str()));
        for (const import::JsonObject& target : primitive.json().list("targets", "target"))
            for (const char* name : {"POSITION", "NORMAL"})
                if (const auto accessor = target.find_index(name, file.accessors.size()))
                    add(file.accessors.components(*accessor));
        return numbers;
    };
    std::vector<std::string> names;
    for (const auto& [name, accessor] :
         (*before.document.json)["meshes"][mesh]["primitives"][number]["attributes"].items())
        names.push_back(name);
    const auto old_corners = corners(before, old, names);
    const auto new_corners = corners(after, now, names);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        bool is_found = false;
        for (std::size_t turn = 0; turn < 3; ++turn) {
            bool is_it = true;
            for (std::size_t i = 0; i < 3; ++i)
                is_it &=
                    old_corners[old_triangles[t][(i + turn) % 3]] == new_corners[triangles[t][i]];
            is_found |= is_it;
        }
        EXPECT_TRUE(is_found) << "triangle " << t;
    }
}

/// The first and the last vertex of every triangle have this code.
inline void expect_codes(OpenFile& file,
                         std::size_t mesh,
                         std::size_t number,
                         const std::vector<std::uint32_t>& codes) {
    import::GltfPrimitive primitive = file.primitive(mesh, number);
    const std::vector<double> ink = primitive.components("_INK");
    const auto triangles = primitive.triangles();
    ASSERT_EQ(triangles.size(), codes.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        EXPECT_EQ(ink[triangles[t][0]], codes[t]) << "triangle " << t;
        EXPECT_EQ(ink[triangles[t][2]], codes[t]) << "triangle " << t;
    }
}

}  // namespace ink::bake
