#include "core/provenance.h"

#include <fmt/core.h>
#include <tbb/version.h>

#include <fstream>
#include <glm/glm.hpp>

#include "core/build_info.h"
#include "core/simd.h"

namespace ink::core {
namespace {

std::string cpu_model() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    for (std::string line; std::getline(cpuinfo, line);) {
        if (line.rfind("model name", 0) == 0) {
            const auto colon = line.find(": ");
            if (colon != std::string::npos) return line.substr(colon + 2);
        }
    }
    return "unknown";
}

Provenance collect() {
    Provenance p;
    p.version = build_info::kVersion;
    p.commit = build_info::kCommit;
    p.dirty = build_info::kDirty;
    p.compiler = build_info::kCompiler;
    p.flags = build_info::kFlags;
    p.cpu = cpu_model();
    p.simd = current_simd_target().name;
    p.libraries = {
        {"embree", build_info::kEmbree},
        {"openimageio", build_info::kOpenImageIO},
        {"onetbb", TBB_runtime_version()},
        {"highway", highway_version()},
        {"fmt",
         fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"glm",
         fmt::format("{}.{}.{}.{}",
                     GLM_VERSION_MAJOR,
                     GLM_VERSION_MINOR,
                     GLM_VERSION_PATCH,
                     GLM_VERSION_REVISION)},
    };
    return p;
}

}  // namespace

const Provenance& provenance() {
    static const Provenance kProvenance = collect();
    return kProvenance;
}

}  // namespace ink::core
