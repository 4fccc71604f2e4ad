#include "methods/tuned.h"

#include <string>

#include "methods/presets.h"
#include "methods/shipped_presets.h"

namespace ink::methods {

std::span<const ShippedPreset> shipped_presets() {
    return kShippedPresets;
}

std::vector<method::MethodInfo> tuned_methods(const std::vector<method::MethodInfo>& bases) {
    std::vector<method::MethodInfo> methods;
    for (const ShippedPreset& shipped : shipped_presets()) {
        const std::string name(shipped.name);
        const std::string where = "methods/" + name + "/" + name + ".toml";
        methods.push_back(preset_method(parse_preset(shipped.text, where, bases), bases));
    }
    return methods;
}

}  // namespace ink::methods
