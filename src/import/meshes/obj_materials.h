#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace ink::import {

/// All of the file of a name beside the model; nothing if there is none.
using FilesBeside = std::function<std::string(const std::string&)>;

/// The names of a material library's (MTL) materials that let light through: d below 1, or Tr above
/// 0. Only names and these are looked at; what is wrong in others is none of ours.
[[nodiscard]] std::set<std::string> transparent_materials(std::string_view library);

}  // namespace ink::import
