// Morph controllers of COLLADA, at their weights in the file.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "import/assimp/dae_document.h"
#include "import/meshes/line_words.h"
#include "import/refusal.h"
#include "import/xml.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;
using Vectors = std::vector<double>;

/// The sources of a geometry's inputs of a kind, each once, in the file's order.
std::vector<Element> sources_of(const DaeDocument& dae, Element geometry, std::string_view kind) {
    std::vector<Element> sources;
    for (const Element& input : elements(geometry, "input")) {
        if (input.attribute("semantic").value() != kind) continue;
        const Element source = dae.target(input, "source", {"source"});
        if (std::ranges::find(sources, source) == sources.end()) sources.push_back(source);
    }
    return sources;
}

/// The source of a morph's <targets>.
Element target_source(const DaeDocument& dae, const Element& morph, std::string_view kind) {
    for (const Element& input : morph.child("targets").children("input"))
        if (input.attribute("semantic").value() == kind)
            return dae.target(input, "source", {"source"});
    throw core::Error("",
                      named(morph.parent()) + " has no input " + std::string(kind),
                      "<targets> with MORPH_TARGET and MORPH_WEIGHT");
}

/// A geometry and how much of it a morph has.
struct Share {
    Element geometry;
    double weight;
};

/// The base first, with what the targets leave of it.
std::vector<Share> shares_of(const DaeDocument& dae, const Element& morph) {
    const std::string where = named(morph.parent());
    const std::string method = morph.attribute("method").value();
    if (!method.empty() && method != "NORMALIZED" && method != "RELATIVE")
        throw Refusal("", where + ": method " + in_quotes(method), "NORMALIZED or RELATIVE");
    const Element names = target_source(dae, morph, "MORPH_TARGET");
    const Element weights = target_source(dae, morph, "MORPH_WEIGHT");
    const Element array =
        names.child("IDREF_array") ? names.child("IDREF_array") : names.child("Name_array");
    const std::vector<std::string_view> targets = words_of(array.text().get());
    const std::vector<double> numbers =
        numbers_of(weights.child("float_array").text().get(), where);
    if (numbers.size() != targets.size()) {
        throw core::Error("",
                          where + " has " + std::to_string(targets.size()) + " targets and " +
                              std::to_string(numbers.size()) + " weights",
                          "as many");
    }
    std::vector<Share> shares{{dae.target(morph, "source", {"geometry"}), 1}};
    for (std::size_t t = 0; t < targets.size(); ++t) {
        const Element target = dae.find("geometry", targets[t]);
        if (!target) {
            throw core::Error("",
                              where + ": no geometry has the id " + in_quotes(targets[t]),
                              "ids of geometries");
        }
        shares.push_back({target, numbers[t]});
        if (method != "RELATIVE") shares.front().weight -= numbers[t];
    }
    return shares;
}

/// The weighted sum of source `number` of a kind; nothing where the shares' sources differ.
Vectors blended(const DaeDocument& dae,
                const std::vector<Share>& shares,
                std::string_view kind,
                std::size_t number) {
    Vectors sum;
    for (const Share& share : shares) {
        const std::vector<Element> sources = sources_of(dae, share.geometry, kind);
        if (number >= sources.size()) return {};
        const Vectors vectors = read_vectors(dae, sources[number]);
        if (sum.empty()) sum.resize(vectors.size());
        if (vectors.size() != sum.size()) return {};
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += share.weight * vectors[i];
    }
    return sum;
}

/// A copy of a geometry whose ids and references to these are its own.
Element copy_of(DaeDocument& dae, Element geometry, const std::string& id) {
    Element copy = geometry.parent().append_copy(geometry);
    std::map<std::string, std::string> renamed;
    for (const char* kind : {"source", "float_array", "Name_array", "vertices"})
        for (Element element : elements(copy, kind)) {
            const std::string old = element.attribute("id").value();
            if (old.empty()) continue;
            const std::string now = dae.new_id(id + '-' + old);
            renamed['#' + old] = '#' + now;
            element.attribute("id").set_value(now.c_str());
        }
    for (const char* kind : {"input", "accessor"})
        for (Element element : elements(copy, kind)) {
            const auto now = renamed.find(element.attribute("source").value());
            if (now != renamed.end()) element.attribute("source").set_value(now->second.c_str());
        }
    copy.attribute("id").set_value(id.c_str());
    dae.number_ids();
    return copy;
}

void drop_inputs(Element geometry, std::string_view kind) {
    for (Element input : elements(geometry, "input"))
        if (input.attribute("semantic").value() == kind) input.parent().remove_child(input);
}

/// The id of a new geometry that is a morph's shape.
std::string bake(DaeDocument& dae, const Element& morph) {
    const Element controller = morph.parent();
    const std::vector<Share> shares = shares_of(dae, morph);
    const std::size_t parts = sources_of(dae, shares.front().geometry, "POSITION").size();
    const Vectors positions = blended(dae, shares, "POSITION", 0);
    if (parts != 1 || positions.empty()) {
        throw core::Error("",
                          named(controller) + ": its targets do not have the vertices of its base",
                          "geometries with as many positions");
    }
    std::vector<Vectors> normals;
    const std::size_t kinds_of_normals = sources_of(dae, shares.front().geometry, "NORMAL").size();
    for (std::size_t n = 0; n < kinds_of_normals; ++n)
        normals.push_back(blended(dae, shares, "NORMAL", n));
    const std::string id = dae.new_id(std::string(controller.attribute("id").value()) + "-at-rest");
    const Element copy = copy_of(dae, shares.front().geometry, id);
    write_vectors(positions, sources_of(dae, copy, "POSITION").front());
    const std::vector<Element> own = sources_of(dae, copy, "NORMAL");
    const bool is_each_blended =
        std::ranges::none_of(normals, [](const Vectors& vectors) { return vectors.empty(); });
    if (!is_each_blended) drop_inputs(copy, "NORMAL");
    for (std::size_t n = 0; n < own.size() && is_each_blended; ++n)
        write_vectors(normals[n], own[n]);
    dae.number_ids();
    return id;
}

}  // namespace

void bake_morphs(DaeDocument& dae) {
    std::set<std::string> used;
    for (const Element& use : elements(dae.root(), "instance_controller"))
        used.insert(use.attribute("url").value());
    for (const Element& skin : elements(dae.root(), "skin"))
        used.insert(skin.attribute("source").value());
    std::map<std::string, std::string> baked;  // by the controller's reference
    for (const Element& morph : elements(dae.root(), "morph")) {
        const std::string controller = '#' + std::string(morph.parent().attribute("id").value());
        if (used.contains(controller)) baked[controller] = '#' + bake(dae, morph);
    }
    for (Element use : elements(dae.root(), "instance_controller")) {
        const auto found = baked.find(use.attribute("url").value());
        if (found == baked.end()) continue;
        use.set_name("instance_geometry");
        use.attribute("url").set_value(found->second.c_str());
    }
    for (Element skin : elements(dae.root(), "skin")) {
        const auto found = baked.find(skin.attribute("source").value());
        if (found != baked.end()) skin.attribute("source").set_value(found->second.c_str());
    }
    for (Element morph : elements(dae.root(), "morph"))
        morph.parent().parent().remove_child(morph.parent());
    dae.number_ids();
}

}  // namespace ink::import
