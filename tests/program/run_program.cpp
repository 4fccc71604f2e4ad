#include "tests/program/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace ink::program {
namespace {

namespace fs = std::filesystem;

constexpr auto kPatience = std::chrono::minutes(5);
constexpr auto kGlance = std::chrono::milliseconds(5);

std::string slurp(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Only async-signal-safe calls between fork and exec.
[[noreturn]] void become_program(const fs::path& root, char* const* argv, char* const* env) {
    const int out = open((root / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err = open((root / "err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int none = open("/dev/null", O_RDONLY);
    if (chdir((root / "work").c_str()) == 0 && dup2(none, 0) == 0 && dup2(out, 1) == 1 &&
        dup2(err, 2) == 2) {
        execve(argv[0], argv, env);
    }
    _exit(127);
}

std::vector<char*> pointers(Words& texts) {
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

int wait_for(pid_t child, const std::function<bool()>& is_time, int signal) {
    const auto deadline = std::chrono::steady_clock::now() + kPatience;
    bool is_told = false;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (!is_told && is_time && is_time()) {
            kill(child, signal);
            is_told = true;
        }
        if (std::chrono::steady_clock::now() > deadline) kill(child, SIGKILL);
        std::this_thread::sleep_for(kGlance);
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// One record of `text` from `at` on, which moves behind it.
std::vector<std::string> read_record(const std::string& text, std::size_t& at) {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"' && is_quoted && at + 1 < text.size() && text[at + 1] == '"') {
            fields.back() += c;
            ++at;
        } else if (c == '"') {
            is_quoted = !is_quoted;
        } else if (!is_quoted && c == ',') {
            fields.emplace_back();
        } else if (!is_quoted && c == '\n') {
            ++at;
            break;
        } else if (is_quoted || c != '\r') {
            fields.back() += c;
        }
    }
    return fields;
}

}  // namespace

Words::Words(const std::string& line) {
    std::istringstream words(line);
    for (std::string word; words >> word;)
        push_back(word);
}

Desk::Desk() {
    fs::create_directory(work());
    fs::create_directory(root_ / "cache");
}

Outcome Desk::run(const Words& arguments) const {
    return run_until(arguments, nullptr);
}

Outcome Desk::run_until(const Words& arguments, const std::function<bool()>& is_time) const {
    return run_with_signal(INK_PROGRAM, arguments, is_time, SIGINT);
}

Outcome Desk::kill_when(const Words& arguments, const std::function<bool()>& is_time) const {
    return run_with_signal(INK_PROGRAM, arguments, is_time, SIGKILL);
}

Outcome Desk::run_other(const std::string& program, const Words& arguments) const {
    return run_with_signal(program, arguments, nullptr, SIGINT);
}

Outcome Desk::run_with_signal(const std::string& program,
                              const Words& arguments,
                              const std::function<bool()>& is_time,
                              int signal) const {
    Words words = Words{program} + arguments;
    Words settings = {"PATH=/usr/bin:/bin",
                      "HOME=" + root_.string(),
                      "XDG_CACHE_HOME=" + (root_ / "cache").string()};
    // Sanitizers take their options from here; and the program, which Python draws figures.
    for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "INKBENCH_PYTHON"}) {
        if (const char* value = std::getenv(name); value != nullptr) {
            settings.push_back(std::string(name) + "=" + value);
        }
    }
    const std::vector<char*> argv = pointers(words);
    const std::vector<char*> env = pointers(settings);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot fork");
    if (child == 0) become_program(root_.path(), argv.data(), env.data());
    Outcome outcome;
    outcome.exit_code = wait_for(child, is_time, signal);
    outcome.out = slurp(root_ / "out");
    outcome.err = slurp(root_ / "err");
    return outcome;
}

std::string Desk::write(const std::string& name, const std::string& content) const {
    fs::create_directories((work() / name).parent_path());
    std::ofstream(work() / name, std::ios::binary) << content;
    return name;
}

std::string Desk::read(const std::string& name) const {
    return slurp(work() / name);
}

std::map<std::string, std::uintmax_t> Desk::inventory() const {
    std::map<std::string, std::uintmax_t> found;
    for (const auto& entry : fs::recursive_directory_iterator(work())) {
        found[entry.path().lexically_relative(work()).string()] =
            entry.is_regular_file() ? entry.file_size() : 0;
    }
    return found;
}

std::string without_progress(const std::string& err) {
    static const std::regex kProgress(
        R"(^([^:]+: \d+/\d+(, .*)?|\S+: (all )?\d+ cells .*|still about .*|done in .*)"
        R"(|inkbench: busy machine: times of \d+ of \d+ cells are uncertain)$)");
    std::istringstream lines(err);
    std::string rest;
    for (std::string line; std::getline(lines, line);)
        if (!std::regex_match(line, kProgress)) rest += line + "\n";
    return rest;
}

std::string expect_done(const Desk& desk, const Words& words) {
    const Outcome outcome = desk.run(words);
    EXPECT_EQ(outcome.exit_code, 0) << testing::PrintToString(words) << outcome.err;
    EXPECT_EQ(without_progress(outcome.err), "") << testing::PrintToString(words);
    return outcome.out;
}

nlohmann::json expect_json(const Desk& desk, const Words& words) {
    return nlohmann::json::parse(expect_done(desk, words));
}

std::string refusal(const Desk& desk, const Words& words) {
    SCOPED_TRACE("inkbench " + testing::PrintToString(words));
    const auto before = desk.inventory();
    const Outcome outcome = desk.run(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_TRUE(outcome.err.ends_with('\n')) << "no whole line";
    EXPECT_EQ(desk.inventory(), before) << "something was left behind";
    return outcome.err;
}

void expect_refused(const Desk& desk, const Words& words, const Words& parts) {
    const std::string line = refusal(desk, words);
    for (const std::string& part : parts)
        EXPECT_NE(line.find(part), line.npos) << "no '" << part << "' in: " << line;
}

void expect_all_refused(const Desk& desk, const Words& begin, const std::vector<Wrong>& wrong) {
    for (const auto& [words, parts] : wrong)
        expect_refused(desk, begin + words, parts);
}

Table parse_csv(const std::string& text) {
    std::size_t at = 0;
    const std::vector<std::string> columns = read_record(text, at);
    Table table;
    while (at < text.size()) {
        const std::vector<std::string> fields = read_record(text, at);
        if (fields.size() != columns.size()) {
            throw std::runtime_error("a row has " + std::to_string(fields.size()) +
                                     " fields, the header " + std::to_string(columns.size()));
        }
        auto& row = table.emplace_back();
        for (std::size_t i = 0; i < columns.size(); ++i)
            row[columns[i]] = fields[i];
    }
    return table;
}

Table rows_of(const Desk& desk, const std::string& folder) {
    return parse_csv(desk.read(folder + "/rows.csv"));
}

Table only(Table rows, const std::string& method) {
    std::erase_if(rows, [&](const auto& row) { return row.at("method") != method; });
    return rows;
}

nlohmann::json page_data(const std::string& page) {
    const std::string open = "<script type=\"application/json\" id=\"data\">";
    const std::size_t begin = page.find(open) + open.size();
    return nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

nlohmann::json page_table(const Desk& desk, const std::string& folder, const std::string& name) {
    const auto data = page_data(desk.read(folder + "/report.html"));
    return data["runs"][0]["tables"].value(name, nlohmann::json());
}

Table rows_of_study(const Desk& desk, const std::string& study) {
    Table rows = rows_of(desk);
    std::erase_if(rows, [&](const auto& row) { return row.at("study") != study; });
    return rows;
}

Table table_of_run(const Desk& desk, const std::string& folder, const std::string& name) {
    std::map<std::string, std::map<std::string, std::string>> cells;
    for (const auto& row : rows_of(desk, folder))
        cells.emplace(row.at("cell"), row);
    Table table = parse_csv(desk.read(folder + "/" + name));
    for (auto& line : table) {
        const auto found = cells.find(line.at("cell"));
        if (found == cells.end()) throw std::runtime_error(name + " names no cell of rows.csv");
        line.insert(found->second.begin(), found->second.end());
    }
    return table;
}

}  // namespace ink::program
