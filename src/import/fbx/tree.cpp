// The form is published nowhere; it is that of Blender's io_scene_fbx and of the files themselves.

#include "import/fbx/tree.h"

#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <system_error>

#include "core/error.h"

namespace ink::import {
namespace {

constexpr std::string_view kBinaryMark = "Kaydara FBX Binary  ";
constexpr std::size_t kHeaderBytes = 27;    // the mark, three bytes, the version
constexpr std::uint32_t kFirstWide = 7500;  // from this version on places are of 8 bytes
constexpr int kMostLevels = 100;

[[noreturn]] void fail(const std::string& place, const std::string& what) {
    throw core::Error("", place + ": " + what, "a whole, valid FBX file");
}

class BinaryTree {
  public:
    explicit BinaryTree(std::string_view file) : file_(file), end_(file.size()) {}

    FbxElement read() {
        FbxElement root;
        at_ = kBinaryMark.size() + 3;
        is_wide_ = take<std::uint32_t>() >= kFirstWide;
        at_ = kHeaderBytes;
        read_children(root, 0);
        return root;
    }

  private:
    void need(std::size_t bytes, const char* what) const {
        if (bytes <= end_ - at_) return;
        fail("byte " + std::to_string(at_), std::string(what) + " ends beyond its element");
    }

