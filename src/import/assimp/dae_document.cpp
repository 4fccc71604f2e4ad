#include "import/assimp/dae_document.h"

#include <algorithm>

#include "core/error.h"
#include "import/meshes/line_words.h"
#include "import/refusal.h"
#include "import/xml.h"

namespace ink::import {

using Element = pugi::xml_node;

namespace {

/// The geometry or controller that an element is part of.
Element thing_of(Element element) {
    while (element && element.name() != std::string_view("geometry") &&
           element.name() != std::string_view("controller"))
        element = element.parent();
    return element;
}

}  // namespace

std::string named(const Element& element) {
    std::string text = std::string("<") + element.name();
    for (const char* key : {"id", "sid", "url", "source", "semantic"}) {
        const pugi::xml_attribute attribute = element.attribute(key);
        if (!attribute) continue;
        return text + ' ' + key + "=" + in_quotes(attribute.value()) + '>';
    }
    return text + '>';
}

void DaeDocument::number_ids() {
    by_id_.clear();
    for (Element at = root_; at; at = next_below(root_, at)) {
        const std::string id = at.attribute("id").value();
        if (!id.empty()) by_id_.emplace(id, at);
    }
}

Element DaeDocument::find(std::string_view kind, std::string_view id) const {
    const auto [first, last] = by_id_.equal_range(id);
    const auto found =
        std::find_if(first, last, [&](const auto& entry) { return entry.second.name() == kind; });
    return found == last ? Element() : found->second;
}

Element DaeDocument::target(const Element& from,
                            const char* attribute,
                            const std::vector<std::string_view>& kinds) const {
    const std::string_view url = from.attribute(attribute).value();
    if (!url.empty() && !url.starts_with('#')) {
        throw Refusal("",
                      named(from) + " is in another file, which is not read",
                      "a document that is whole in one file");
    }
    const std::string_view id = url.substr(url.empty() ? 0 : 1);
    std::vector<Element> found;
    const auto [first, last] = by_id_.equal_range(id);
    for (auto entry = first; entry != last; ++entry)
        if (std::find(kinds.begin(), kinds.end(), entry->second.name()) != kinds.end())
            found.push_back(entry->second);
    if (found.size() == 1) return found.front();
    // Some writers give the sources of each geometry the same ids.
    const Element thing = thing_of(from);
    for (const Element& element : found)
        if (thing && element != thing && thing_of(element) == thing) return element;
    if (found.size() > 1)
        throw core::Error("", named(from) + " names several elements", "ids of their own");
    throw core::Error("",
                      named(from) + " names what the file does not hold",
                      "the id of a <" + std::string(kinds.front()) + '>');
}

std::string DaeDocument::new_id(std::string wanted) const {
    while (by_id_.contains(wanted))
        wanted += '_';
    return wanted;
}

void write_vectors(const std::vector<double>& numbers, Element source) {
    const std::string id = source.attribute("id").value();
    while (source.first_child())
        source.remove_child(source.first_child());
    std::string text;
    for (const double number : numbers) {
        char word[32];
        text.append(word,
                    static_cast<std::size_t>(std::snprintf(word, sizeof word, "%.9g ", number)));
    }
    Element array = source.append_child("float_array");
    array.append_attribute("id").set_value((id + "-array").c_str());
    array.append_attribute("count").set_value(static_cast<unsigned long long>(numbers.size()));
    array.text().set(text.c_str());
    Element accessor = source.append_child("technique_common").append_child("accessor");
    accessor.append_attribute("source").set_value(('#' + id + "-array").c_str());
    accessor.append_attribute("count").set_value(
        static_cast<unsigned long long>(numbers.size() / 3));
    accessor.append_attribute("stride").set_value(3);
    for (const char* axis : {"X", "Y", "Z"}) {
        Element parameter = accessor.append_child("param");
        parameter.append_attribute("name").set_value(axis);
        parameter.append_attribute("type").set_value("float");
    }
}

std::vector<double> read_vectors(const DaeDocument& dae, const Element& source) {
    const Element accessor = source.child("technique_common").child("accessor");
    const std::string where = named(source);
    if (!accessor) throw core::Error("", where + " has no accessor", "technique_common");
    const std::vector<double> all =
        numbers_of(dae.target(accessor, "source", {"float_array"}).text().get(), where);
    const std::size_t count = accessor.attribute("count").as_ullong();
    const std::size_t stride = accessor.attribute("stride").as_ullong(1);
    const std::size_t offset = accessor.attribute("offset").as_ullong();
    std::vector<std::size_t> places;  // a parameter without a name is passed over
    std::size_t place = 0;
    for (const Element& parameter : accessor.children("param")) {
        if (*parameter.attribute("name").value() != '\0') places.push_back(place);
        ++place;
    }
    const std::size_t last = places.empty() ? stride : places.back();
    if (last >= stride || (count > 0 && (offset > all.size() || count > all.size() ||
                                         offset + (count - 1) * stride + last >= all.size())))
        throw core::Error("", where + ": its accessor reads beyond its numbers", "fewer rows");
    std::vector<double> vectors;
    vectors.reserve(3 * count);
    for (std::size_t row = 0; row < count; ++row)
        for (const std::size_t column : places)
            vectors.push_back(all[offset + row * stride + column]);
    return vectors;
}

}  // namespace ink::import
