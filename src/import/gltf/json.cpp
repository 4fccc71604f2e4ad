#include "import/gltf/json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include <string_view>

#include "core/error.h"
#include "import/model_bytes.h"

namespace ink::import {
namespace {

using Json = nlohmann::json;

constexpr int kMostDepth = 64;
constexpr std::size_t kMostValueChars = 40;

/// A value as a message shows it.
std::string shown(const Json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "a list of " + std::to_string(value.size());
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= kMostValueChars ? text : text.substr(0, kMostValueChars) + "...";
}

std::string up_to(std::uint64_t most) {
    return "a whole number, 0.." + std::to_string(most);
}

/// How many lists and objects stand in each other, at most. Asked before the JSON is parsed: with a
/// callback, the parser looks at all members of a list again at the end of each.
int depth_of(std::string_view json) {
    int depth = 0, most = 0;
    bool is_in_text = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (is_in_text && c == '\\') ++i;
        if (c == '"') is_in_text = !is_in_text;
        if (is_in_text) continue;
        if (c == '[' || c == '{') most = std::max(most, ++depth);
        if (c == ']' || c == '}') --depth;
    }
    return most;
}

}  // namespace

JsonObject::JsonObject(const Json& json, std::string place)
    : json_(&json), place_(std::move(place)) {
    if (!json.is_object()) fail(shown(json), "an object");
}

void JsonObject::fail(const std::string& what, const std::string& accepted) const {
    throw core::Error(place_, (place_.empty() ? "" : place_ + ": ") + what, accepted);
}

void JsonObject::refuse(const std::string& what, const std::string& accepted) const {
    throw Refusal(place_, (place_.empty() ? "" : place_ + ": ") + what, accepted);
}

void JsonObject::fail_at(const char* key, const Json& value, const std::string& accepted) const {
    fail(std::string(key) + " is " + shown(value), accepted);
}

const Json* JsonObject::value(const char* key) const {
    const auto found = json_->find(key);
    return found == json_->end() ? nullptr : &*found;
}

const Json& JsonObject::array(const char* key) const {
    static const Json kNone = Json::array();
    const Json* list = value(key);
    if (list == nullptr) return kNone;
    if (!list->is_array()) fail_at(key, *list, "a list");
    return *list;
}

const Json& JsonObject::needed(const char* key) const {
    const Json* found = value(key);
    if (found == nullptr) fail(std::string("it has no ") + key);
    return *found;
}

bool JsonObject::has(const char* key) const {
    return value(key) != nullptr;
}

bool JsonObject::is_same(const char* key, const JsonObject& other) const {
    const Json* mine = value(key);
    const Json* its = other.value(key);
    return mine == nullptr || its == nullptr ? mine == its : *mine == *its;
}

std::optional<JsonObject> JsonObject::find(const char* key) const {
    const Json* found = value(key);
    if (found == nullptr) return std::nullopt;
    return JsonObject(*found, place_.empty() ? key : place_ + ", " + key);
}

JsonObject JsonObject::at(const char* key) const {
    (void)needed(key);
    return *find(key);
}

std::optional<JsonObject> JsonObject::extension(const char* name) const {
    const auto all = find("extensions");
    if (!all || !all->has(name)) return std::nullopt;
    return JsonObject(*all->value(name), place_ + ", " + name);
}

std::vector<JsonObject> JsonObject::list(const char* key, const char* singular) const {
    std::vector<JsonObject> objects;
    for (const Json& one : array(key)) {
        const std::string name = std::string(singular) + ' ' + std::to_string(objects.size());
        objects.emplace_back(one, place_.empty() ? name : place_ + ", " + name);
    }
    return objects;
}

std::uint64_t JsonObject::whole_of(const Json& value, const char* key, std::uint64_t most) const {
    constexpr double kExact = 9007199254740992;  // up to here a double holds every whole number
    std::uint64_t whole = 0;
    if (value.is_number_unsigned()) {
        whole = value.get<std::uint64_t>();
    } else if (value.is_number_float()) {
        // Writers of other languages put 3.0 for 3.
        const double number = value.get<double>();
        if (!(number >= 0 && number <= kExact && number == std::floor(number)))
            fail_at(key, value, up_to(most));
        whole = static_cast<std::uint64_t>(number);
    } else {
        fail_at(key, value, up_to(most));
    }
    if (whole > most) fail_at(key, value, up_to(most));
    return whole;
}

std::uint64_t JsonObject::whole(const char* key, std::uint64_t most) const {
    return whole_of(needed(key), key, most);
}

std::uint64_t JsonObject::whole_or(const char* key,
                                   std::uint64_t most,
                                   std::uint64_t fallback) const {
    return has(key) ? whole(key, most) : fallback;
}

std::size_t JsonObject::index(const char* key, std::size_t size) const {
    const Json& found = needed(key);
    if (size == 0) fail_at(key, found, "none, for the file has no such thing");
    return whole_of(found, key, size - 1);
}

std::optional<std::size_t> JsonObject::find_index(const char* key, std::size_t size) const {
    if (!has(key)) return std::nullopt;
    return index(key, size);
}

std::vector<std::size_t> JsonObject::indices(const char* key, std::size_t size) const {
    std::vector<std::size_t> all;
    for (const Json& one : array(key)) {
        if (size == 0) fail_at(key, one, "none, for the file has no such thing");
        all.push_back(whole_of(one, key, size - 1));
    }
    return all;
}

double JsonObject::number(const char* key) const {
    const Json& found = needed(key);
    const double number = found.is_number() ? found.get<double>() : NAN;
    if (!std::isfinite(number)) fail_at(key, found, "a finite number");
    return number;
}

std::optional<std::vector<double>> JsonObject::numbers(const char* key, std::size_t size) const {
    if (!has(key)) return std::nullopt;
    const Json& list = array(key);
    if (size != 0 && list.size() != size) fail_at(key, list, std::to_string(size) + " numbers");
    std::vector<double> all;
    for (const Json& one : list) {
        all.push_back(one.is_number() ? one.get<double>() : NAN);
        if (!std::isfinite(all.back())) fail_at(key, one, "finite numbers");
    }
    return all;
}

std::string JsonObject::text(const char* key) const {
    const Json* found = value(key);
    if (found == nullptr) return "";
    if (!found->is_string()) fail_at(key, *found, "a text");
    return found->get<std::string>();
}

std::vector<std::string> JsonObject::texts(const char* key) const {
    std::vector<std::string> all;
    for (const Json& one : array(key)) {
        if (!one.is_string()) fail_at(key, one, "texts");
        all.push_back(one.get<std::string>());
    }
    return all;
}

bool JsonObject::flag_or(const char* key, bool fallback) const {
    const Json* found = value(key);
    if (found == nullptr) return fallback;
    if (!found->is_boolean()) fail_at(key, *found, "true or false");
    return found->get<bool>();
}

Json parse_json(std::span<const std::byte> text) {
    const std::string_view json = text_of(text);
    if (depth_of(json) > kMostDepth) {
        throw core::Error("JSON",
                          "its JSON is nested too deep",
                          "up to " + std::to_string(kMostDepth) + " levels");
    }
    try {
        return Json::parse(json);
    } catch (const Json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 3, column 7: ..."
        const std::string message = error.what();
        throw core::Error("JSON", "its JSON has a " + message.substr(message.find(']') + 2));
    }
}

}  // namespace ink::import
