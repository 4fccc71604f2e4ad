#include "import/fbx/document.h"

#include "import/model_bytes.h"

namespace ink::import {
namespace {

constexpr std::size_t kFirstValue = 4;        // of a property: before it its name, types and flags
constexpr std::int64_t kFirstVersion = 7100;  // before it objects had names in place of numbers

/// "Model::name" of text, "name\0\1Model" of binary files.
std::string plain_name(const std::string& name) {
    const std::size_t end = name.find('\0');
    if (end != name.npos) return name.substr(0, end);
    const std::size_t prefix = name.find("::");
    return prefix == name.npos ? name : name.substr(prefix + 2);
}

const FbxElement* property(const FbxElement* list, std::string_view name) {
    if (list == nullptr) return nullptr;
    for (const FbxElement& element : list->children)
        if (element.text(0) == name && element.values.size() > kFirstValue) return &element;
    return nullptr;
}

void check_version(const FbxElement& root) {
    const FbxElement* header = root.child("FBXHeaderExtension");
    const FbxElement* version = header == nullptr ? nullptr : header->child("FBXVersion");
    for (const char* part : {"Objects", "Connections"})
        if (version == nullptr || root.child(part) == nullptr ||
            root.child(part)->children.empty()) {
            throw core::Error(
                "",
                version == nullptr ? "it has no FBXVersion" : std::string("it has no ") + part,
                "a whole, valid FBX file");
        }
    if (version->whole(0) >= kFirstVersion) return;
    throw Refusal(
        "",
        "is an FBX file of version " + std::to_string(version->whole(0)) + ", which is not read",
        "version 7100 (FBX 2011) or a later one");
}

}  // namespace

const FbxElement* FbxProperties::find(std::string_view name) const {
    const FbxElement* found = property(own, name);
    return found == nullptr ? property(standard, name) : found;
}

double FbxProperties::real(std::string_view name, double otherwise) const {
    const FbxElement* found = find(name);
    return found == nullptr ? otherwise : found->real(kFirstValue);
}

int FbxProperties::whole(std::string_view name, int otherwise) const {
    const FbxElement* found = find(name);
    return found == nullptr ? otherwise : static_cast<int>(found->whole(kFirstValue));
}

glm::dvec3 FbxProperties::vector(std::string_view name, const glm::dvec3& otherwise) const {
    const FbxElement* found = find(name);
    if (found == nullptr || found->values.size() < kFirstValue + 3) return otherwise;
    return {found->real(kFirstValue), found->real(kFirstValue + 1), found->real(kFirstValue + 2)};
}

FbxDocument::FbxDocument(std::string_view file) : root_(read_fbx_tree(file)) {
    check_version(root_);
    if (const FbxElement* settings = root_.child("GlobalSettings"))
        settings_.own = settings->child("Properties70");
    read_objects();
    read_connections();
}

void FbxDocument::read_objects() {
    objects_[0];
    for (const FbxElement& element : root_.child("Objects")->children) {
        const std::int64_t number = element.whole(0);
        if (number == 0) continue;
        FbxObject& object = objects_[number];
        object.number = number;
        object.name = plain_name(element.text(1));
        object.kind = element.text(2);
        object.element = &element;
        object.properties = {element.child("Properties70"), standard_of(element)};
    }
}

/// Where a kind has several lists, such as those of cameras and of lights, the name tells them
/// apart: "FbxCamera".
const FbxElement* FbxDocument::standard_of(const FbxElement& object) const {
    const FbxElement* definitions = root_.child("Definitions");
    if (definitions == nullptr) return nullptr;
    const FbxElement* first = nullptr;
    for (const FbxElement& type : definitions->children) {
        if (type.name != "ObjectType" || type.text(0) != object.name) continue;
        for (const FbxElement& list : type.children) {
            if (list.name != "PropertyTemplate") continue;
            if (list.text(0) == "Fbx" + object.text(2)) return list.child("Properties70");
            if (first == nullptr) first = list.child("Properties70");
        }
    }
    return first;
}

void FbxDocument::read_connections() {
    for (const FbxElement& link : root_.child("Connections")->children) {
        if (link.text(0) != "OO") continue;  // others lead to a property
        const auto child = objects_.find(link.whole(1));
        const auto parent = objects_.find(link.whole(2));
        if (child == objects_.end() || parent == objects_.end() || child->first == 0) continue;
        parent->second.children.push_back(&child->second);
    }
}

std::vector<const FbxObject*> FbxDocument::all(std::string_view element) const {
    std::vector<const FbxObject*> found;
    for (const auto& [number, object] : objects_)
        if (object.element != nullptr && object.element->name == element) found.push_back(&object);
    return found;
}

std::vector<const FbxObject*> children_of(const FbxObject& object,
                                          std::string_view element,
                                          std::string_view kind) {
    std::vector<const FbxObject*> found;
    for (const FbxObject* child : object.children)
        if (child->element->name == element && (kind.empty() || child->kind == kind))
            found.push_back(child);
    return found;
}

}  // namespace ink::import
