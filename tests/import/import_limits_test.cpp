// What a hostile file may cost: one line. A test build of the import child misbehaves by request.

#include <gmock/gmock.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "core/whole_file.h"
#include "import/import.h"
#include "tests/core/error_text.h"
#include "tests/import/model_files.h"

namespace ink::import {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::uint64_t kMiB = 1 << 20;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;  // it catches signals, and no address space limit is set
#else
constexpr bool kIsSanitized = false;
#endif

class ImportLimit : public ModelFiles {
  protected:
    void TearDown() override {
        EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child was left behind";
        EXPECT_EQ(errno, ECHILD);
    }

    [[nodiscard]] static ImportLimits faulty() {
        ImportLimits limits;
        limits.child = std::filesystem::path(INK_BINARY_DIR) / "inkbench_import_faulty";
        limits.memory_bytes = 256 * kMiB;
        limits.output_bytes = 4 * kMiB;
        limits.wall_s = 60;
        return limits;
    }
    [[nodiscard]] static ImportLimits faulty_for_a_second() {
        ImportLimits limits = faulty();
        limits.wall_s = 1;
        return limits;
    }
    /// A good model under the name of a fault.
    [[nodiscard]] std::filesystem::path named(const std::string& fault) const {
        return write(fault + ".obj", kTriangleObj);
    }
};

TEST_F(ImportLimit, TestBuildReadsModelsToo) {
    EXPECT_EQ(scene::triangle_count(import_scene(named("harmless"), {}, faulty())), 1U);
}

TEST_F(ImportLimit, CrashIsNamed) {
    if (kIsSanitized) GTEST_SKIP() << "skipped: the sanitizer turns signals into exits";
    EXPECT_THAT(complaint(named("crash"), faulty()), StartsWith("it crashed its reader (SIGSEGV)"));
    EXPECT_THAT(complaint(named("abort"), faulty()), StartsWith("it crashed its reader (SIGABRT)"));
}

TEST_F(ImportLimit, HangIsStopped) {
    const std::string told = "reading it took longer than 1 s and was stopped";
    EXPECT_EQ(complaint(named("hang"), faulty_for_a_second()), told);
    EXPECT_EQ(complaint(named("sleep"), faulty_for_a_second()), told);
    EXPECT_EQ(complaint(named("linger"), faulty_for_a_second()), told);
}

TEST_F(ImportLimit, MemoryIsLimited) {
    if (kIsSanitized) GTEST_SKIP() << "skipped: the sanitizer needs the address space itself";
    EXPECT_EQ(complaint(named("hungry"), faulty()), "reading it takes more memory than 256 MiB");
}

TEST_F(ImportLimit, TooLittleMemoryToStart) {
    if (kIsSanitized) GTEST_SKIP() << "skipped: the sanitizer needs the address space itself";
    ImportLimits limits = faulty();
    limits.memory_bytes = kMiB;
    EXPECT_NE(complaint(named("harmless"), limits), "");
}

TEST_F(ImportLimit, OutputIsLimitedAndChecked) {
    EXPECT_EQ(complaint(named("flood"), faulty()), "it holds more scene data than 4 MiB");
    EXPECT_EQ(complaint(named("babble"), faulty()), "its reader gave a damaged answer");
    EXPECT_EQ(complaint(named("quit"), faulty()),
              "its reader failed without an answer (exit code 3)");
}

TEST_F(ImportLimit, MissingChildIsTold) {
    ImportLimits limits;
    limits.child = in_folder("nothing_here");
    EXPECT_THAT(core::error_text([&] { return import_scene(named("harmless"), {}, limits); }),
                AllOf(StartsWith(limits.child.string() +
                                 ": the program that reads models is missing (accepted: "),
                      HasSubstr("inkbench_import")));
}

TEST_F(ImportLimit, NothingReachesTheUsersTerminal) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    (void)complaint(named("abort"), faulty());
    (void)complaint(write("range.obj", "v 0 0 0\nf 1 2 9\n"));
    (void)complaint(write("prose.gltf", "{\"asset\": 3"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST_F(ImportLimit, SignalsMeanwhileDoNoHarm) {
    const auto path = named("harmless");
    struct sigaction on_alarm {};
    on_alarm.sa_handler = [](int) {};  // without SA_RESTART: every wait is interrupted
    struct sigaction before {};
    ASSERT_EQ(sigaction(SIGALRM, &on_alarm, &before), 0);
    const itimerval often{{0, 500}, {0, 500}};
    const itimerval never{};
    setitimer(ITIMER_REAL, &often, nullptr);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(scene::triangle_count(import_scene(path)), 1U);
    EXPECT_EQ(complaint(named("sleep"), faulty_for_a_second()),
              "reading it took longer than 1 s and was stopped");
    setitimer(ITIMER_REAL, &never, nullptr);
    sigaction(SIGALRM, &before, nullptr);
}

TEST_F(ImportLimit, WorksWhileChildrenAreIgnored) {
    const auto before = signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(scene::triangle_count(import_scene(named("harmless"))), 1U);
    EXPECT_EQ(complaint(named("babble"), faulty()), "its reader gave a damaged answer");
    signal(SIGCHLD, before);
}

TEST_F(ImportLimit, SeveralThreadsMayImport) {
    const auto good = named("harmless");
    const auto bad = named("babble");
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            EXPECT_EQ(scene::triangle_count(import_scene(good)), 1U);
            EXPECT_NE(complaint(bad, faulty()), "");
        });
    }
}

/// The process ids of a process's children; empty where the kernel does not tell.
std::string children_of(pid_t pid) {
    const std::string id = std::to_string(pid);
    return core::read_whole_file("/proc/" + id + "/task/" + id + "/children").value_or("");
}

TEST_F(ImportLimit, ChildDiesWithItsParent) {
    const auto path = named("sleep");
    // Orphans come to us, so that we can see how they ended.
    ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);
    const pid_t parent = fork();
    if (parent == 0) {
        (void)import_scene(path, {}, faulty());
        _exit(0);
    }
    std::string orphan;
    for (int tries = 0; tries < 500 && orphan.empty(); ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        orphan = children_of(parent);
    }
    kill(parent, SIGKILL);
    ASSERT_EQ(waitpid(parent, nullptr, 0), parent);
    if (orphan.empty()) GTEST_SKIP() << "skipped: this kernel does not list children";
    const pid_t child = std::stoi(orphan);
    int status = 0;
    pid_t ended = 0;
    for (int tries = 0; tries < 500 && ended == 0; ++tries) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        ended = waitpid(child, &status, WNOHANG);
    }
    EXPECT_EQ(ended, child) << "it outlived its parent";
    if (ended == 0) {
        kill(child, SIGKILL);
        waitpid(child, &status, 0);
    }
    EXPECT_TRUE(WIFSIGNALED(status));
    prctl(PR_SET_CHILD_SUBREAPER, 0);
}

}  // namespace
}  // namespace ink::import
