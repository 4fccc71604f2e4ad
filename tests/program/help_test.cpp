#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "tests/program/run_program.h"

// What the program says of itself, and of a command line that it does not understand.

namespace ink::program {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

std::string expect_done(const Words& words) {
    return expect_done(Desk(), words);
}

std::string refused(const Words& words) {
    return refusal(Desk(), words);
}

TEST(Help, OfEveryCommandHasAnExampleAndExitCodesAndFitsATerminal) {
    for (const char* command : kCommands) {
        SCOPED_TRACE(command);
        const std::string help = expect_done({command, "--help"});
        EXPECT_THAT(help,
                    AllOf(HasSubstr("Example"),
                          HasSubstr(std::string("inkbench ") + command),
                          HasSubstr("Exit codes: 0 done")));
        std::istringstream lines(help);
        for (std::string line; std::getline(lines, line);) {
            if (line.find("inkbench ") != std::string::npos) continue;
            EXPECT_LE(line.size(), 80U) << line;
        }
    }
}

TEST(Help, SaysOfEveryRunWhatExitCode3Means) {
    for (const char* command : {"compare", "run", "merge", "figures"}) {
        std::string help = expect_done({command, "--help"});
        std::replace(help.begin(), help.end(), '\n', ' ');
        EXPECT_THAT(help, HasSubstr("3 some views have no score (crowded ones do not count)"))
            << command;
    }
}

TEST(Help, IsACommandToo) {
    for (const char* command : kCommands)
        EXPECT_EQ(expect_done({"help", command}), expect_done({command, "--help"})) << command;
    const std::string all = expect_done({"--help"});
    EXPECT_EQ(expect_done({"help"}), all);
    for (const char* command : kCommands)
        EXPECT_THAT(all, HasSubstr(std::string("\n  ") + command + " ")) << command;
    EXPECT_THAT(refused({"help", "compair"}), HasSubstr("did you mean compare?"));
}

TEST(Help, FitsAScreenAndNamesWhatItLeavesToHelpAll) {
    const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
    EXPECT_LE(lines(expect_done({"--help"})), 60);
    for (const char* command : kCommands) {
        SCOPED_TRACE(command);
        const std::string help = expect_done({command, "--help"});
        EXPECT_LE(lines(help), 60);
        std::istringstream all(expect_done({command, "--help-all"}));
        for (std::string line; std::getline(all, line);) {
            const auto end = line.find_first_of(" ,", 2);
            if (!line.starts_with("  --")) continue;
            EXPECT_THAT(help, HasSubstr(line.substr(2, end - 2)));
        }
    }
    EXPECT_THAT(expect_done({"compare", "--help-all"}),
                AllOf(HasSubstr("\nCamera:\n  --projection"), HasSubstr("\nTruth:\n  --crease")));
}

TEST(Help, OfNothingAskedIsFourExamples) {
    const Outcome bare = Desk().run({});
    EXPECT_EQ(bare.exit_code, 0);
    std::istringstream lines(bare.out);
    for (std::string line; std::getline(lines, line) && !line.empty();)
        EXPECT_THAT(line, AllOf(HasSubstr("inkbench "), HasSubstr("bunny.obj ")));
    EXPECT_THAT(bare.out, HasSubstr("inkbench --help"));
}

TEST(Help, ShowsDefaults) {
    EXPECT_THAT(expect_done({"draw", "--help"}),
                AllOf(HasSubstr("(default: 1280x720)"), HasSubstr("(default: mote4)")));
}

TEST(Help, NamesTheOptionsThatScriptsRelyOn) {
    const std::pair<const char*, Words> named[] = {
        {"compare",
         "--size --methods --scenes --set --threads --seed --views --eye --target --up --fov "
         "--parallel --projection"},
        {"draw",
         "-o --shading --set-shade --ink --paper --surface --line-width "
         "--antialias --dither none|gouraud|toon|gooch|strokes"},
        {"score", "--tol --threshold --no-thin --band --ignore --json"}};
    for (const auto& [command, options] : named)
        for (const std::string& option : options)
            EXPECT_THAT(expect_done({command, "--help"}), HasSubstr(option)) << command;
    for (const std::string& command : Words("compare figures tune stress run merge"))
        EXPECT_THAT(expect_done({command, "--help"}), HasSubstr("-o,--out DIR")) << command;
    for (const std::string& command :
         Words("compare advise truth figures timedemo tune stress run"))
        EXPECT_THAT(expect_done({command, "--help"}), HasSubstr("-q,--quiet")) << command;
}

/// The names in the block "Arguments:" of a help text.
Words arguments_of(const std::string& help) {
    Words names;
    bool is_inside = false;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("  ")) {
            is_inside = line == "Arguments:";
        } else if (is_inside && line[2] != ' ') {
            names.push_back(line.substr(2, line.find(' ', 2) - 2));
        }
    }
    return names;
}

TEST(Help, CallsNoArgumentLikeAnOption) {
    // CLI11 2.4 ends the program over it, whatever the command line.
    std::size_t count = 0;
    for (const char* command : kCommands) {
        const std::string help = expect_done({command, "--help"});
        for (const std::string& name : arguments_of(help)) {
            ++count;
            for (const char* end : {",", " ", "\n"})
                EXPECT_THAT(help, Not(HasSubstr("--" + name + end))) << command;
        }
    }
    EXPECT_GT(count, 10U);
    EXPECT_THAT(expect_done({"tune", "--help"}),
                AllOf(HasSubstr("\n  METHOD  "), HasSubstr("\n  SCENES ...  ")));
}

TEST(Complaint, EndsWithTheHelpOfItsCommand) {
    for (const char* command : kCommands) {
        EXPECT_THAT(refused({command, "--no-such-option"}),
                    AllOf(HasSubstr("--no-such-option"),
                          EndsWith(std::string("(see inkbench ") + command + " --help)\n")));
    }
    EXPECT_THAT(refused({"draw", "torus", "--size"}), EndsWith("(see inkbench draw --help)\n"));
    EXPECT_THAT(refused({"compare", "--lanes"}), EndsWith("(see inkbench compare --help)\n"));
    EXPECT_THAT(refused({"--nothing"}), EndsWith("(see inkbench --help)\n"));
}

TEST(Complaint, NamesTheNearestOption) {
    EXPECT_THAT(refused({"compare", "--metods", "mote4"}), HasSubstr("did you mean --methods?"));
    EXPECT_THAT(refused({"draw", "--sice=64x36"}), HasSubstr("did you mean --size?"));
    EXPECT_THAT(refused({"draw", "--zzzzzz"}), Not(HasSubstr("did you mean")));
}

}  // namespace
}  // namespace ink::program
