#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "import/meshes/line_words.h"
#include "import/meshes/ply_header.h"

namespace ink::import {

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
