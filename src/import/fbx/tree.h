#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ink::import {

/// A value of an FBX element: a text or bare word, a number, or an array.
struct FbxValue {
    std::string text;
    std::int64_t whole = 0;
    double real = 0;
    bool is_array = false;
    std::vector<double> list;  ///< of an array, whole numbers too
};

/// "Name: values { children }", as text and binary files have it alike.
struct FbxElement {
    std::string name;
    std::vector<FbxValue> values;
    std::vector<FbxElement> children;

    /// The first child of that name, or nothing.
    [[nodiscard]] const FbxElement* child(std::string_view called) const;
    /// Value `i`, empty or 0 where there is none.
    [[nodiscard]] std::string text(std::size_t i) const;
    [[nodiscard]] std::int64_t whole(std::size_t i) const;
    [[nodiscard]] double real(std::size_t i) const;
    /// The numbers of child `called`, an array or not; empty where there is none.
    [[nodiscard]] std::vector<double> list(std::string_view called) const;
    /// The text or word of child `called`; empty where there is none.
    [[nodiscard]] std::string word(std::string_view called) const;
};

[[nodiscard]] bool is_fbx_binary(std::string_view file);

/// A whole file: an element whose children are those of the file's outermost level. Throws
/// core::Error, which says where, for a damaged file.
[[nodiscard]] FbxElement read_fbx_tree(std::string_view file);

}  // namespace ink::import
