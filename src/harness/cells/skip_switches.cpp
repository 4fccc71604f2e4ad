#include "harness/cells/skip_switches.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/named.h"
#include "core/param.h"

namespace ink::harness {

raster::SkipSet skips_of_repeated_drawings() {
    return raster::SkipSet().set(raster::Skip::temporal_reuse, false);
}

raster::SkipSet without_skips(raster::SkipSet allowed, const std::vector<std::string>& names) {
    const auto& infos = raster::skip_infos();
    for (const std::string& name : names) {
        if (name == "all") {
            allowed = raster::SkipSet::none();
            continue;
        }
        const raster::SkipInfo* found = core::find_named(infos, name);
        if (found == nullptr) {
            std::vector<std::string> known = core::names_of(infos);
            known.emplace_back("all");
            throw core::Error("--no-skip",
                              fmt::format("there is no skip '{}'", name),
                              core::known_names(known, name));
        }
        allowed.set(found->skip, false);
    }
    return allowed;
}

std::string forbidden_skips(const raster::SkipSet& allowed) {
    std::string text;
    for (const raster::SkipInfo& info : raster::skip_infos()) {
        if (allowed.has(info.skip)) continue;
        if (!text.empty()) text += ';';
        text += info.name;
    }
    return text;
}

}  // namespace ink::harness
