#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace ink::cli {

/// Instructions of a method's shader for families of GPUs, as bench/gpu_cost counted them (straight
/// code, a loop's body once): "277/5/35 instructions of vertex/fragment/pixel on RDNA2, ...". A
/// vertex and a fragment are of the mesh, a pixel is of all passes over the screen. "" for a method
/// without a shader.
[[nodiscard]] std::string shader_text(std::string_view method);

/// The same by family: {"RDNA2": {"vertex": 277, "fragment": 5, "pixel": 35}, ...}; null for a
/// method without a shader.
[[nodiscard]] nlohmann::ordered_json shader_json(std::string_view method);

}  // namespace ink::cli
