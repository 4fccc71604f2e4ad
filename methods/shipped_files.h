#pragma once

#include <span>
#include <string>
#include <string_view>

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

}  // namespace ink::methods
