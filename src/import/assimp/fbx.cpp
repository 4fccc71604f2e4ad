// Objects are found by the words that stand before them; nothing here is packed in binary files,
// where only long arrays are.

#include "import/assimp/fbx.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/matrix.hpp>
#include <optional>
#include <system_error>

namespace ink::import {
namespace {

/// The axis in the file's coordinates; nothing of none.
glm::dvec3 direction(const FbxAxes::Axis& axis) {
    glm::dvec3 result{0};
    if (axis.number >= 0 && axis.number < 3) result[axis.number] = axis.sign < 0 ? -1 : 1;
    return result;
}

/// Columns are where the file's x, y and z go.
glm::dmat3 turned_up(const FbxAxes::Axis& up) {
    const double sign = up.sign < 0 ? -1 : 1;
    switch (up.number) {
        case 0:
            return {{0, sign, 0}, {-sign, 0, 0}, {0, 0, 1}};
        case 2:
            return {{1, 0, 0}, {0, 0, -sign}, {0, sign, 0}};
        default:
            return {{1, 0, 0}, {0, sign, 0}, {0, 0, sign}};
    }
}

constexpr std::string_view kProjection = "CameraProjectionType";
constexpr std::string_view kZoom = "OrthoZoom";

/// The words and numbers of a file from a place on, as text or binary has them.
class FbxValues {
  public:
    FbxValues(std::string_view file, bool is_binary, std::size_t at)
        : rest_(file.substr(std::min(at, file.size()))), is_binary_(is_binary) {}

    std::optional<std::string> text() {
        if (is_binary_) {
            std::uint32_t size = 0;
            if (!rest_.starts_with('S') || rest_.size() < 5) return std::nullopt;
            std::memcpy(&size, rest_.data() + 1, sizeof size);
            if (size > rest_.size() - 5) return std::nullopt;
            const std::string found(rest_.substr(5, size));
            rest_.remove_prefix(5 + size);
            return found;
        }
        const std::size_t open = rest_.find('"');
        const std::size_t close = open == rest_.npos ? open : rest_.find('"', open + 1);
        if (close == rest_.npos) return std::nullopt;
        const std::string found(rest_.substr(open + 1, close - open - 1));
        rest_.remove_prefix(close + 1);
        return found;
    }

    std::optional<std::int64_t> number() {
        if (is_binary_) return packed_number();
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t,"), rest_.size()));
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc{}) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    std::optional<double> real() {
        double value = 0;
        if (is_binary_) {
            if (!rest_.starts_with('D') || rest_.size() < 1 + sizeof value) return std::nullopt;
            std::memcpy(&value, rest_.data() + 1, sizeof value);
            return value;
        }
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t,"), rest_.size()));
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        return error == std::errc{} ? std::optional(value) : std::nullopt;
    }

  private:
    std::optional<std::int64_t> packed_number() {
        const bool is_long = rest_.starts_with('L');
        const std::size_t size = is_long ? 8 : 4;
        if ((!is_long && !rest_.starts_with('I')) || rest_.size() < 1 + size) return std::nullopt;
        std::int64_t whole = 0;
        std::int32_t half = 0;
        if (is_long) std::memcpy(&whole, rest_.data() + 1, size);
        if (!is_long) std::memcpy(&half, rest_.data() + 1, size);
        rest_.remove_prefix(1 + size);
        return is_long ? whole : half;
    }

    std::string_view rest_;
    bool is_binary_;
};

/// The width that the camera of an attribute sees.
double width_of(std::string_view attribute, bool is_binary) {
    constexpr double kWidthOfZoom = 30;
    const std::size_t at = attribute.find(kZoom);
    if (at == attribute.npos) return kWidthOfZoom;
    FbxValues values(attribute, is_binary, at + kZoom.size() + (is_binary ? 0 : 1));
    for (int word = 0; word < 3; ++word)
        (void)values.text();  // its type, and flags
    return kWidthOfZoom * values.real().value_or(1);
}

/// The attributes (objects that say what a camera is) of orthographic cameras, by number, and what
/// these see.
std::map<std::int64_t, double> parallel_attributes(std::string_view file, bool is_binary) {
    const std::string_view object = is_binary ? "\x0dNodeAttribute" : "NodeAttribute: ";
    std::map<std::int64_t, double> found;
    for (std::size_t at = file.find(kProjection); at != file.npos;
         at = file.find(kProjection, at + 1)) {
        FbxValues values(file, is_binary, at + kProjection.size() + (is_binary ? 0 : 1));
        for (int word = 0; word < 3; ++word)
            (void)values.text();  // its type, and flags
        if (values.number() != 1) continue;
        const std::size_t owner = file.rfind(object, at);
        if (owner == file.npos) continue;
        const auto number = FbxValues(file, is_binary, owner + object.size()).number();
        const std::size_t end = file.find(object, at);
        if (number) found[*number] = width_of(file.substr(owner, end - owner), is_binary);
    }
    return found;
}

/// The objects to which one of `children` is connected, and what it has.
std::map<std::int64_t, double> parents_of(const std::map<std::int64_t, double>& children,
                                          std::string_view file,
                                          bool is_binary) {
    const std::string_view link = is_binary ? "\x01"
                                              "CS\x02"
                                            : "C: \"OO\"";
    std::map<std::int64_t, double> found;
    for (std::size_t at = file.find(link); at != file.npos; at = file.find(link, at + 1)) {
        FbxValues values(file, is_binary, at + (is_binary ? 2 : link.size()));
        if (is_binary && values.text() != "OO") continue;
        const auto child = values.number();
        const auto parent = values.number();
        const auto of = child ? children.find(*child) : children.end();
        if (parent && of != children.end()) found[*parent] = of->second;
    }
    return found;
}

/// "Model::name" of text, "name\0\1Model" of binary files.
std::string plain_name(const std::string& name) {
    const std::size_t end = name.find('\0');
    if (end != name.npos) return name.substr(0, end);
    const std::size_t prefix = name.find("::");
    return prefix == name.npos ? name : name.substr(prefix + 2);
}

}  // namespace

glm::dmat4 y_up_from_fbx(const FbxAxes& axes) {
    glm::dmat3 turn = turned_up(axes.up);
    const glm::dmat3 frame(direction(axes.right), direction(axes.up), direction(axes.front));
    if (glm::determinant(frame) < 0) turn[axes.front.number] = -turn[axes.front.number];
    const bool has_unit = std::isfinite(axes.cm_per_unit) && axes.cm_per_unit > 0;
    return glm::dmat4(turn * (has_unit ? axes.cm_per_unit : 1.0));
}

std::map<std::string, double> read_fbx_parallel_cameras(std::string_view file) {
    const bool is_binary = file.starts_with("Kaydara FBX Binary");
    const auto attributes = parallel_attributes(file, is_binary);
    std::map<std::string, double> cameras;
    if (attributes.empty()) return cameras;
    const auto models = parents_of(attributes, file, is_binary);
    const std::string_view object = is_binary ? "\x05Model" : "Model: ";
    for (std::size_t at = file.find(object); at != file.npos; at = file.find(object, at + 1)) {
        FbxValues values(file, is_binary, at + object.size());
        const auto number = values.number();
        const auto name = number ? values.text() : std::nullopt;
        const auto of = number ? models.find(*number) : models.end();
        if (name && of != models.end()) cameras[plain_name(*name)] = of->second;
    }
    return cameras;
}

}  // namespace ink::import
