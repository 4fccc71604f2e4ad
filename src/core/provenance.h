#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ink::core {

/// Where a result comes from: everything that could change it, besides its row's own columns.
struct Provenance {
    std::string version;   ///< of the project, "0.1.0"
    std::string commit;    ///< short hash, or "unknown" outside a git checkout
    bool dirty = false;    ///< the work tree differed from `commit` when it was built
    std::string compiler;  ///< "GNU 12.2.0"
    std::string flags;     ///< build type and flags
    std::string cpu;       ///< model name
    std::string simd;      ///< the instruction set that the kernels run on ("scalar" for now)
    std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version
};

/// The provenance of this very build on this very machine; computed once.
[[nodiscard]] const Provenance& provenance();

}  // namespace ink::core
