#include <gmock/gmock.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "tests/program/run_program.h"

// What a shell hands to the program: output that takes nothing, terminals, memory that is short.

namespace ink::program {
namespace {

using testing::HasSubstr;

/// Runs the program in a shell: `%` stands for it.
Outcome in_shell(const Desk& desk, std::string line) {
    for (std::size_t at = line.find('%'); at != std::string::npos; at = line.find('%', at))
        line.replace(at, 1, INK_PROGRAM);
    return desk.run_other("/bin/sh", {"-c", line});
}

/// Command lines of many commands that print something, and the help of all.
Words printing_lines(const Desk& desk) {
    expect_done(desk, "truth cube --size 64x36 -o t.exr");
    expect_done(desk, "draw cube --methods ids --size 64x36 -o d.png");
    expect_done(desk,
                "compare cube --methods mote4 --views 1 --size 64x36 --repetitions 1 --out run");
    Words lines;
    lines.insert(lines.end(),
                 {"--help",
                  "--version",
                  "help",
                  "list",
                  "list --json",
                  "draw cube --size 64x36 -o e.png",
                  "truth cube --size 64x36 -o e.exr",
                  "explain cube --size 64x36",
                  "score d.png t.exr",
                  "score d.png t.exr --json",
                  "score d.png t.exr --fail-under 1",
                  "export cube --size 64x36 --views 1 -o views",
                  "report run",
                  "diff run run"});
    for (const char* command : kCommands)
        lines.push_back(std::string(command) + " --help");
    return lines;
}

TEST(Output, ThatCannotBeWrittenIsAnErrorOfEveryCommand) {
    const Desk desk;
    for (const std::string& line : printing_lines(desk)) {
        for (const char* to : {" >/dev/full", " >&-"}) {
            SCOPED_TRACE(line + to);
            const Outcome outcome = in_shell(desk, "exec % " + line + to);
            EXPECT_EQ(outcome.exit_code, 2);
            EXPECT_THAT(outcome.err,
                        testing::ContainsRegex("(^|\n)inkbench: standard output [^\n]+\n$"));
        }
    }
}

TEST(Output, ThatNobodyReadsEndsTheProgramWithoutAWord) {
    const Desk desk;
    for (const char* before : {"", "trap '' PIPE; "}) {
        for (const char* line : {"list", "--help", "compare --help", "explain cube --size 64x36"}) {
            SCOPED_TRACE(std::string(before) + line);
            const Outcome outcome = in_shell(
                desk,
                std::string(before) + "( sleep .1; % " + line +
                    "; echo $? >code ) | true; "
                    "sleep .1; while [ ! -s code ]; do sleep .05; done; cat code; rm code");
            EXPECT_EQ(outcome.out, "141\n") << "128 + SIGPIPE";
            EXPECT_THAT(outcome.err, testing::Not(HasSubstr("inkbench")));
        }
    }
    const Outcome head = in_shell(desk, "% list | head -1");
    EXPECT_EQ(head.exit_code, 0);
    EXPECT_EQ(std::count(head.out.begin(), head.out.end(), '\n'), 1);
}

TEST(Output, OfClosedStreamsGoesIntoNoFile) {
    const Desk desk;
    const Outcome outcome =
        in_shell(desk, "exec % draw nosuch --size 64x36 -o a.png 2>&- </dev/null");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(in_shell(desk, "exec % draw cube --size 64x36 -o a.png <&- 2>&-").exit_code, 0);
    EXPECT_THAT(desk.read("a.png"), testing::StartsWith("\x89PNG"));
}

/// All that a terminal of this name gets to see; null leaves it without a name.
std::string on_terminal(const Desk& desk, const char* name, Words words) {
    words.insert(words.begin(), INK_PROGRAM);
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    argv.push_back(nullptr);
    const std::string folder = desk.work().string();
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
    if (child == 0) {
        setenv("XDG_CACHE_HOME", folder.c_str(), 1);
        unsetenv("TERM");
        if (name != nullptr) setenv("TERM", name, 1);
        if (chdir(folder.c_str()) == 0) execv(argv[0], argv.data());
        _exit(127);
    }
    std::string shown;
    std::array<char, 4096> part{};
    for (ssize_t n = 0; (n = read(terminal, part.data(), part.size())) > 0;)
        shown.append(part.data(), static_cast<std::size_t>(n));
    close(terminal);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0) << shown;
    return shown;
}

TEST(Terminal, WithoutANameGetsNoControlCharacters) {
    const Desk desk;
    const auto shown = [&](const char* name) {
        std::filesystem::remove_all(desk.work() / "out");
        return on_terminal(
            desk,
            name,
            "compare cube --methods mote4 --views 1 --size 64x36 --repetitions 1 --out out");
    };
    EXPECT_THAT(shown("xterm"), HasSubstr("\033[K")) << "else this test sees nothing";
    for (const char* name : {"dumb", "", static_cast<const char*>(nullptr)}) {
        const std::string text = shown(name);
        EXPECT_THAT(text, HasSubstr("mote4"));
        EXPECT_TRUE(std::all_of(text.begin(), text.end(), [](unsigned char c) {
            return c >= ' ' || c == '\n' || c == '\r' || c == '\t';
        })) << text;
        for (std::size_t at = text.find('\r'); at != text.npos; at = text.find('\r', at + 1))
            EXPECT_EQ(text[at + 1], '\n') << "a line drawn again";
    }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Memory, ThatIsTooShortIsSaid) {
    const Desk desk;
    int n_short = 0;
    int n_enough = 0;
    for (int most_mb = 80; most_mb < 800; most_mb += 30) {
        const Outcome outcome = in_shell(desk,
                                         "ulimit -v " + std::to_string(1024 * most_mb) +
                                             " && exec % truth cube --size 64x36 --no-cache");
        const bool is_loaded = outcome.err.find("loading shared libraries") == std::string::npos;
        if (!is_loaded) continue;
        (outcome.exit_code == 0 ? n_enough : n_short) += 1;
        if (outcome.exit_code == 0) continue;
        EXPECT_EQ(outcome.exit_code, 2) << most_mb << " MB: " << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr("memory")) << most_mb << " MB";
    }
    EXPECT_GT(n_short, 0);
    EXPECT_GT(n_enough, 0);
}
#endif

}  // namespace
}  // namespace ink::program
