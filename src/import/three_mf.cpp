#include "import/three_mf.h"

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/meshes/polygons.h"
#include "import/model_bytes.h"
#include "import/refusal.h"
#include "import/three_mf_part.h"
#include "import/xml.h"
#include "import/zip_archive.h"

namespace ink::import {
namespace {

using Element = pugi::xml_node;

constexpr std::size_t kMostPlaces = 1'000'000;  ///< of objects, those that hold components too

/// An object where it stands.
struct Place {
    const ThreeMfPart* part = nullptr;
    Element object;
    glm::dmat4 world_from_object{1};
    std::string name;        ///< its own, else that of what it is a component of
    std::size_t holder = 0;  ///< the number of that
};

class Package {
  public:
    explicit Package(const PackageParts& texts) : texts_(texts) {}

    ImportReply read(const std::string& root) {
        const ThreeMfPart& model = part(root);
        unit_m_ = model.unit_m();
        for (const Element& item : model.build().children()) {
            if (!model.is(item, "item")) continue;
            const Place place = used(model, item, {});
            if (std::string_view(place.object.attribute("type").value()) == "other")
                ++left_out_["build item of type \"other\""];
            else
                place_all(place);
        }
        add_notes();
        reply_.base_colors = materials_.colors();
        return std::move(reply_);
    }

  private:
    const ThreeMfPart& part(const std::string& name) {
        std::unique_ptr<ThreeMfPart>& known = parts_[lower_case(name)];
        if (!known) {
            known = std::make_unique<ThreeMfPart>(name, texts_(name));
            for (const std::string& extension : known->recommended())
                ++left_out_["recommended extension " + extension];
        }
        return *known;
    }

    /// What an <item> or <component> of `in` places, in the holder that it belongs to.
    Place used(const ThreeMfPart& in, const Element& use, const Place& holder) {
        const std::string id = use.attribute("objectid").value();
        const std::string where =
            "a " + std::string(local_name(use)) + " in " + in_quotes(in.name());
        std::string path = attribute_of(use, "path");
        path.erase(0, path.find_first_not_of('/'));
        Place place;
        place.part = path.empty() ? &in : &part(path);
        place.object = place.part->object(id, where);
        // A transform is in the unit of the part that it stands in.
        const double to_own = in.unit_m() / unit_m_;
        glm::dmat4 transform = transform_of(use, where);
        transform[3] *= glm::dvec4(to_own, to_own, to_own, 1);
        place.world_from_object = holder.world_from_object * transform;
        place.name = place.object.attribute("name").value();
        if (place.name.empty()) place.name = holder.name;
        return place;
    }

    // No recursion: a hostile tree is deep.
    void place_all(const Place& first) {
        std::vector<Place> holders;
        std::vector<Place> open{first};
        open.back().holder = kNoHolder;
        while (!open.empty()) {
            Place place = std::move(open.back());
            open.pop_back();
            if (++places_ > kMostPlaces) {
                throw core::Error(
                    "", "its components are too many", std::to_string(kMostPlaces) + " at most");
            }
            check_holders(place, holders);
            const std::string type = place.object.attribute("type").value();
            if (type == "support" || type == "solidsupport") {
                ++left_out_["object of type \"" + type + '"'];
                continue;
            }
            note_extensions(place);
            const Element components = place.part->child(place.object, "components");
            if (!components) {
                add_instance(place);
                continue;
            }
            std::vector<Place> inner;
            for (const Element& component : components.children()) {
                if (!place.part->is(component, "component")) continue;
                inner.push_back(used(*place.part, component, place));
                inner.back().holder = holders.size();
            }
            holders.push_back(std::move(place));
            open.insert(open.end(), inner.rbegin(), inner.rend());
        }
    }

    static void check_holders(const Place& place, const std::vector<Place>& holders) {
        for (std::size_t h = place.holder; h != kNoHolder; h = holders[h].holder)
            if (holders[h].object == place.object)
                throw core::Error(
                    "", place.part->named(place.object) + " is a component of itself", "a tree");
    }

