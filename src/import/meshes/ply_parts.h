#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "import/meshes/line_words.h"

namespace ink::import {

/// The number types of PLY, each of two names: char or int8, and so on.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t bytes_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type{};  ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t line = 0;  ///< where the header declares it

    /// The number of the property called so; nothing if there is none.
    [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
    /// Bytes that a row takes in a binary file, lists being empty.
    [[nodiscard]] std::size_t least_bytes() const;
};

enum class PlyFormat { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  ///< the body begins here
    std::size_t lines = 0;  ///< before the body
};

/// The header of a file that begins with "ply". Its lines may end with LF, CR LF or CR; the first
/// line's end decides, so that a body may begin with the byte of a line feed. Throws core::Error
/// about the line that is wrong.
[[nodiscard]] PlyHeader read_ply_header(std::string_view file);

/// What follows a PLY file's header, number by number.
class PlyBody {
  public:
    /// `file` must outlive this.
    PlyBody(std::string_view file, const PlyHeader& header);

    [[nodiscard]] bool is_text() const { return format_ == PlyFormat::ascii; }

    /// Goes on to a row of an element; each is a line of a text.
    void begin_row(const PlyElement& element, std::uint64_t row);
    void end_row();

    double value(PlyType type);
    /// The length of a list whose entries take `bytes` each; they can lie in the file.
    std::uint64_t length(PlyType type, std::size_t bytes);

    /// How many rows there can be at most, so that a hostile count allocates nothing.
    [[nodiscard]] std::uint64_t most_rows(const PlyElement& element) const;

    /// Throws Error about the line or byte where it stands.
    [[noreturn]] void fail(const std::string& what, const std::string& accepted) const;
    /// A number as whole as it is.
    [[nodiscard]] static std::string shown(double value);

  private:
    template <class T>
    T take();
    [[noreturn]] void fail_short() const;

    PlyFormat format_;
    std::string_view file_;
    std::size_t at_;
    LineWords words_;
    const PlyElement* element_ = nullptr;  ///< the one being read
    std::uint64_t row_ = 0;
};

}  // namespace ink::import
