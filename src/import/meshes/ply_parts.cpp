#include "import/meshes/ply_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"

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

static_assert(std::endian::native == std::endian::little);

PlyBody::PlyBody(std::string_view file, const PlyHeader& header)
    : format_(header.format),
      file_(file),
      at_(header.bytes),
      words_(file.substr(header.bytes), {}, header.lines + 1) {}

template <class T>
T PlyBody::take() {
    if (file_.size() - at_ < sizeof(T)) fail_short();
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), file_.data() + at_, sizeof(T));
    if (format_ == PlyFormat::binary_big_endian) std::reverse(raw.begin(), raw.end());
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
}

void PlyBody::begin_row(const PlyElement& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
    if (is_text() && !words_.next_line()) fail_short();
}

void PlyBody::end_row() {
    if (!is_text() || words_.is_line_over()) return;
    words_.fail("more numbers than the properties of element " + in_quotes(element_->name),
                "one line for each, of as many numbers as it has properties");
}

double PlyBody::value(PlyType type) {
    if (is_text()) return words_.number("a number of element " + in_quotes(element_->name));
    switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            return take<double>();
    }
    return 0;
}

std::uint64_t PlyBody::length(PlyType type, std::size_t bytes) {
    const double length = value(type);
    if (!(length >= 0) || length != std::floor(length))
        fail("a list has " + shown(length) + " entries", "a whole number of 0 or more");
    // In a text each entry takes a digit and a blank, but for the last one's.
    const std::size_t left = is_text() ? file_.size() / 2 + 1 : (file_.size() - at_) / bytes;
    if (length > static_cast<double>(left)) fail_short();
    return static_cast<std::uint64_t>(length);
}

std::uint64_t PlyBody::most_rows(const PlyElement& element) const {
    const std::size_t least =
        std::max<std::size_t>(is_text() ? 2 * element.properties.size() : element.least_bytes(), 1);
    return std::min<std::uint64_t>(element.count, file_.size() / least + 1);
}

void PlyBody::fail(const std::string& what, const std::string& accepted) const {
    if (is_text()) words_.fail(what, accepted);
    throw core::Error("", "byte " + std::to_string(at_) + ": " + what, accepted);
}

void PlyBody::fail_short() const {
    throw core::Error("",
                      "the file is cut short: it ends in element " + in_quotes(element_->name) +
                          ", row " + std::to_string(row_ + 1) + " of " +
                          std::to_string(element_->count),
                      "all rows that the header promises");
}

std::string PlyBody::shown(double value) {
    if (std::isnan(value)) return "nan";
    const auto whole = static_cast<std::int64_t>(std::clamp(value, -1e15, 1e15));
    return static_cast<double>(whole) == value ? std::to_string(whole) : std::to_string(value);
}

}  // namespace ink::import
