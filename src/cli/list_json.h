#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace ink::cli {

/// What cli::listing says as text, for programs: an object with one array per topic, each of
/// objects with `name` first; params are objects of `method` and its `params`. Throws core::Error
/// that lists the topics for another word than one of them or "all".
[[nodiscard]] nlohmann::ordered_json listing_json(const std::string& what);

/// The names of everything, a few lines per topic, and where more is said.
[[nodiscard]] std::string list_overview();

}  // namespace ink::cli
