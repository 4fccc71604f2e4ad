#include "import/meshes/ply_header.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "import/meshes/line_words.h"

namespace ink::import {
namespace {

struct TypeName {
    std::string_view old_name;
    std::string_view new_name;
    std::size_t bytes;
};
constexpr std::array<TypeName, 8> kTypes{{{"char", "int8", 1},
                                          {"uchar", "uint8", 1},
                                          {"short", "int16", 2},
                                          {"ushort", "uint16", 2},
                                          {"int", "int32", 4},
                                          {"uint", "uint32", 4},
                                          {"float", "float32", 4},
                                          {"double", "float64", 8}}};

PlyType read_type(LineWords& words) {
    const std::string_view name = words.word();
    for (std::size_t t = 0; t < kTypes.size(); ++t)
        if (name == kTypes[t].old_name || name == kTypes[t].new_name)
            return static_cast<PlyType>(t);
    words.fail("the type is " + in_quotes(name),
               "char, uchar, short, ushort, int, uint, float, double, int8, uint8, int16, uint16, "
               "int32, uint32, float32 or float64");
}

PlyFormat read_format(LineWords& words) {
    const std::string_view name = words.word();
    const std::string_view version = words.word();
    if (version != "1.0") words.fail("the version is " + in_quotes(version), "1.0");
    if (name == "ascii") return PlyFormat::ascii;
    if (name == "binary_little_endian") return PlyFormat::binary_little_endian;
    if (name == "binary_big_endian") return PlyFormat::binary_big_endian;
    words.fail("the format is " + in_quotes(name),
               "ascii, binary_little_endian or binary_big_endian");
}

PlyElement read_element(LineWords& words) {
    PlyElement element;
    element.name = words.word();
    element.count = words.count("the element's count");
    element.line = words.line();
    return element;
}

PlyProperty read_property(LineWords& words) {
    PlyProperty property;
    LineWords ahead = words;
    if (ahead.word() == "list") {
        words = ahead;
        property.count_type = read_type(words);
        if (*property.count_type >= PlyType::float32)
            words.fail("the length of a list is a fraction", "a type of whole numbers");
    }
    property.type = read_type(words);
    property.name = words.word();
    if (property.name.empty()) words.fail("a property has no name", "a name");
    return property;
}

void read_line(LineWords& words, PlyHeader& header, bool& has_format) {
    const std::string_view keyword = words.word();
    if (keyword == "comment" || keyword == "obj_info") return;
    if (keyword == "format") {
        header.format = read_format(words);
        has_format = true;
    } else if (keyword == "element") {
        header.elements.push_back(read_element(words));
    } else if (keyword == "property" && !header.elements.empty()) {
        header.elements.back().properties.push_back(read_property(words));
    } else if (!header.elements.empty()) {  // Blender 2.4 began with a comment without the word
        words.fail("the header says " + in_quotes(keyword),
                   "format, comment, obj_info, element, property or end_header");
    }
}

/// Where the line that begins at `first` ends, without its end.
std::size_t end_of_line(std::string_view file, std::size_t first) {
    return std::min(file.find_first_of("\r\n", first), file.size());
}

/// How many bytes end the line whose end is at `end`, in a file whose first line ends like
/// `is_cr_alone` says.
std::size_t line_end_bytes(std::string_view file, std::size_t end, bool is_cr_alone) {
    if (end == file.size()) return 0;
    return file[end] == '\r' && !is_cr_alone && file.substr(end + 1).starts_with('\n') ? 2 : 1;
}

}  // namespace

std::size_t bytes_of(PlyType type) {
    return kTypes.at(static_cast<std::size_t>(type)).bytes;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    for (std::size_t p = 0; p < properties.size(); ++p)
        if (properties[p].name == property) return p;
    return std::nullopt;
}

std::size_t PlyElement::least_bytes() const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties)
        bytes += bytes_of(property.count_type.value_or(property.type));
    return bytes;
}

PlyHeader read_ply_header(std::string_view file) {
    PlyHeader header;
    bool has_format = false;
    const std::size_t first_end = end_of_line(file, 0);
    const bool is_cr_alone =
        file.substr(first_end).starts_with('\r') && !file.substr(first_end).starts_with("\r\n");
    for (std::size_t line = 1, at = 0; at < file.size(); ++line) {
        const std::size_t end = end_of_line(file, at);
        LineWords words(file.substr(at, end - at), {}, line);
        at = end + line_end_bytes(file, end, is_cr_alone);
        if (!words.next_line()) continue;
        LineWords ahead = words;
        if (ahead.word() == "end_header") {
            if (!has_format) words.fail("the header names no format", "a line \"format ...\"");
            header.bytes = at;
            header.lines = line;
            return header;
        }
        if (line > 1) read_line(words, header, has_format);
        if (line == 1 && ahead.line() == 1 && file.substr(0, 3) != "ply")
            words.fail("the file begins with " + in_quotes(words.word()), "ply");
    }
    throw core::Error("", "the file ends inside its header", "a line \"end_header\"");
}

}  // namespace ink::import
