#include "experiment/options/model_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/toml_reader.h"
#include "core/whole_file.h"

namespace ink::experiment {
namespace {

constexpr const char* kNeeded = "file, kind";

void add_models(core::TomlReader& table, std::vector<harness::ListedModel>& models) {
    for (core::TomlReader& entry : table.tables("model")) {
        harness::ListedModel model{entry.needed_text("file", kNeeded),
                                   entry.needed_text("kind", kNeeded)};
        const std::string split = entry.text("split").value_or("real");
        if (split != "real" && split != "train") {
            throw core::Error(
                entry.where("split"), fmt::format("there is no split '{}'", split), "train, real");
        }
        if (split == "train") model.split = scene::Split::train;
        if (std::ranges::count(models, model.file, &harness::ListedModel::file) > 0) {
            throw core::Error(entry.where("file"),
                              fmt::format("'{}' is listed twice", model.file),
                              "each file once");
        }
        models.push_back(std::move(model));
    }
}

}  // namespace

std::vector<harness::ListedModel> read_model_list(const std::filesystem::path& path) {
    const auto text = core::read_whole_file(path);
    if (!text) {
        throw core::Error(
            path.string(), "it cannot be read", "a list of models (see experiments/models.toml)");
    }
    core::TomlReader file(*text, path);
    std::vector<harness::ListedModel> models;
    add_models(file, models);
    for (core::TomlReader& package : file.tables("package"))
        add_models(package, models);
    if (models.empty()) {
        throw core::Error(path.string(), "it lists no model", "[[model]] tables with file, kind");
    }
    return models;
}

}  // namespace ink::experiment
