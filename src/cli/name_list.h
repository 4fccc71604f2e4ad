#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ink::cli {

/// What the list of an option may name.
struct Names {
    std::string option;  ///< where a mistake is said to be, "--methods"
    std::string noun;    ///< "method"
    std::vector<std::string> known;
};

/// The parts of comma lists without the blanks round them, in order; empty ones are left out.
[[nodiscard]] std::vector<std::string> list_parts(const std::vector<std::string>& texts);

/// Whether `text` has a `*`, a `?` or a `[`.
[[nodiscard]] bool is_glob(std::string_view text);

/// Those of `names` that fit the glob, in their order.
[[nodiscard]] std::vector<std::string> fitting(const std::string& glob,
                                               const std::vector<std::string>& names);

/// Throws core::Error: nothing is called or fits `wrong`. It lists what is known and the nearest
/// spelling.
[[noreturn]] void refuse_name(const Names& names, const std::string& wrong);

/// A list in which a name stands once, unless it was spelt out more than once by itself.
class NameList {
  public:
    /// A name that was spelt out.
    void add(const std::string& name);
    /// A name that a glob or a group stands for.
    void add_implied(const std::string& name);
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  private:
    std::vector<std::string> names_;
    std::vector<std::string> implied_;
};

/// The names that comma lists and globs mean; "all" is every one. No texts: none.
///
/// Throws core::Error (where = the option) for an unknown name, a glob that nothing fits, and lists
/// that name nothing. A name that is spelt out twice comes out twice.
[[nodiscard]] std::vector<std::string> listed_names(const std::vector<std::string>& texts,
                                                    const Names& names);

}  // namespace ink::cli
