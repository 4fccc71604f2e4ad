#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "tests/import/quake_files.h"

// FBX files by code, each as text and as binary of several forms.

namespace ink::import::fbx {

using Numbers = std::vector<double>;
using Value = std::variant<std::int64_t, double, std::string, Numbers, std::vector<std::int32_t>>;

/// An element with its values and children.
struct Node {
    std::string name;
    std::vector<Value> values{};
    std::vector<Node> children{};
};

inline std::string text_of(const Node& node) {
    std::string text = node.name + ": ";
    std::string_view comma;
    for (const Value& value : node.values) {
        text += comma;
        comma = ", ";
        if (const auto* whole = std::get_if<std::int64_t>(&value))
            text += fmt::format("{}", *whole);
        if (const auto* real = std::get_if<double>(&value)) text += fmt::format("{}", *real);
        if (const auto* words = std::get_if<std::string>(&value)) text += '"' + *words + '"';
        const auto array = [&](const auto& list) {
            text += fmt::format("*{} {{\n a: {}\n}}", list.size(), fmt::join(list, ","));
        };
        if (const auto* list = std::get_if<Numbers>(&value)) array(*list);
        if (const auto* list = std::get_if<std::vector<std::int32_t>>(&value)) array(*list);
    }
    if (!node.children.empty()) {
        text += " {\n";
        for (const Node& child : node.children)
            text += text_of(child);
        text += '}';
    }
    return text + '\n';
}

/// How a binary file is written.
struct Form {
    bool is_wide = false;    ///< version 7500: places of 8 bytes
    bool is_packed = false;  ///< arrays by zlib
};

template <class T>
std::string array_bytes(char type, const std::vector<T>& list, bool is_packed) {
    std::string plain;
    for (const T& value : list)
        put(plain, value);
    std::string packed(compressBound(plain.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()),
             &size,
             reinterpret_cast<const Bytef*>(plain.data()),
             plain.size());
    packed.resize(size);
    const std::string& data = is_packed ? packed : plain;
    std::string bytes(1, type);
    put(bytes, static_cast<std::uint32_t>(list.size()));
    put(bytes, static_cast<std::uint32_t>(is_packed ? 1 : 0));
    put(bytes, static_cast<std::uint32_t>(data.size()));
    return bytes + data;
}

/// "Model::box" as binary files have it.
inline std::string binary_name(const std::string& words) {
    const std::size_t at = words.find("::");
    if (at == words.npos) return words;
    return words.substr(at + 2) + std::string("\0\1", 2) + words.substr(0, at);
}

inline std::string value_bytes(const Value& value, const Form& form) {
    std::string bytes;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        bytes = "L";
        put(bytes, *whole);
    } else if (const auto* real = std::get_if<double>(&value)) {
        bytes = "D";
        put(bytes, *real);
    } else if (const auto* words = std::get_if<std::string>(&value)) {
        const std::string name = binary_name(*words);
        bytes = "S";
        put(bytes, static_cast<std::uint32_t>(name.size()));
        bytes += name;
    } else if (const auto* list = std::get_if<Numbers>(&value)) {
        bytes = array_bytes('d', *list, form.is_packed);
    } else {
        bytes = array_bytes('i', std::get<std::vector<std::int32_t>>(value), form.is_packed);
    }
    return bytes;
}

inline void put_place(std::string& bytes, std::size_t place, const Form& form) {
    if (form.is_wide) put(bytes, static_cast<std::uint64_t>(place));
    if (!form.is_wide) put(bytes, static_cast<std::uint32_t>(place));
}

/// An element of no name and no end, which ends a list.
inline std::string list_end(const Form& form) {
    return std::string(form.is_wide ? 25 : 13, '\0');
}

inline std::string bytes_of(const Node& node, std::size_t begin, const Form& form) {
    std::string values;
    for (const Value& value : node.values)
        values += value_bytes(value, form);
    std::string rest(1, static_cast<char>(node.name.size()));
    rest += node.name + values;
    const std::size_t head = form.is_wide ? 24 : 12;
    for (const Node& child : node.children)
        rest += bytes_of(child, begin + head + rest.size(), form);
    if (!node.children.empty()) rest += list_end(form);
    std::string bytes;
    put_place(bytes, begin + head + rest.size(), form);
    put_place(bytes, node.values.size(), form);
    put_place(bytes, values.size(), form);
    return bytes + rest;
}

