// Skins of COLLADA: whether Assimp finds the joints that are meant.

#include <map>
#include <string>

#include "core/error.h"
#include "import/assimp/dae_document.h"
#include "import/meshes/line_words.h"
#include "import/refusal.h"
#include "import/xml.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;

/// The first node of each value of an attribute.
class Nodes {
  public:
    void add(const Element& top) {
        for (const Element& node : elements(top, "node"))
            add_one(node);
    }
    void add_one(const Element& node) {
        for (const char* key : {"id", "sid", "name"})
            if (const auto attribute = node.attribute(key))
                nodes_.try_emplace({key, attribute.value()}, node);
    }
    [[nodiscard]] Element find(const char* key, const std::string& value) const {
        const auto found = nodes_.find({key, value});
        return found == nodes_.end() ? Element() : found->second;
    }

  private:
    std::map<std::pair<std::string, std::string>, Element> nodes_;
};

/// Assimp's choice: the first in the scene with that name or id, else that sid.
Element found_by_assimp(const Element& scene, const Nodes& nodes, const std::string& joint) {
    const Element by_id = nodes.find("id", joint), by_name = nodes.find("name", joint);
    if (by_id && by_name && by_id != by_name)
        for (const Element& node : elements(scene, "node"))
            if (node == by_id || node == by_name) return node;
    if (by_id || by_name) return by_id ? by_id : by_name;
    return nodes.find("sid", joint);
}

/// The joint's node: sids are looked for below the skeletons that a use of the skin names.
Element joint_of(const Nodes& skeletons, const Nodes& nodes, const std::string& joint) {
    for (const Nodes* where : {&skeletons, &nodes})
        for (const char* key : {"sid", "id"})
            if (const Element node = where->find(key, joint)) return node;
    return {};
}

Element joints_of(const DaeDocument& dae, const Element& skin) {
    for (const Element& input : skin.child("joints").children("input"))
        if (std::string_view(input.attribute("semantic").value()) == "JOINT")
            return dae.target(input, "source", {"source"});
    throw core::Error("", named(skin) + " has no joints", "<joints> with an input JOINT");
}

Nodes skeletons_of(const DaeDocument& dae, const Element& use) {
    Nodes nodes;
    for (const Element& skeleton : use.children("skeleton")) {
        const std::string_view url = skeleton.text().get();
        const Element root = dae.find("node", url.substr(url.starts_with('#') ? 1 : 0));
        if (!root) continue;
        nodes.add_one(root);
        nodes.add(root);
    }
    return nodes;
}

void check_use(const DaeDocument& dae, const Element& use, const Element& scene, const Nodes& all) {
    const Element controller = dae.target(use, "url", {"controller"});
    const Element skin = controller.child("skin");
    if (!skin) throw core::Error("", named(controller) + " is no skin", "<skin> or <morph>");
    (void)dae.target(skin, "source", {"geometry"});
    if (std::string_view(skin.child("vertex_weights").child("v").text().get()).find('-') !=
        std::string_view::npos) {
        throw Refusal("",
                      named(skin) + " has vertices that follow no joint (-1), which is not read",
                      "joints");
    }
    const Nodes skeletons = skeletons_of(dae, use);
    const Element source = joints_of(dae, skin);
    for (const char* array : {"Name_array", "IDREF_array", "SIDREF_array"})
        for (const std::string_view word : words_of(source.child(array).text().get())) {
            const std::string joint(word);
            const Element meant = joint_of(skeletons, all, joint);
            const Element found = found_by_assimp(scene, all, joint);
            if (!found) {
                throw core::Error(
                    "",
                    named(skin) + ": its joint " + in_quotes(joint) + " is no node of the scene",
                    "the sid of a <node>");
            }
            if (meant && meant != found) {
                throw Refusal("",
                              named(skin) + ": several nodes are called " + in_quotes(joint) +
                                  " as its joint is, which is not read",
                              "joints of names of their own");
            }
        }
}

}  // namespace

void check_skins(const DaeDocument& dae) {
    const Element shown = dae.root().child("scene").child("instance_visual_scene");
    if (!shown) return;
    const Element scene = dae.target(shown, "url", {"visual_scene"});
    Nodes all;
    all.add(scene);
    for (const Element& use : elements(dae.root(), "instance_controller"))
        check_use(dae, use, scene, all);
}

}  // namespace ink::import
