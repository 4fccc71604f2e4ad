#include "bake/gltf_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/base64.h"
#include "core/error.h"
#include "import/gltf/document.h"
#include "import/gltf/json.h"
#include "import/model_bytes.h"
#include "import/printable.h"

namespace ink::bake {
namespace {

namespace fs = std::filesystem;

constexpr std::array kMeshopt{"EXT_meshopt_compression", "KHR_meshopt_compression"};

std::string_view chars_of(std::span<const std::byte> bytes) {
    return import::text_of(bytes);
}

void fill_to_word(std::string& bytes) {
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
}

/// Whether a buffer or an image is a file of its own.
bool is_file(const Json& entry) {
    const auto uri = entry.find("uri");
    return uri != entry.end() && uri->is_string() &&
           !uri->get_ref<const std::string&>().starts_with("data:");
}

std::string data_uri(std::string_view bytes) {
    return "data:application/octet-stream;base64," +
           core::base64(std::as_bytes(std::span(bytes.data(), bytes.size())));
}

/// What an image's first bytes say it is; "" for what glTF has no word for.
std::string mime_type(std::string_view image) {
    if (image.starts_with("\x89PNG")) return "image/png";
    if (image.starts_with("\xff\xd8\xff")) return "image/jpeg";
    if (image.starts_with("\xabKTX 20")) return "image/ktx2";
    if (image.starts_with("RIFF") && image.substr(0, 12).ends_with("WEBP")) return "image/webp";
    return "";
}

bool is_same_folder(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a.empty() ? "." : a, b.empty() ? "." : b, error);
}

}  // namespace

GltfEdit::GltfEdit(import::GltfDocument document)
    : document_(std::move(document)),
      buffers_(document_),
      accessors_(document_, buffers_),
      json_(Json::parse(import::without_mark(import::text_of(document_.text)))),
      kept_buffers_(document_.buffers.size()) {
    std::iota(kept_buffers_.begin(), kept_buffers_.end(), std::size_t{0});
    // Ordered objects are vectors that copy all they hold when they grow: with room for the lists
    // that may be new, what callers hold of the JSON stays where it is.
    constexpr std::size_t kNewKeys = 8;
    auto& root = json_.get_ref<Json::object_t&>();
    root.reserve(root.size() + kNewKeys);
    may_reuse_ = knows_all_references(json_) && !document_.buffers.empty();
    if (may_reuse_) used_before_ = used_bytes(json_, 0, 0);
    uses_ = accessor_uses(json_);
}

std::size_t GltfEdit::add_view(std::span<const std::byte> bytes,
                               std::size_t stride_bytes,
                               Use use) {
    Json view = {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", bytes.size()}};
    if (stride_bytes > 0) view["byteStride"] = stride_bytes;
    if (use != Use::other) view["target"] = static_cast<int>(use);
    json_["bufferViews"].push_back(std::move(view));
    const std::size_t number = json_["bufferViews"].size() - 1;
    added_.push_back({std::string(chars_of(bytes)), {{number, 0}}});
    return number;
}

void GltfEdit::replace_view(std::size_t view, std::span<const std::byte> bytes) {
    json_["bufferViews"][view]["byteLength"] = bytes.size();
    added_.push_back({std::string(chars_of(bytes)), {{view, 0}}});
}

std::size_t GltfEdit::add_accessor(Json accessor) {
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
}

std::size_t GltfEdit::replace_accessor(std::size_t old, std::size_t uses, Json accessor) {
    if (!may_reuse_ || uses_[old] != uses) return add_accessor(std::move(accessor));
    json_["accessors"][old] = std::move(accessor);
    return old;
}

void GltfEdit::use_extension(const char* name) {
    Json& used = json_["extensionsUsed"];
    if (std::ranges::find(used, name) == used.end()) used.push_back(name);
}

void GltfEdit::drop_extension(const char* name) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (!json_.contains(list)) continue;
        Json& names = json_[list];
        names.erase(std::remove(names.begin(), names.end(), Json(name)), names.end());
        if (names.empty()) json_.erase(list);  // an empty list is not allowed
    }
}

