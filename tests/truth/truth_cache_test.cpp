#include "truth/truth_cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/truth/shapes.h"
#include "truth/truth_file.h"

namespace ink::truth {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "inkbench_truth_XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        view_.width_px = 120;
        view_.height_px = 90;
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Cached, with a trace time that no trace takes, so that a read is told from a trace.
    Truth plant() {
        Truth truth = trace_truth(scene_, view_, options_);
        truth.trace_s = 12345;
        const std::string key = truth_key(scene_, view_, options_);
        const auto bytes = encode_truth(truth, key);
        write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return truth;
    }
    void write(std::string_view bytes) { std::ofstream(file(), std::ios::binary) << bytes; }
    [[nodiscard]] std::string read() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] fs::path file() const {
        return folder_ / (truth_key(scene_, view_, options_) + ".truth");
    }
    Truth cached_in(const std::filesystem::path& folder) {
        SceneModel model(scene_, options_);
        return cached_truth(model, view_, folder);
    }
    Truth cached() { return cached_in(folder_); }

    scene::Scene scene_ = scene_of({box({-1, -1, -1}, {1, 1, 1}), box({1, -1, -1}, {2, 1, 1})});
    scene::View view_ = view_from({2, 3, 9}, {0, 0, 0});
    TruthOptions options_;
    fs::path folder_;
};

void expect_equal(const Truth& a, const Truth& b) {
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.below_crease, b.below_crease);
    EXPECT_TRUE(same_curves(a, b));
    EXPECT_EQ(a.sampled, b.sampled);
    EXPECT_EQ(a.exact_corner, b.exact_corner);
    EXPECT_EQ(a.layers.triangle, b.layers.triangle);
    EXPECT_EQ(a.layers.patch, b.layers.patch);
    EXPECT_EQ(a.layers.n_dot_v, b.layers.n_dot_v);
    EXPECT_EQ(a.layers.w, b.layers.w);
    EXPECT_EQ(a.counts.rays, b.counts.rays);
    EXPECT_EQ(a.counts.crowded_share, b.counts.crowded_share);
}

TEST_F(Cache, ComesBackAsItWasTraced) {
    const Truth first = cached();
    EXPECT_TRUE(fs::exists(file()));
    const Truth again = cached();
    expect_equal(first, again);
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
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
        << "no unfinished file is left";
}

TEST_F(Cache, FileOfAnotherKeyIsNotTaken) {
    plant();
    const std::string bytes = read();
    options_.crease_rad = 2;
    write(bytes);
    EXPECT_NE(cached().trace_s, 12345);
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
    EXPECT_EQ(key, truth_key(scene_, view_, options_));
    TruthOptions options = options_;
    options.threads = 7;
    EXPECT_EQ(key, truth_key(scene_, view_, options)) << "threads change nothing";
    options = options_;
    options.crease_rad = 0.5;
    EXPECT_NE(key, truth_key(scene_, view_, options));
    options = options_;
    options.material_seams = true;
    EXPECT_NE(key, truth_key(scene_, view_, options));
    options = options_;
    options.layers = false;
    EXPECT_NE(key, truth_key(scene_, view_, options));
    scene::View view = view_;
    view.width_px += 1;
    EXPECT_NE(key, truth_key(scene_, view, options_));
    view = view_;
    view.camera.eye_world.x += 1e-9;
    EXPECT_NE(key, truth_key(scene_, view, options_));
    view = view_;
    view.camera.near *= 2;
    EXPECT_NE(key, truth_key(scene_, view, options_));
    scene::Scene scene = scene_;
    scene.meshes[0].positions[0].x += 0.001F;
    EXPECT_NE(key, truth_key(scene, view_, options_));
}

}  // namespace
}  // namespace ink::truth
