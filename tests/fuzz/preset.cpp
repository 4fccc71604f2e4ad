// Any text is a preset whose method can be made, or an Error.

#include "methods/presets.h"
#include "methods/registry.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

using methods::Preset;

bool is_same(const Preset& a, const Preset& b) {
    return a.name == b.name && a.method == b.method && a.settings == b.settings &&
           a.command == b.command;
}

Preset written_and_read(const Preset& preset) {
    const method::MethodInfo& base = methods::find_method(preset.method);
    std::vector<std::pair<std::string, std::string>> provenance;
    if (!preset.command.empty())
        provenance.emplace_back("command", methods::toml_text(preset.command));
    const std::string text =
        methods::preset_toml({preset.name, &base, preset.settings, provenance});
    return methods::parse_preset(text, "again.toml", methods::registry());
}

}  // namespace

void check_preset(Bytes bytes) {
    const std::string text(bytes.begin(), bytes.end());
    const auto read = unless_refused(
        [&] { return methods::parse_preset(text, "fuzz.toml", methods::registry()); });
    if (!read) return;
    const Preset& preset = *read;
    expect_usable("a preset that was taken can be used", [&] {
        expect(is_same(written_and_read(preset), preset), "a preset is read as it was written");
        const method::MethodInfo info = methods::preset_method(preset, methods::registry());
        expect(info.make({}) != nullptr, "the method of a preset can be made");
        const core::ParamValues complete = info.complete({});
        for (const auto& [name, value] : preset.settings)
            expect(complete.at(name) == value, "the settings of a preset are its defaults");
        for (const core::ParamValues& line : info.sweep)
            expect(info.make(line) != nullptr, "so can each of its sweep");
    });
}

}  // namespace ink::fuzz