std::size_t GltfEdit::unpack_views() {
    std::size_t count = 0;
    for (std::size_t v = 0; v < document_.buffer_views.size(); ++v) {
        for (const char* name : kMeshopt) {
            if (!document_.buffer_views[v].extension(name)) continue;
            Json& extensions = json_["bufferViews"][v]["extensions"];
            extensions.erase(name);
            if (extensions.empty()) json_["bufferViews"][v].erase("extensions");
            replace_view(v, buffers_.view(v));
            ++count;
        }
    }
    if (count > 0) drop_fallback_buffers();
    for (const char* name : kMeshopt)
        if (count > 0) drop_extension(name);
    return count;
}

/// Buffers that have no bytes: they say how much there is once it is unpacked.
void GltfEdit::drop_fallback_buffers() {
    std::vector<std::size_t> number_of;
    Json kept = Json::array();
    kept_buffers_.clear();
    for (std::size_t b = 0; b < document_.buffers.size(); ++b) {
        const import::JsonObject& buffer = document_.buffers[b];
        const bool is_fallback =
            !buffer.has("uri") && std::ranges::any_of(kMeshopt, [&](auto* name) {
                const auto extension = buffer.extension(name);
                return extension && extension->flag_or("fallback", false);
            });
        number_of.push_back(is_fallback ? 0 : kept.size());
        if (is_fallback) continue;
        kept.push_back(json_["buffers"][b]);
        kept_buffers_.push_back(b);
    }
    json_["buffers"] = std::move(kept);
    for (std::size_t v = 0; v < document_.buffer_views.size(); ++v)
        json_["bufferViews"][v]["buffer"] =
            number_of[document_.buffer_views[v].index("buffer", number_of.size())];
}

/// What the first buffer had in use and has no more.
std::vector<ByteRange> GltfEdit::free_bytes(std::size_t size) const {
    if (!may_reuse_ || kept_buffers_.empty() || kept_buffers_[0] != 0) return {};
    std::set<std::size_t> left_out;
    for (const Added& added : added_)
        for (const auto& [view, offset] : added.views)
            left_out.insert(view);
    std::vector<ByteRange> free;
    for (ByteRange range : without(used_before_, used_bytes(json_, 0, size, left_out))) {
        range.first = (range.first + 3) / 4 * 4;
        range.end = std::min(range.end, size);
        if (range.first < range.end) free.push_back(range);
    }
    return free;
}

std::string GltfEdit::filled(std::size_t buffer) {
    Json& buffers = json_["buffers"];
    std::string bytes;
    std::vector<ByteRange> free;
    if (buffer < kept_buffers_.size()) {
        bytes = chars_of(buffers_.buffer(kept_buffers_[buffer]));
        if (buffer == 0) free = free_bytes(bytes.size());
    } else {
        buffers.push_back(Json::object());
    }
    // The longest first: they find room most rarely.
    std::ranges::stable_sort(
        added_, [](const Added& a, const Added& b) { return a.bytes.size() > b.bytes.size(); });
    for (const Added& added : added_) {
        const auto room = std::ranges::find_if(free, [&](const ByteRange& range) {
            return range.end - range.first >= added.bytes.size();
        });
        std::size_t start = 0;
        if (room != free.end() && !added.bytes.empty()) {
            start = room->first;
            bytes.replace(start, added.bytes.size(), added.bytes);
            room->first = std::min((start + added.bytes.size() + 3) / 4 * 4, room->end);
        } else {
            fill_to_word(bytes);
            start = bytes.size();
            bytes += added.bytes;
        }
        for (const auto& [view, offset] : added.views) {
            json_["bufferViews"][view]["buffer"] = buffer;
            json_["bufferViews"][view]["byteOffset"] = start + offset;
        }
    }
    for (const ByteRange& range : free)
        idle_bytes_ += range.end - range.first;
    buffers[buffer]["byteLength"] = bytes.size();
    return bytes;
}

