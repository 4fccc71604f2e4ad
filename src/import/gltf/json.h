#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ink::import {

/// An object of a glTF file's JSON, with its place for messages: "accessor 3, sparse".
///
/// Nothing is taken from it unchecked: a value of another type, out of range or missing becomes an
/// Error that names the place, the value and what would do. Borrows the JSON.
class JsonObject {
  public:
    /// Fails unless `json` is an object.
    JsonObject(const nlohmann::json& json, std::string place);

    [[nodiscard]] const std::string& place() const { return place_; }
    [[noreturn]] void fail(const std::string& what, const std::string& accepted = {}) const;
    /// As `fail`, of something that is no fault of the file (Refusal).
    [[noreturn]] void refuse(const std::string& what, const std::string& accepted = {}) const;

    [[nodiscard]] bool has(const char* key) const;
    /// Whether the values under `key` are the same in both, or missing in both.
    [[nodiscard]] bool is_same(const char* key, const JsonObject& other) const;

    [[nodiscard]] std::optional<JsonObject> find(const char* key) const;
    [[nodiscard]] JsonObject at(const char* key) const;
    [[nodiscard]] std::optional<JsonObject> extension(const char* name) const;
    /// The objects of a list; none if it is missing. Each is called `singular` and its number.
    [[nodiscard]] std::vector<JsonObject> list(const char* key, const char* singular) const;

    /// A whole number from 0 to `most`.
    [[nodiscard]] std::uint64_t whole(const char* key, std::uint64_t most) const;
    [[nodiscard]] std::uint64_t whole_or(const char* key,
                                         std::uint64_t most,
                                         std::uint64_t fallback) const;
    /// A number of one of `size` things.
    [[nodiscard]] std::size_t index(const char* key, std::size_t size) const;
    [[nodiscard]] std::optional<std::size_t> find_index(const char* key, std::size_t size) const;
    [[nodiscard]] std::vector<std::size_t> indices(const char* key, std::size_t size) const;

    [[nodiscard]] double number(const char* key) const;
    /// Finite numbers, `size` of them unless that is 0; nothing if the list is missing.
    [[nodiscard]] std::optional<std::vector<double>> numbers(const char* key,
                                                             std::size_t size) const;
    /// "" if it is missing.
    [[nodiscard]] std::string text(const char* key) const;
    [[nodiscard]] std::vector<std::string> texts(const char* key) const;
    [[nodiscard]] bool flag_or(const char* key, bool fallback) const;

  private:
    [[nodiscard]] const nlohmann::json* value(const char* key) const;
    /// The list under `key`; an empty one if it is missing.
    [[nodiscard]] const nlohmann::json& array(const char* key) const;
    [[nodiscard]] const nlohmann::json& needed(const char* key) const;
    [[noreturn]] void fail_at(const char* key,
                              const nlohmann::json& value,
                              const std::string& accepted) const;
    [[nodiscard]] std::uint64_t whole_of(const nlohmann::json& value,
                                         const char* key,
                                         std::uint64_t most) const;

    const nlohmann::json* json_;
    std::string place_;
};

/// The JSON in `text`. Throws Error if it is none, or nested deeper than any model needs.
[[nodiscard]] nlohmann::json parse_json(std::span<const std::byte> text);

}  // namespace ink::import
