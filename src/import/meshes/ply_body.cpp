#include "import/meshes/ply_body.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"

namespace ink::import {

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
