#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "method/method.h"

namespace ink::methods {

/// A file of a method or a preset as the build took it in: the text of
/// `methods/<name>/<name>.toml`.
struct ShippedFile {
    std::string_view name;
    std::string_view text;

    /// Its path, for messages.
    [[nodiscard]] std::string where() const;
};

/// What methods have beside their code, in any order.
[[nodiscard]] std::span<const ShippedFile> method_files();

/// The presets that come with the program, in the order in which tables show them.
[[nodiscard]] std::span<const ShippedFile> shipped_presets();

/// `info`, which holds what is code of a method, with what its file says:
/// `methods/<name>/<name>.toml`
///
///     source = "who described it, and where"
///     summary = "one line for inkbench list"
///     family = "packed"
///     marker = "square"
///     sweep = [{}, {threshold = 3}]
///     sum_limits = [{params = ["range_depth", "range_normal"], limit = 255}]
///
///     [tunables]
///     range_depth = "all"
///     threshold = [1, 64]
///
/// sweep, sum_limits and tunables may be left out. Throws core::Error (where = "file:line") for
/// text that is no TOML, a key that is missing or unknown, a value of another type, a parameter
/// that the method does not have, a value that it does not accept. `where` is the file's name.
[[nodiscard]] method::MethodInfo described(method::MethodInfo info,
                                           std::string_view text,
                                           const std::string& where);

/// Every method, in the order in which tables show them. An explicit list: see registry.cpp.
[[nodiscard]] const std::vector<method::MethodInfo>& registry();

/// The method called `name`. Throws core::Error that lists the known names if there is none.
[[nodiscard]] const method::MethodInfo& find_method(const std::string& name);

}  // namespace ink::methods
