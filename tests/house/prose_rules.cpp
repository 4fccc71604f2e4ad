#include <algorithm>
#include <cctype>
#include <regex>
#include <sstream>

#include "tests/house/house_rules.h"

namespace ink::house {
namespace {

constexpr int kMostReadmeWords = 600;

/// The page without what no reader sees: HTML comments, and where links lead.
std::string as_read(const std::string& page) {
    static const std::regex comment("<!--[^>]*-->");
    static const std::regex target(R"(\]\([^)]*\))");
    return std::regex_replace(std::regex_replace(page, comment, ""), target, "]");
}

/// Runs of non-blank characters with a letter or a digit; those of tables and commands count too.
int word_count(const std::string& text) {
    std::istringstream words(text);
    int count = 0;
    for (std::string word; words >> word;) {
        count += std::any_of(
            word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
    }
    return count;
}

/// The page in small letters with its code blanked out, blocks and spans: every line keeps its
/// number.
std::string without_code(const SourceFile& page) {
    static const std::regex span("`[^`]*`");
    std::string text;
    bool is_in_block = false;
    for_each_line(page, [&](int, const std::string& line) {
        const bool is_fence = starts_with(line, "```");
        if (is_fence) is_in_block = !is_in_block;
        const bool is_code = is_fence || is_in_block || starts_with(line, "    ");
        text += (is_code ? "" : std::regex_replace(line, span, "`")) + "\n";
    });
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
        return static_cast<char>(std::tolower(c));
    });
    return text;
}

/// Words that only we use, or that a newcomer reads twice, each with what to write instead. A blank
/// stands for any white space, a line's end too.
struct Habit {
    std::string pattern;
    std::string instead;
};

const std::vector<Habit>& habits() {
    static const std::vector<Habit> list = {
        {"knobs?", "parameter"},
        {"witness(es)?", "cross-check"},
        {"foretold|foretells?", "predicted"},
        {"ledgers?", "scene statistics"},
        {"(hang|hangs|hung) on", "depends on"},
        {"(is|are|was|be) (said|told)", "the subject that says it"},
        {"held against", "compared with"},
        {"from which on", "at least"},
        {"unless said", "the default"},
        {"reckon(s|ed|ing)?", "estimate, or rule"},
        {"worth", "what is gained"},
        {"nobody|whoever", "no method, or a noun"},
        {"who", "that, or a noun: methods are things"},
    };
    return list;
}

std::regex pattern_of(const Habit& habit) {
    const std::string words = std::regex_replace(habit.pattern, std::regex(" "), "\\s+");
    return std::regex("\\b(" + words + ")\\b", std::regex::optimize);
}

/// Calls `visit` with the line and the text of every place that matches.
template <typename Visit>
void for_each_match(const std::string& text, const std::regex& pattern, const Visit& visit) {
    for (auto match = std::sregex_iterator(text.begin(), text.end(), pattern);
         match != std::sregex_iterator();
         ++match) {
        const auto newlines = std::count(text.begin(), text.begin() + match->position(), '\n');
        visit(static_cast<int>(newlines) + 1, match->str());
    }
}

}  // namespace

Findings check_readme(const SourceTree& tree) {
    const SourceFile* readme = tree.find("README.md");
    if (readme == nullptr) return {"README.md: missing"};
    const int words = word_count(as_read(readme->text));
    if (words <= kMostReadmeWords) return {};
    return {"README.md: " + std::to_string(words) + " words, of " +
            std::to_string(kMostReadmeWords) + " at most"};
}

Findings check_prose(const SourceTree& tree) {
    static const std::regex bare_fraction(R"((^|[\s(\[|+-])\.[0-9]+(?![0-9A-Za-z]))");
    std::vector<std::regex> patterns;
    for (const Habit& habit : habits())
        patterns.push_back(pattern_of(habit));
    Findings findings;
    for (const SourceFile& file : tree.files) {
        if (!ends_with(file.path, ".md")) continue;
        const std::string text = without_code(file);
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            for_each_match(text, patterns[i], [&](int line, const std::string& found) {
                findings.push_back(at(file, line) + "'" + found + "': write " +
                                   habits()[i].instead);
            });
        }
        for_each_match(text, bare_fraction, [&](int line, const std::string& found) {
            findings.push_back(at(file, line) + "'" + found + "': write its leading zero");
        });
    }
    return findings;
}

}  // namespace ink::house
