#include "methods/preset.h"

#include <fmt/format.h>

namespace ink::methods {

std::string toml_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

std::string preset_toml(const PresetFile& preset) {
    std::string text = fmt::format("name = {}\nmethod = {}\n\n[settings]\n",
                                   toml_text(preset.name),
                                   toml_text(preset.method->name));
    for (const core::Param& param : preset.method->params) {
        const auto found = preset.settings.find(param.name);
        if (found == preset.settings.end()) continue;
        const bool is_choice = param.kind == core::ParamKind::choice;
        text += fmt::format(
            "{} = {}\n", param.name, is_choice ? toml_text(found->second) : found->second);
    }
    text += "\n[provenance]\n";
    for (const auto& [key, value] : preset.provenance)
        text += fmt::format("{} = {}\n", key, value);
    return text;
}

}  // namespace ink::methods