    /// Shapes beside or in a mesh that are no part of the core specification.
    void note_extensions(const Place& place) {
        if (!noted_.insert(place.object.internal_object()).second) return;
        if (!attribute_of(place.object, "slicestackid").empty()) ++left_out_["stack of slices"];
        for (const Element& parent : {place.object, place.part->child(place.object, "mesh")})
            for (const Element& element : parent.children()) {
                const bool is_known = std::ranges::count(kKnown, local_name(element)) > 0;
                if (!is_known) ++left_out_['<' + std::string(element.name()) + '>'];
            }
    }

    void add_instance(const Place& place) {
        if (!place.part->child(place.object, "mesh")) {
            const Element other = place.object.first_child();
            throw Refusal("",
                          place.part->named(place.object) +
                              (other ? " is <" + std::string(other.name()) + ">" : " is empty") +
                              ", which is not read",
                          "a mesh or components");
        }
        const auto [known, is_new] = mesh_of_.try_emplace(
            place.object.internal_object(), static_cast<std::uint32_t>(reply_.meshes.size()));
        std::string name = place.name;
        if (name.empty()) name = std::string("Object_") + place.object.attribute("id").value();
        if (is_new) {
            reply_.meshes.push_back(read_3mf_mesh(*place.part, place.object, materials_));
            reply_.meshes.back().name = name;
        }
        const double own = place.part->unit_m() / unit_m_;
        reply_.instances.push_back(
            {known->second, glm::scale(place.world_from_object, glm::dvec3(own)), name});
    }

    void add_notes() {
        for (const auto& [what, count] : left_out_)
            reply_.notes.push_back(counted(count, what) + ": left out");
        const auto clear = std::ranges::count_if(
            materials_.colors(), [](const glm::vec4& color) { return color.a < 1; });
        if (clear > 0) reply_.notes.push_back(drawn_opaque(static_cast<std::size_t>(clear)));
    }

    static constexpr std::size_t kNoHolder = static_cast<std::size_t>(-1);
    static constexpr std::array<const char*, 7> kKnown{
        "mesh", "components", "metadatagroup", "vertices", "triangles", "trianglesets", "metadata"};

    const PackageParts& texts_;
    std::map<std::string, std::unique_ptr<ThreeMfPart>> parts_;
    ThreeMfMaterials materials_;
    std::map<const void*, std::uint32_t> mesh_of_;
    std::set<const void*> noted_;
    std::map<std::string, std::size_t> left_out_;
    std::size_t places_ = 0;
    double unit_m_ = 1e-3;
    ImportReply reply_;
};

/// The package's model, by its list of relations. Throws Refusal if it says that it is encrypted.
std::string root_of(const PackageParts& parts, const ZipArchive& archive) {
    const std::string list = archive.find("_rels/.rels");
    if (list.empty())
        throw core::Error("", "it has no file \"_rels/.rels\", as 3MF has", "a 3MF package");
    pugi::xml_document document;
    load_xml(parts(list), list, document);
    std::string root;
    for (const Element& relation : document.document_element().children()) {
        const std::string_view type = relation.attribute("Type").value();
        if (type.ends_with("/keystore"))
            throw Refusal("", "its content is encrypted (3MF Secure Content)", "plain 3MF");
        if (!type.ends_with("/3dmodel") || !root.empty()) continue;
        root = relation.attribute("Target").value();
        root.erase(0, root.find_first_not_of('/'));
    }
    if (root.empty()) throw core::Error("", "it is a package without a 3D model", "a 3MF package");
    return root;
}

}  // namespace

ImportReply read_3mf_model(const PackageParts& parts, const std::string& root) {
    return Package(parts).read(root);
}

ImportReply read_3mf(const std::filesystem::path& path) {
    const ZipArchive archive(path);
    const PackageParts parts = [&](const std::string& name) {
        const std::string spelled = archive.find(name);
        return archive.read(spelled.empty() ? name : spelled);
    };
    return read_3mf_model(parts, root_of(parts, archive));
}

}  // namespace ink::import
