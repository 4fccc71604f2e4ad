#include "scene/prepared_scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include "catalogue/catalogue.h"
#include "scene/surface.h"
#include "scene/topology.h"

namespace {

using namespace ink::scene;

class Prepared : public testing::Test {
  protected:
    Scene scene_ = ink::catalogue::make_catalogue_scene("cube");
    PreparedScene prepared_{scene_};
};

TEST_F(Prepared, GivesWhatTheSceneGives) {
    const Surface alone = flatten(scene_, NormalSource::patch, 0.5);
    const auto surface = prepared_.surface(NormalSource::patch, 0.5);
    EXPECT_EQ(surface->p_world, alone.p_world);
    EXPECT_EQ(surface->n_world, alone.n_world);
    EXPECT_EQ(surface->triangles, alone.triangles);
    EXPECT_TRUE(prepared_.surface()->n_world.empty());
    EXPECT_EQ(prepared_.topology()->p_world, weld(scene_).p_world);
    EXPECT_EQ(prepared_.hash(), scene_hash(scene_));
    EXPECT_EQ(prepared_.bounds().radius, bounding_sphere(scene_).radius);
}

TEST_F(Prepared, MakesEachOnceAndTellsSettingsApart) {
    const auto smooth = prepared_.surface(NormalSource::patch, 3);
    EXPECT_EQ(prepared_.surface(NormalSource::patch, 3), smooth);
    EXPECT_NE(prepared_.surface(NormalSource::patch, 0.5), smooth);
    EXPECT_NE(prepared_.surface(NormalSource::facet, 3), smooth);
    EXPECT_NE(prepared_.topology(0.01), prepared_.topology());
}

/// Works for so long, by the clock of its thread: waiting counts as nothing.
void work(std::chrono::nanoseconds time) {
    const auto now = [] {
        return std::chrono::nanoseconds(
            ink::core::machine_clock().now(ink::core::Worker::thread).cpu_ns);
    };
    for (const auto start = now(); now() - start < time;) {
    }
}

/// Asks by name for what says how often it was made, and takes a while each time.
class Asked {
  public:
    Asked(const Scene& scene, std::size_t most) : scene_(scene, most) {}

    std::size_t operator()(const char* name, std::chrono::milliseconds takes) {
        return scene_
            .get(name,
                 [&] {
                     work(takes);
                     return std::vector<int>(static_cast<std::size_t>(++made_));
                 })
            ->size();
    }

  private:
    PreparedScene scene_;
    int made_ = 0;
};

TEST_F(Prepared, KeepsWhatTookLongUntilOthersWereAskedForAsLong) {
    constexpr std::chrono::milliseconds kLong(40), kShort(1);
    Asked ask(scene_, 2);
    EXPECT_EQ(ask("long", kLong), 1U);
    EXPECT_EQ(ask("short", kShort), 2U);
    EXPECT_EQ(ask("other", kShort), 3U);  // the short one goes
    EXPECT_EQ(ask("long", kLong), 1U);
    EXPECT_EQ(ask("short", kShort), 4U);  // the other goes
    for (int i = 0; i < 100; ++i)
        (void)ask(i % 2 == 0 ? "other" : "short", kShort);
    EXPECT_GT(ask("long", kLong), 4U);
}

TEST_F(Prepared, KeepsSmallOnes) {
    const PreparedScene few(scene_, 2);
    int made = 0;
    const auto ask = [&](const char* name) { return *few.get(name, [&] { return ++made; }); };
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(ask("a"), 1);
        EXPECT_EQ(ask("b"), 2);
        EXPECT_EQ(ask("c"), 3);
    }
}

TEST_F(Prepared, IsMadeOnceForAllThatShareIt) {
    std::atomic<int> made = 0;
    const auto make = [&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return ++made;
    };
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&] {
            const PreparedScene mine = prepared_.shared();
            EXPECT_EQ(*mine.get("a", make), 1);
        });
    }
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(made, 1);
}

TEST_F(Prepared, IsMadeByTheNextIfMakingThrows) {
    const auto fail = []() -> int { throw std::runtime_error("no"); };
    EXPECT_THROW((void)prepared_.get("a", fail), std::runtime_error);
    EXPECT_EQ(*prepared_.get("a", [] { return 7; }), 7);
}

TEST_F(Prepared, CountsWhatIsThereAsLongAsItTookWithAllThatIsInIt) {
    using std::chrono::nanoseconds;
    constexpr std::chrono::milliseconds kStep(2);
    const auto step = [&] {
        work(kStep);
        std::this_thread::sleep_for(20 * kStep);  // which is no work
    };
    const auto inner = [&] {
        return prepared_.get("inner", [&] {
            step();
            return 1;
        });
    };
    const auto outer = [&] {
        return prepared_.get("outer", [&] {
            step();
            return *inner();
        });
    };
    (void)inner();
    EXPECT_EQ(prepared_.saved_ns(), 0);
    (void)outer();
    const nanoseconds of_inner(prepared_.saved_ns());
    EXPECT_GE(of_inner, kStep);
    EXPECT_LT(of_inner, 10 * kStep);
    (void)outer();
    EXPECT_GE(nanoseconds(prepared_.saved_ns()) - of_inner, of_inner + kStep);
}

}  // namespace
