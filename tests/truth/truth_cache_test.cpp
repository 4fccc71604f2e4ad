#include "truth/truth_cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "core/byte_stream.h"
#include "core/kept_file.h"
#include "core/whole_file.h"
#include "tests/core/temp_folder.h"
#include "tests/truth/shapes.h"

namespace ink::truth {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
  protected:
    void SetUp() override {
        view_.width_px = 120;
        view_.height_px = 90;
    }

    /// Cached, with a trace time that no trace takes, so that a read is told from a trace.
    Truth plant() {
        Truth truth = trace_truth(scene_, view_, options_);
        truth.trace_s = 12345;
        const std::string key = truth_key(scene_, view_, options_);
        write(encode_truth(truth, key));
        return truth;
    }
    void write(std::string_view bytes) { std::ofstream(file(), std::ios::binary) << bytes; }
    [[nodiscard]] std::string read() const { return core::read_whole_file(file()).value_or(""); }
    [[nodiscard]] fs::path file() const {
        return folder_ / (truth_key(scene_, view_, options_) + ".truth");
    }
    Truth cached_in(const std::filesystem::path& folder) {
        SceneModel model(scene_, options_);
        return cached_truth(model, view_, folder);
    }
    Truth cached() { return cached_in(folder_.path()); }

    scene::Scene scene_ = scene_of({box({-1, -1, -1}, {1, 1, 1}), box({1, -1, -1}, {2, 1, 1})});
    scene::View view_ = view_from({2, 3, 9}, {0, 0, 0});
    TruthOptions options_;
    core::TempFolder folder_;
};

TEST_F(Cache, ComesBackAsItWasTraced) {
    const Truth first = cached();
    EXPECT_TRUE(fs::exists(file()));
    const Truth again = cached();
    expect_same_truth(first, again);
    EXPECT_EQ(first.trace_s, again.trace_s) << "it is read, not traced again";
}

TEST_F(Cache, IsReadWhereItFits) {
    plant();
    EXPECT_EQ(cached().trace_s, 12345);
}

TEST_F(Cache, DamagedFilesAreTracedAnewAndReplaced) {
    const Truth truth = plant();
    const std::string whole = read();
    Noise noise(3);
    for (int i = 0; i < 60; ++i) {
        std::string bytes = whole;
        const auto at = static_cast<std::size_t>(noise.next() * static_cast<double>(bytes.size()));
        if (i % 2 == 0) {
            bytes.resize(at);
        } else {
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (i % 8)));
        }
        write(bytes);
        const Truth again = cached();
        EXPECT_NE(again.trace_s, 12345) << i;
        EXPECT_EQ(again.labels, truth.labels);
    }
    EXPECT_EQ(read().size(), whole.size()) << "the damaged file was replaced";
    for (const std::string foreign : {"", "hello", "inktrut1"}) {
        write(foreign);
        EXPECT_EQ(cached().labels, truth.labels);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1)
        << "no unfinished file is left";
}

TEST_F(Cache, FileOfAnotherKeyIsNotTaken) {
    plant();
    const std::string bytes = read();
    options_.crease_rad = 2;
    write(bytes);
    EXPECT_NE(cached().trace_s, 12345);
}

/// A truth of sky, 4 x 3 px.
Truth small_truth() {
    Truth truth;
    truth.labels = truth.below_crease = core::Image<std::uint8_t>(4, 3);
    truth.sampled = truth.exact_corner = edge::EdgeImage(4, 3);
    truth.layers.triangle = truth.layers.patch = core::Image<std::uint32_t>(4, 3, kNoTriangle);
    truth.layers.n_dot_v = core::Image<float>(4, 3);
    truth.layers.w = core::Image<float>(4, 3, std::numeric_limits<float>::infinity());
    return truth;
}

bool comes_back(const Truth& truth) {
    return decode_truth(encode_truth(truth, "key"), "key").has_value();
}

TEST(TruthFile, HasImagesOfOneSize) {
    EXPECT_TRUE(comes_back(small_truth()));
    EXPECT_TRUE(comes_back(Truth{}));
    Truth without_layers = small_truth();
    without_layers.layers = {};
    without_layers.sampled = without_layers.exact_corner = {};
    EXPECT_TRUE(comes_back(without_layers));
    Truth other_labels = small_truth();
    other_labels.labels = core::Image<std::uint8_t>(3, 4);
    EXPECT_FALSE(comes_back(other_labels));
    Truth other_patches = small_truth();
    other_patches.layers.patch = core::Image<std::uint32_t>(4, 2, kNoTriangle);
    EXPECT_FALSE(comes_back(other_patches));
}

TEST(TruthFile, ClaimsOfManyPixelsAreNotAllocated) {
    // The labels' size with its runs, under a hash that fits: 2^20 x 2^20 px in one run of few.
    const std::string payload = core::written_bytes(
        [](core::ByteWriter& out) { out.parts(1U << 20, 1U << 20, 12U, std::uint8_t{0}); });
    const core::KeptKind kind = {'i', 'n', 'k', 't', 'r', 'u', 't', '1'};
    EXPECT_TRUE(core::unsealed(encode_truth({}, "key"), kind, "key").has_value());
    const std::string bytes = core::sealed(kind, "key", payload);
    EXPECT_FALSE(decode_truth(bytes, "key").has_value());
}

TEST_F(Cache, UnwritableFolderCostsTheCachingOnly) {
    std::ofstream(folder_ / "plain_file") << "in the way";
    const Truth truth = cached_in(folder_ / "plain_file");
    EXPECT_GT(drawn_px(truth), 0U);
    const Truth below = cached_in(folder_ / "plain_file" / "below");
    EXPECT_EQ(truth.labels, below.labels);
    EXPECT_EQ(truth.labels, cached_in({}).labels);
}

TEST_F(Cache, KeyDependsOnAllThatChangesTheTruth) {
    const std::string key = truth_key(scene_, view_, options_);
    const auto changed = [&](const auto& change) {
        scene::Scene scene = scene_;
        scene::View view = view_;
        TruthOptions options = options_;
        change(scene, view, options);
        return truth_key(scene, view, options) != key;
    };
    EXPECT_FALSE(changed([](auto&, auto&, auto&) {}));
    EXPECT_FALSE(changed([](auto&, auto&, auto& options) { options.threads = 7; }));
    EXPECT_TRUE(changed([](auto&, auto&, auto& options) { options.crease_rad = 0.5; }));
    EXPECT_TRUE(changed([](auto&, auto&, auto& options) { options.weld_epsilon = 0.5; }));
    EXPECT_TRUE(
        changed([](auto&, auto&, auto& options) { options.creases = scene::CreaseSource::file; }));
    EXPECT_TRUE(changed([](auto&, auto&, auto& options) { options.layers = false; }));
    EXPECT_TRUE(changed([](auto&, auto& view, auto&) { view.width_px += 1; }));
    EXPECT_TRUE(changed([](auto&, auto& view, auto&) { view.camera.eye_world.x += 1e-9; }));
    EXPECT_TRUE(changed([](auto&, auto& view, auto&) { view.camera.near *= 2; }));
    EXPECT_TRUE(
        changed([](auto& scene, auto&, auto&) { scene.meshes[0].positions[0].x += 0.001F; }));
}

}  // namespace
}  // namespace ink::truth
