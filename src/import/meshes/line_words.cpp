#include "import/meshes/line_words.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

#include "core/error.h"
#include "core/parse_number.h"

namespace ink::import {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0';
}

bool is_line_break(char c) {
    return c == '\n' || c == '\r';
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// What from_chars leaves open: whether a number out of a double's range is too small or too large.
double out_of_range(std::string_view word) {
    const bool is_negative = word.front() == '-';
    if (is_negative) word.remove_prefix(1);
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_small = exponent != word.npos ? word.substr(exponent + 1).starts_with('-')
                                                : word.front() == '0' || word.front() == '.';
    if (is_small) return 0;
    return (is_negative ? -1 : 1) * std::numeric_limits<double>::infinity();
}

}  // namespace

bool LineWords::is_end_of_line(const char* p) const {
    return p == end_ || is_line_break(*p);
}

/// Whether the line goes on behind its end.
bool LineWords::is_joint(const char* p) const {
    return rules_.is_continued && *p == '\\' && p + 1 != end_ && is_line_break(p[1]);
}

bool LineWords::is_end_of_word(const char* p) const {
    return is_end_of_line(p) || is_blank(*p) || is_joint(p) ||
           (rules_.ends_words && *p == rules_.comment);
}

void LineWords::skip_line_end() {
    if (at_ == end_) return;
    if (*at_ == '\r' && at_ + 1 != end_ && at_[1] == '\n') ++at_;
    ++at_;
    ++line_;
}

void LineWords::skip_blanks() {
    for (; at_ != end_; ++at_) {
        if (is_blank(*at_)) continue;
        if (!is_joint(at_)) return;
        ++at_;
        skip_line_end();
        --at_;  // the loop takes its step
    }
}

bool LineWords::next_line() {
    if (is_started_) {
        (void)skip_line();
        skip_line_end();
    }
    is_started_ = true;
    for (; at_ != end_; skip_line_end()) {
        if (!is_line_over()) return true;
        while (!is_end_of_line(at_))
            ++at_;  // a comment
    }
    return false;
}

bool LineWords::is_line_over() {
    skip_blanks();
    return is_end_of_line(at_) || (rules_.comment != 0 && *at_ == rules_.comment);
}

std::string_view LineWords::word() {
    if (is_line_over()) return {};
    const char* first = at_;
    while (!is_end_of_word(at_))
        ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
}

std::string_view LineWords::skip_line() {
    skip_blanks();
    const char* first = at_;
    const char* last = at_;  // behind the last word
    while (!word().empty())
        last = at_;
    while (!is_end_of_line(at_))
        ++at_;
    return {first, static_cast<std::size_t>(last - first)};
}

std::string LineWords::rest() {
    std::string text(skip_line());
    if (!rules_.is_continued) return text;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        if (text[i] != '\\' || !is_line_break(text[i + 1])) continue;
        const bool is_pair = text.substr(i + 1, 2) == "\r\n";
        text.replace(i, is_pair ? 3 : 2, 1, ' ');
    }
    return text;
}

double LineWords::number(std::string_view what) {
    if (is_line_over()) fail(std::string(what) + " is missing", "a number");
    const char* first = at_;
    if (*first == '+' && first + 1 != end_ && first[1] != '-') ++first;
    double value = 0;
    const auto [end, error] = std::from_chars(first, end_, value);
    const bool is_number = error != std::errc::invalid_argument && is_end_of_word(end);
    if (!is_number) fail(std::string(what) + " is " + in_quotes(word()), "a number");
    if (error == std::errc::result_out_of_range)
        value = out_of_range({first, static_cast<std::size_t>(end - first)});
    at_ = end;
    return value;
}

glm::dvec3 LineWords::vector(std::string_view what) {
    glm::dvec3 v;
    for (int axis = 0; axis < 3; ++axis)
        v[axis] = number(what);
    return v;
}

std::uint64_t LineWords::count(std::string_view what) {
    const std::string_view digits = word();
    const auto value = core::parse_number<std::uint64_t>(digits);
    if (digits.empty()) fail(std::string(what) + " is missing", "a whole number of 0 or more");
    if (!value) fail(std::string(what) + " is " + in_quotes(digits), "a whole number of 0 or more");
    return *value;
}

void LineWords::fail(const std::string& what, const std::string& accepted) const {
    fail_at(line_, what, accepted);
}

void LineWords::fail_at(std::size_t line, const std::string& what, const std::string& accepted) {
    throw core::Error("", "line " + std::to_string(line) + ": " + what, accepted);
}

bool is_same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        return lower(x) == lower(y);
    });
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t kMost = 40;
    const bool is_long = word.size() > kMost;
    return '"' + std::string(word.substr(0, is_long ? kMost - 3 : kMost)) +
           (is_long ? "...\"" : "\"");
}

}  // namespace ink::import