inline Node property(const std::string& name, const std::vector<double>& numbers) {
    Node node{"P", {name, "", "", "A"}};
    for (const double number : numbers)
        node.values.emplace_back(number);
    return node;
}
inline Node property(const std::string& name, int number) {
    return {"P", {name, "int", "Integer", "", std::int64_t{number}}};
}

/// A scene whose objects are made one by one.
struct File {
    std::int64_t version = 7400;
    std::vector<Node> settings{};
    std::vector<Node> definitions{};
    std::vector<Node> objects{};
    std::vector<Node> links{};

    /// Adds an object below `parent` (0: the scene) and returns its number.
    std::int64_t add(std::int64_t parent,
                     const std::string& element,
                     const std::string& name,
                     const std::string& kind,
                     std::vector<Node> children = {}) {
        const auto number = static_cast<std::int64_t>(objects.size()) + 9007199254740993;
        objects.push_back({element, {number, element + "::" + name, kind}, std::move(children)});
        link(number, parent);
        return number;
    }
    std::int64_t model(std::int64_t parent,
                       const std::string& name,
                       const std::vector<Node>& properties = {},
                       const std::string& kind = "Mesh") {
        return add(parent, "Model", name, kind, {{"Properties70", {}, properties}});
    }
    void attribute(std::int64_t model,
                   const std::string& kind,
                   const std::vector<Node>& properties) {
        add(model, "NodeAttribute", kind, kind, {{"Properties70", {}, properties}});
    }
    void link(std::int64_t child, std::int64_t parent) {
        links.push_back({"C", {"OO", child, parent}});
    }

    [[nodiscard]] std::vector<Node> elements() const {
        return {{"FBXHeaderExtension", {}, {{"FBXVersion", {version}}}},
                {"GlobalSettings", {}, {{"Properties70", {}, settings}}},
                {"Definitions", {}, definitions},
                {"Objects", {}, objects},
                {"Connections", {}, links}};
    }
    [[nodiscard]] std::string text() const {
        std::string text = "; FBX 7.4.0 project file\n";
        for (const Node& node : elements())
            text += text_of(node);
        return text;
    }
    [[nodiscard]] std::string bytes(const Form& form = {}) const {
        std::string bytes("Kaydara FBX Binary  \0\x1a\0", 23);
        put(bytes, static_cast<std::uint32_t>(form.is_wide ? 7500 : 7400));
        for (const Node& node : elements())
            bytes += bytes_of(node, bytes.size(), form);
        return bytes + list_end(form);
    }
};

/// A box of 1 x 2 x 3 from zero, point by point: the last coordinate goes first.
inline std::int64_t add_box(File& file, std::int64_t model, std::vector<Node> more = {}) {
    std::vector<Node> children{
        {"Vertices",
         {Numbers{0, 0, 0, 0, 0, 3, 0, 2, 0, 0, 2, 3, 1, 0, 0, 1, 0, 3, 1, 2, 0, 1, 2, 3}}},
        {"PolygonVertexIndex", {std::vector<std::int32_t>{0, 1, 3, -3, 4, 6, 7, -6, 0, 4, 5, -2,
                                                          2, 3, 7, -7, 0, 2, 6, -5, 1, 5, 7, -4}}}};
    children.insert(children.end(), more.begin(), more.end());
    return file.add(model, "Geometry", "g", "Mesh", children);
}

/// A shape that moves the box's points 2, 3, 6 and 7 by 2 along y.
inline std::vector<Node> taller() {
    return {{"Indexes", {std::vector<std::int32_t>{2, 3, 6, 7}}},
            {"Vertices", {Numbers{0, 2, 0, 0, 2, 0, 0, 2, 0, 0, 2, 0}}}};
}

}  // namespace ink::import::fbx
