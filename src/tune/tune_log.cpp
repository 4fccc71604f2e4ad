#include "tune/tune_log.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <sstream>
#include <utility>

#include "core/error.h"
#include "core/parse_number.h"
#include "core/whole_file.h"

namespace ink::tune {
namespace {

std::vector<std::string_view> fields_of(std::string_view line) {
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        fields.push_back(line.substr(begin, end - begin));
        begin = end + 1;
    }
    return fields;
}

/// k, n_pred and n_truth of one view after the other; nothing if a number is damaged.
std::optional<std::vector<score::CurveCount>> parse_counts(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::vector<score::CurveCount> counts;
    for (score::CurveCount count; words >> count.k;) {
        if (!(words >> count.n_pred >> count.n_truth)) return std::nullopt;
        counts.push_back(count);
    }
    return words.eof() ? std::optional(counts) : std::nullopt;
}

/// settings,value,error,draw_ms,counts; nothing for a line that is damaged.
std::optional<std::pair<std::string, TuneValue>> parse_line(std::string_view line) {
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != 5) return std::nullopt;
    const auto value = core::parse_number<double>(fields[1]);
    const auto error = core::parse_number<double>(fields[2]);
    const auto by_view = parse_counts(fields[4]);
    if (!value || !error || !by_view) return std::nullopt;
    const auto draw_ms = core::parse_number<double>(fields[3]);
    return std::pair(
        std::string(fields[0]),
        TuneValue{.value = *value, .error = *error, .draw_ms = draw_ms, .by_view = *by_view});
}

std::string line_of(const std::string& settings, const TuneValue& value) {
    std::vector<std::string> counts;
    for (const score::CurveCount& count : value.by_view)
        counts.push_back(fmt::format("{} {} {}", count.k, count.n_pred, count.n_truth));
    return fmt::format("{},{},{},{},{}\n",
                       settings,
                       value.value,
                       value.error,
                       value.draw_ms ? fmt::format("{}", *value.draw_ms) : "",
                       fmt::join(counts, " "));
}

std::string heading(const std::string& key) {
    return "search " + key;
}

}  // namespace

TuneLog::TuneLog(std::filesystem::path path, const std::string& key) : path_(std::move(path)) {
    read(key);
    std::string text = heading(key) + "\n";
    for (const auto& [settings, value] : values_)
        text += line_of(settings, value);
    core::write_whole_file(path_, text);
    stream_.open(path_, std::ios::app);
    if (!stream_) {
        throw core::Error(path_.string(),
                          "it cannot be written: " + core::system_reason(errno),
                          "a file in a writable folder");
    }
    found_ = values_.size();
}

void TuneLog::read(const std::string& key) {
    std::istringstream text(core::read_whole_file(path_).value_or(""));
    std::string line;
    if (!std::getline(text, line) || line != heading(key)) return;
    while (std::getline(text, line) && !text.eof())  // at its end one was killed while writing
        if (const auto found = parse_line(line)) values_.insert(*found);
}

std::optional<TuneValue> TuneLog::find(const std::string& settings) const {
    const auto found = values_.find(settings);
    return found == values_.end() ? std::nullopt : std::optional(found->second);
}

void TuneLog::add(const std::string& settings, const TuneValue& value) {
    values_[settings] = value;
    errno = 0;
    stream_ << line_of(settings, value) << std::flush;
    if (!stream_) {
        throw core::Error(path_.string(),
                          fmt::format("a line could not be written: {}; those before it are there",
                                      core::system_reason(errno)),
                          "room on the disk");
    }
}

void TuneLog::remove() {
    stream_.close();
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

}  // namespace ink::tune