    template <class T>
    T take() {
        need(sizeof(T), "a number");
        T value{};
        std::memcpy(&value, file_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    std::uint64_t take_place() { return is_wide_ ? take<std::uint64_t>() : take<std::uint32_t>(); }

    std::string_view take_bytes(std::size_t count) {
        need(count, "a text");
        const std::string_view bytes = file_.substr(at_, count);
        at_ += count;
        return bytes;
    }

    /// Until an element of no name and no end, or the end.
    void read_children(FbxElement& parent, int level) {
        if (level > kMostLevels) fail("byte " + std::to_string(at_), "it is nested too deeply");
        const std::size_t end_of_parent = end_;
        while (at_ < end_of_parent) {
            const std::size_t begin = at_;
            const std::uint64_t end = take_place();
            const std::uint64_t values = take_place();
            (void)take_place();  // the bytes of the values
            const std::string_view name = take_bytes(take<std::uint8_t>());
            if (end == 0) return;
            if (end < at_ || end > end_of_parent)
                fail("byte " + std::to_string(begin), "an element ends beyond what holds it");
            FbxElement& element = parent.children.emplace_back();
            element.name = name;
            end_ = end;
            for (std::uint64_t v = 0; v < values; ++v)
                element.values.push_back(take_value());
            read_children(element, level + 1);
            at_ = end;
            end_ = end_of_parent;
        }
        if (level == 0) fail("byte " + std::to_string(at_), "the file is cut short");
    }

    FbxValue take_value() {
        FbxValue value;
        const char type = take<char>();
        switch (type) {
            case 'Y':
                value.whole = take<std::int16_t>();
                break;
            case 'C':
            case 'B':
                value.whole = take<std::uint8_t>();
                break;
            case 'I':
                value.whole = take<std::int32_t>();
                break;
            case 'L':
                value.whole = take<std::int64_t>();
                break;
            case 'F':
                value.real = take<float>();
                return value;
            case 'D':
                value.real = take<double>();
                return value;
            case 'S':
                value.text = take_bytes(take<std::uint32_t>());
                return value;
            case 'R':  // pictures and the like
                (void)take_bytes(take<std::uint32_t>());
                return value;
            default:
                value.list = take_array(type);
                value.is_array = true;
                return value;
        }
        value.real = static_cast<double>(value.whole);
        return value;
    }

    std::vector<double> take_array(char type) {
        const std::size_t begin = at_ - 1;
        const auto count = take<std::uint32_t>();
        const auto encoding = take<std::uint32_t>();
        const auto packed_bytes = take<std::uint32_t>();
        switch (type) {
            case 'f':
                return numbers<float>(unpacked(count * std::size_t{4}, encoding, packed_bytes));
            case 'd':
                return numbers<double>(unpacked(count * std::size_t{8}, encoding, packed_bytes));
            case 'i':
                return numbers<std::int32_t>(
                    unpacked(count * std::size_t{4}, encoding, packed_bytes));
            case 'l':
                return numbers<std::int64_t>(
                    unpacked(count * std::size_t{8}, encoding, packed_bytes));
            case 'b':
            case 'c':
                return numbers<std::uint8_t>(unpacked(count, encoding, packed_bytes));
            default:
                fail("byte " + std::to_string(begin), "a value of no known type");
        }
    }

    /// An array's bytes. zlib makes at most 1032 of one.
    std::string unpacked(std::size_t bytes, std::uint32_t encoding, std::uint32_t packed_bytes) {
        const std::string place = "byte " + std::to_string(at_);
        if (encoding == 0) return std::string(take_bytes(bytes));
        const std::string_view packed = take_bytes(packed_bytes);
        if (encoding != 1 || bytes / 1032 > packed.size()) fail(place, "a packed array is damaged");
        std::string plain(bytes, '\0');
        uLongf made = bytes;
        const int error = uncompress(reinterpret_cast<Bytef*>(plain.data()),
                                     &made,
                                     reinterpret_cast<const Bytef*>(packed.data()),
                                     packed.size());
        if (error != Z_OK || made != bytes) fail(place, "a packed array is damaged");
        return plain;
    }

    template <class T>
    static std::vector<double> numbers(const std::string& bytes) {
        std::vector<double> list(bytes.size() / sizeof(T));
        for (std::size_t i = 0; i < list.size(); ++i) {
            T value{};
            std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
            list[i] = static_cast<double>(value);
        }
        return list;
    }

    std::string_view file_;
    std::size_t at_ = 0;
    std::size_t end_;  ///< of the element that is being read
    bool is_wide_ = false;
};

class TextTree {
  public:
    explicit TextTree(std::string_view file) : file_(file) {}

    FbxElement read() {
        FbxElement root;
        read_children(root, 0);
        if (!is_at_end()) fail_here("a \"}\" too many");
        return root;
    }

  private:
    [[noreturn]] void fail_here(const std::string& what) const {
        const auto line =
            1 + std::count(file_.begin(), file_.begin() + static_cast<long>(at_), '\n');
        fail("line " + std::to_string(line), what);
    }

    [[nodiscard]] bool is_at_end() const { return at_ >= file_.size(); }
    [[nodiscard]] char next() const { return is_at_end() ? '\0' : file_[at_]; }

    void skip_blanks() {
        while (!is_at_end()) {
            if (next() == ';') {
                at_ = std::min(file_.find_first_of("\r\n", at_), file_.size());
            } else if (std::string_view(" \t\r\n").find(next()) == std::string_view::npos) {
                return;
            } else {
                ++at_;
            }
        }
    }

    bool take(char c) {
        skip_blanks();
        if (next() != c) return false;
        ++at_;
        return true;
    }

    std::string_view take_word() {
        skip_blanks();
        const std::size_t end = std::min(file_.find_first_of(" \t\r\n,:{}\";", at_), file_.size());
        const std::string_view word = file_.substr(at_, end - at_);
        at_ = end;
        return word;
    }

    void read_children(FbxElement& parent, int level) {
        if (level > kMostLevels) fail_here("it is nested too deeply");
        for (skip_blanks(); !is_at_end() && next() != '}'; skip_blanks()) {
            FbxElement& element = parent.children.emplace_back();
            element.name = take_word();
            if (element.name.empty() || !take(':')) fail_here("no \"NAME:\" stands here");
            read_values(element);
            if (take('{')) {
                if (!element.values.empty() && element.values[0].text.starts_with('*')) {
                    element.values[0].is_array = true;
                    read_array(element.values[0].list);
                } else {
                    read_children(element, level + 1);
                }
                if (!take('}')) fail_here("a \"}\" is missing");
            }
        }
    }

    void read_values(FbxElement& element) {
        while (true) {
            skip_blanks();
            const std::size_t begin = at_;
            if (next() == '"') {
                element.values.push_back(take_text());
            } else if (next() == ',') {
                element.values.emplace_back();  // "Content: ," has none before its first comma
            } else {
                const std::string_view word = take_word();
                skip_blanks();
                if (word.empty()) return;
                if (next() == ':') {  // the next element
                    at_ = begin;
                    return;
                }
                element.values.push_back(value_of(word));
            }
            skip_blanks();
            if (next() == '"') continue;
            if (!take(',')) return;
        }
    }

    FbxValue take_text() {
        const std::size_t end = file_.find('"', at_ + 1);
        if (end == file_.npos) fail_here("a text has no end");
        FbxValue value;
        value.text = file_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return value;
    }

    void read_array(std::vector<double>& list) {
        if (take_word() != "a" || !take(':')) fail_here("an array has no \"a:\"");
        skip_blanks();
        while (next() != '}') {
            const std::string_view word = take_word();
            if (word.empty()) fail_here("no number stands here");
            list.push_back(value_of(word).real);
            if (!take(',')) return;
            skip_blanks();
        }
    }

    static FbxValue value_of(std::string_view word) {
        FbxValue value;
        const char* end = word.data() + word.size();
        const auto real = std::from_chars(word.data(), end, value.real);
        if (real.ec == std::errc::result_out_of_range) {
            value.real = word.find("e-") != word.npos || word.find("E-") != word.npos
                             ? 0
                             : std::numeric_limits<double>::infinity();
        } else if (real.ec != std::errc{} || real.ptr != end) {
            value.text = word;
            value.real = std::numeric_limits<double>::quiet_NaN();
        }
        const auto whole = std::from_chars(word.data(), end, value.whole);
        if (whole.ec != std::errc{}) value.whole = 0;
        return value;
    }

    std::string_view file_;
    std::size_t at_ = 0;
};

}  // namespace

const FbxElement* FbxElement::child(std::string_view called) const {
    for (const FbxElement& element : children)
        if (element.name == called) return &element;
    return nullptr;
}

std::string FbxElement::text(std::size_t i) const {
    return i < values.size() ? values[i].text : std::string{};
}

std::int64_t FbxElement::whole(std::size_t i) const {
    return i < values.size() ? values[i].whole : 0;
}

double FbxElement::real(std::size_t i) const {
    return i < values.size() ? values[i].real : 0;
}

std::vector<double> FbxElement::list(std::string_view called) const {
    const FbxElement* element = child(called);
    if (element == nullptr || element->values.empty()) return {};
    if (element->values[0].is_array) return element->values[0].list;
    std::vector<double> numbers;
    for (const FbxValue& value : element->values)
        numbers.push_back(value.real);
    return numbers;
}

std::string FbxElement::word(std::string_view called) const {
    const FbxElement* element = child(called);
    return element == nullptr ? std::string{} : element->text(0);
}

bool is_fbx_binary(std::string_view file) {
    return file.starts_with(kBinaryMark);
}

FbxElement read_fbx_tree(std::string_view file) {
    return is_fbx_binary(file) ? BinaryTree(file).read() : TextTree(file).read();
}

}  // namespace ink::import
