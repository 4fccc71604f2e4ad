// What fuzzers began with and what they found: every target takes its corpus, without a fuzzer.

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <set>
#include <vector>

#include "core/whole_file.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {
namespace {

namespace fs = std::filesystem;

struct Target {
    const char* name;
    void (*check)(Bytes);
};

void PrintTo(const Target& target, std::ostream* out) {
    *out << target.name;
}

#define INK_FUZZ_LISTED(name) {#name, check_##name},
constexpr Target kTargets[] = {INK_FUZZ_TARGETS(INK_FUZZ_LISTED)};
#undef INK_FUZZ_LISTED

std::set<fs::path> corpus_of(const std::string& target) {
    std::set<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(INK_SOURCE_DIR) / "tests/fuzz/corpus" / target))
        files.insert(entry.path());
    return files;
}

std::vector<std::uint8_t> bytes_of(const fs::path& path) {
    const std::string text = core::read_whole_file(path).value_or("");
    return {text.begin(), text.end()};
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, KeepsTheLaws) {
    const auto files = corpus_of(GetParam().name);
    ASSERT_FALSE(files.empty());
    for (const fs::path& file : files) {
        const std::vector<std::uint8_t> bytes = bytes_of(file);
        EXPECT_FALSE(bytes.empty()) << file;
        EXPECT_NO_THROW(GetParam().check(bytes)) << file;
    }
}

TEST_P(Corpus, CutAnywhereKeepsTheLaws) {
    const std::vector<std::uint8_t> bytes = bytes_of(*corpus_of(GetParam().name).begin());
    const std::size_t step = bytes.size() / 64 + 1;
    for (std::size_t size = 0; size < bytes.size(); size += step)
        EXPECT_NO_THROW(GetParam().check(Bytes(bytes).first(size))) << size;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(kTargets), [](const auto& value) {
    return std::string(value.param.name);
});

}  // namespace
}  // namespace ink::fuzz
