#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace ink::import {

/// How a text is split.
struct WordRules {
    char comment = 0;           ///< begins one where a word would begin; 0: there are none
    bool ends_words = false;    ///< it does inside a word, too
    bool is_continued = false;  ///< a backslash at a line's end joins it to the next
};

/// A foreign text, taken line by line and word by word. Lines end with LF, CR or both; words are
/// parted by spaces and tabs. Numbers do not depend on the locale.
///
/// Whatever is wrong becomes an Error whose message names the line, what, and what would do.
class LineWords {
  public:
    /// `text` must outlive this. Its first line has the number `first_line`.
    explicit LineWords(std::string_view text, WordRules rules = {}, std::size_t first_line = 1)
        : at_(text.data()), end_(text.data() + text.size()), rules_(rules), line_(first_line) {}

    /// Goes on to the next line that has a word, from the start to the first such; false at the
    /// end.
    bool next_line();

    /// The next word of the line; empty at its end.
    std::string_view word();
    /// What is left of the line, without blanks around it and without a comment; blank where it was
    /// joined to the next.
    std::string rest();

    /// The next word, as a number: `what` in messages. What no double can hold is infinite or 0.
    double number(std::string_view what);
    /// The next three words, each `what` in messages.
    glm::dvec3 vector(std::string_view what);
    /// The next word, as a whole number of 0 or more.
    std::uint64_t count(std::string_view what);

    [[nodiscard]] std::size_t line() const { return line_; }
    /// Whether no word is left on the line.
    bool is_line_over();
    /// Throws Error about the line where it stands, or about another.
    [[noreturn]] void fail(const std::string& what, const std::string& accepted) const;
    [[noreturn]] static void fail_at(std::size_t line,
                                     const std::string& what,
                                     const std::string& accepted);

  private:
    void skip_blanks();
    /// Goes to the line's end; returns what was left but blanks around it and a comment.
    std::string_view skip_line();
    void skip_line_end();
    [[nodiscard]] bool is_end_of_line(const char* p) const;
    [[nodiscard]] bool is_joint(const char* p) const;
    [[nodiscard]] bool is_end_of_word(const char* p) const;

    const char* at_;
    const char* end_;
    WordRules rules_;
    std::size_t line_;
    bool is_started_ = false;
};

/// Whether two words are the same but for upper and lower case (ASCII).
[[nodiscard]] bool is_same_word(std::string_view a, std::string_view b);

/// A foreign word fit for a message: in quotes, cut where it is long.
[[nodiscard]] std::string in_quotes(std::string_view word);

}  // namespace ink::import
