#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/param.h"

namespace ink::experiment {

/// A value of a TOML file as text, with its line.
struct TomlText {
    std::string text;
    int line = 0;
};

/// A table of a TOML file, read strictly: what nobody asked for is an error.
class TomlReader {
  public:
    /// `name` is the table's, "" for the whole file. Borrows `table`.
    TomlReader(const toml::table& table, std::filesystem::path file, std::string name);

    [[nodiscard]] std::optional<std::string> text(const std::string& key);
    /// The value of a key that is there, as the command line would spell it; one of another type
    /// than `param` has is refused.
    [[nodiscard]] std::string scalar(const std::string& key, const core::Param& param);
    /// One value, or an array of them, each as the command line would spell it: "true", "63",
    /// "0.5", "inside". Nothing if the key is not there; an empty array is an error.
    [[nodiscard]] std::optional<std::vector<TomlText>> texts(const std::string& key);
    /// A table inside; nothing if the key is not there.
    [[nodiscard]] std::optional<TomlReader> table(const std::string& key);

    [[nodiscard]] std::vector<std::string> keys() const;  ///< in the order of the file
    [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }
    [[nodiscard]] bool is_table(const std::string& key) const;
    /// file:line of a key, or of the table.
    [[nodiscard]] std::string where(const std::string& key = "") const;
    [[nodiscard]] std::string where_line(int line) const;

    /// Throws core::Error for the first key that was not asked for; the message lists `known`.
    void refuse_unknown(const std::vector<std::string>& known) const;

  private:
    [[noreturn]] void refuse(const std::string& key, const std::string& accepted) const;
    [[nodiscard]] const toml::node* find(const std::string& key) const;
    [[nodiscard]] std::string full_name(const std::string& key) const;

    const toml::table& table_;
    std::filesystem::path file_;
    std::string name_;
};

/// Parses a file's text. Throws core::Error (where = file and line) if it is no TOML.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::filesystem::path& file);

}  // namespace ink::experiment
