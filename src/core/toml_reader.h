#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/param.h"

namespace ink::core {

/// A value of a TOML file as text, with its line.
struct TomlText {
    std::string text;
    int line = 0;
};

/// A table of a TOML file, read strictly: what nobody asked for is an error.
class TomlReader {
  public:
    /// The whole of a file, by its text. Throws Error (where = file and line) if it is no TOML.
    TomlReader(std::string_view text, std::filesystem::path file);

    [[nodiscard]] std::optional<std::string> text(const std::string& key);
    /// The same of a key that must be there; `needed` names those that must.
    [[nodiscard]] std::string needed_text(const std::string& key, const std::string& needed);
    /// The value of a key that is there, as the command line would spell it; one of another type
    /// than `param` has is refused.
    [[nodiscard]] std::string scalar(const std::string& key, const Param& param);
    /// One value, or an array of them, each as the command line would spell it: "true", "63",
    /// "0.5", "inside". Nothing if the key is not there; an empty array is an error.
    [[nodiscard]] std::optional<std::vector<TomlText>> texts(const std::string& key);
    /// A number, or the numbers of an array; empty for anything else.
    [[nodiscard]] std::vector<double> numbers(const std::string& key) const;
    /// A table inside; nothing if the key is not there.
    [[nodiscard]] std::optional<TomlReader> table(const std::string& key);
    /// The same, empty if the key is not there.
    [[nodiscard]] TomlReader table_or_empty(const std::string& key);
    /// An array of tables; empty if the key is not there.
    [[nodiscard]] std::vector<TomlReader> tables(const std::string& key);
    /// All keys as settings of a method that has these parameters, as the command line spells them.
    [[nodiscard]] ParamValues settings(const std::vector<Param>& params);

    [[nodiscard]] std::vector<std::string> keys() const;  ///< in the order of the file
    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] bool is_table(const std::string& key) const;
    [[nodiscard]] bool is_empty(const std::string& key) const;  ///< an array without values
    /// file:line of a key, or of the table.
    [[nodiscard]] std::string where(const std::string& key = "") const;
    [[nodiscard]] std::string where_line(int line) const;

    /// Throws Error for the first key that was not asked for; the message lists `known`.
    void refuse_unknown(const std::vector<std::string>& known) const;

  private:
    struct Table;  // of toml++, with the file's whole document

    TomlReader(std::shared_ptr<const Table> table, std::filesystem::path file, std::string name);
    [[noreturn]] void refuse(const std::string& key, const std::string& accepted) const;
    [[nodiscard]] std::string full_name(const std::string& key) const;

    std::shared_ptr<const Table> table_;
    std::filesystem::path file_;
    std::string name_;
};

/// The parameter called `name`. Throws Error (where = place) if there is none.
[[nodiscard]] const Param& param_of(const std::vector<Param>& params,
                                    const std::string& name,
                                    const std::string& place);

}  // namespace ink::core