bool GltfEdit::names_files() const {
    for (const char* list : {"buffers", "images"}) {
        if (!json_.contains(list)) continue;
        if (std::ranges::any_of(json_[list], is_file)) return true;
    }
    return false;
}

void GltfEdit::hold_images(std::vector<std::string>& notes) {
    const std::vector<import::JsonObject> images = document_.root().list("images", "image");
    for (std::size_t i = 0; i < images.size(); ++i) {
        Json& image = json_["images"][i];
        if (!image.contains("uri") || !image["uri"].is_string()) continue;
        const std::string uri = image["uri"];
        std::optional<std::vector<std::byte>> bytes;
        try {
            bytes = buffers_.bytes_at(uri, images[i]);
        } catch (const core::Error&) {
            bytes.reset();  // another computer's, or outside the folder
        }
        const std::string type = bytes ? mime_type(chars_of(*bytes)) : "";
        if (type.empty()) {
            constexpr std::size_t kMostShown_chars = 60;
            notes.push_back(fmt::format(
                "image {} stays where it is: {}", i, import::printable(uri, kMostShown_chars)));
            continue;
        }
        image.erase("uri");
        image["bufferView"] = add_view(*bytes, 0, Use::other);
        image["mimeType"] = type;
    }
}

/// Takes the bytes of all buffers behind the first into it. Views of meshopt, which know buffers
/// too, are let alone: then those buffers stay, as data.
void GltfEdit::hold_buffers() {
    if (kept_buffers_.size() < 2) return;
    const auto& views = document_.buffer_views;
    const bool is_packed = std::ranges::any_of(views, [](auto& view) {
        return std::ranges::any_of(kMeshopt,
                                   [&](auto* name) { return view.extension(name).has_value(); });
    });
    Json& buffers = json_["buffers"];
    if (is_packed) {
        for (std::size_t b = 1; b < kept_buffers_.size(); ++b)
            if (is_file(buffers[b]))
                buffers[b]["uri"] = data_uri(chars_of(buffers_.buffer(kept_buffers_[b])));
        return;
    }
    std::vector<Added> held(kept_buffers_.size());
    for (std::size_t b = 1; b < held.size(); ++b)
        held[b].bytes = chars_of(buffers_.buffer(kept_buffers_[b]));
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::size_t b = views[v].index("buffer", document_.buffers.size());
        if (b > 0)
            held[b].views.emplace_back(v, views[v].whole_or("byteOffset", ~std::uint64_t{0}, 0));
    }
    added_.insert(added_.end(), held.begin() + 1, held.end());
    buffers.erase(buffers.begin() + 1, buffers.end());
    kept_buffers_.resize(1);
}

std::string GltfEdit::glb_for(const fs::path& path, std::vector<std::string>& notes) {
    if (!document_.has_binary || !is_same_folder(document_.folder, path.parent_path())) {
        hold_images(notes);
        hold_buffers();
    }
    if (!json_.contains("buffers") && added_.empty())
        return import::glb_bytes(json_.dump(), "", path);
    const std::string bytes = filled(0);
    json_["buffers"][0].erase("uri");
    return import::glb_bytes(json_.dump(), bytes, path);
}

std::string GltfEdit::gltf_for() {
    const bool has_chunk = document_.has_binary && json_.contains("buffers") &&
                           !json_["buffers"].empty() && !json_["buffers"][0].contains("uri");
    if (has_chunk || !added_.empty()) {
        const std::size_t buffer = has_chunk ? 0 : json_["buffers"].size();
        const std::string bytes = filled(buffer);
        json_["buffers"][buffer]["uri"] = data_uri(bytes);
    }
    return json_.dump(2) + "\n";
}

std::string GltfEdit::bytes_for(const fs::path& path, std::vector<std::string>& notes) {
    if (import::lower_case(path.extension().string()) == ".glb") return glb_for(path, notes);
    if (names_files() && !is_same_folder(document_.folder, path.parent_path())) {
        throw core::Error(path.string(),
                          "the model names files beside it, which a .gltf here would not find",
                          "a .gltf in " + document_.folder.string() + ", or a .glb");
    }
    return gltf_for();
}

}  // namespace ink::bake
