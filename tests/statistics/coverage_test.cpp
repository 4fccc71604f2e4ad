// How often intervals hold what they say, as known_coverage_percent() has it: F and paired
// differences of samples of scenes, drawn from a world of scenes whose F is known.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <random>
#include <vector>

#include "statistics/bootstrap.h"

namespace ink::statistics {
namespace {

using Counts = score::CurveCount;

constexpr std::size_t kMethodCount = 8;

/// Matches within 2 px, and drawn and true pixels together, of eight methods on each scene of the
/// catalogue, over its views at 320x180: decaudin, roberts_tuned, sobel, mote4, two_sums, ids,
/// surface8 and id_lookup. Counted at commit 2dfdab8a.
const Counts kWorld[][kMethodCount] = {
    // clang-format off
    {{1276, 2560}, {1284, 2568}, {1284, 2661}, {1283, 2567}, {1283, 2567}, {1276, 2560}, {1283, 2567}, {1283, 2567}},
    {{2915, 6096}, {3158, 6325}, {3084, 6255}, {3069, 6237}, {3077, 6240}, {3160, 6416}, {3159, 6322}, {3163, 6326}},
    {{2332, 4692}, {2331, 4665}, {2334, 4731}, {2327, 4666}, {2326, 4660}, {2141, 4478}, {2304, 4653}, {2334, 4668}},
    {{2878, 6131}, {3118, 6248}, {3100, 6227}, {3053, 6180}, {3110, 6237}, {3103, 6233}, {3126, 6254}, {3126, 6254}},
    {{4101, 8373}, {4233, 8480}, {4196, 8437}, {4141, 8382}, {4210, 8450}, {4221, 8478}, {4224, 8464}, {4238, 8478}},
    {{2686, 5491}, {2788, 5606}, {2769, 5573}, {2778, 5583}, {2784, 5589}, {2782, 5588}, {2800, 5605}, {2800, 5605}},
    {{3600, 7614}, {3879, 7778}, {3792, 7688}, {3740, 7631}, {3780, 7669}, {3879, 7809}, {3886, 7792}, {3886, 7792}},
    {{964, 2122}, {1107, 2272}, {1053, 2211}, {1000, 2156}, {1052, 2209}, {1103, 2285}, {1156, 2329}, {1156, 2329}},
    {{3907, 11045}, {4482, 11593}, {4382, 11475}, {3909, 11002}, {3905, 10998}, {7073, 14351}, {7078, 14171}, {7078, 14171}},
    {{4281, 11366}, {4862, 11936}, {4774, 11842}, {4536, 11604}, {4536, 11604}, {6872, 14001}, {7030, 14100}, {7030, 14100}},
    {{2093, 4354}, {2195, 4452}, {2162, 4395}, {2131, 4350}, {2180, 4393}, {1642, 3855}, {2208, 4649}, {2209, 4422}},
    {{4734, 11316}, {6251, 12652}, {5753, 12082}, {5956, 17726}, {6059, 14756}, {6093, 12689}, {6252, 12562}, {6269, 12571}},
    {{5779, 12761}, {6858, 13818}, {6574, 13492}, {6119, 13054}, {6087, 13007}, {6892, 14135}, {6893, 13813}, {6898, 13817}},
    {{6233, 13640}, {7080, 14423}, {6894, 14206}, {6894, 14290}, {6958, 14266}, {7019, 14396}, {7290, 14717}, {7295, 14639}},
    {{3922, 8489}, {4236, 8657}, {4271, 8654}, {4253, 8734}, {4291, 8670}, {3570, 7947}, {4309, 8716}, {4364, 8733}},
    {{2644, 7043}, {2576, 6045}, {2606, 6031}, {2965, 15393}, {2902, 10061}, {1772, 4765}, {2829, 10795}, {2913, 5908}},
    {{3061, 7404}, {3324, 7454}, {3387, 7521}, {3406, 7537}, {3446, 7571}, {3243, 7404}, {3407, 7532}, {3487, 7612}},
    {{3002, 6226}, {3181, 6378}, {3126, 6314}, {3100, 6299}, {3138, 6326}, {3117, 6311}, {3186, 6395}, {3187, 6375}},
    {{2881, 6482}, {3441, 7019}, {3187, 6800}, {3309, 7062}, {3344, 6914}, {3207, 6771}, {3524, 7129}, {3528, 7068}},
    {{3040, 6708}, {3486, 7039}, {3406, 6967}, {3323, 6842}, {3435, 6957}, {3512, 7088}, {3510, 7026}, {3510, 7026}},
    {{3236, 6799}, {3451, 7074}, {3401, 7032}, {3306, 6877}, {3395, 6917}, {3319, 6841}, {3508, 7029}, {3519, 7039}},
    {{5374, 12207}, {6508, 13281}, {6274, 13027}, {6037, 12764}, {6277, 12983}, {6541, 13445}, {6686, 13390}, {6686, 13387}},
    {{5272, 11204}, {5868, 11816}, {5731, 11672}, {5436, 11374}, {5697, 11635}, {5884, 11836}, {5896, 11821}, {5907, 11832}},
    {{2707, 5475}, {2756, 5518}, {2743, 5530}, {2743, 5508}, {2741, 5501}, {2241, 5014}, {2731, 5502}, {2755, 5512}},
    {{7656, 18255}, {9695, 20498}, {8605, 19024}, {8439, 18958}, {8806, 19229}, {10278, 21275}, {10379, 20845}, {10398, 20818}},
    {{2102, 4471}, {2132, 4491}, {2158, 4436}, {2164, 4476}, {2093, 4379}, {2159, 4510}, {2215, 4961}, {2248, 4499}},
    {{4116, 10908}, {5388, 11891}, {5657, 12118}, {5784, 12622}, {5887, 12332}, {6192, 12979}, {6280, 12662}, {6290, 12677}},
    {{4977, 11433}, {6026, 12184}, {5760, 11918}, {5400, 11544}, {5522, 11666}, {6092, 12290}, {6144, 12288}, {6144, 12288}},
    {{4532, 13522}, {7614, 16627}, {7701, 16656}, {7612, 16666}, {7737, 16659}, {8604, 17760}, {8858, 17743}, {8870, 17753}},
    {{7477, 21201}, {13187, 27400}, {9968, 23651}, {9524, 23206}, {9606, 23293}, {12976, 27628}, {13629, 27324}, {13641, 27336}},
    {{3950, 9058}, {4959, 10098}, {4496, 9590}, {3959, 9054}, {4332, 9425}, {4885, 10061}, {5017, 10113}, {5041, 10138}},
    {{2062, 4284}, {2188, 4392}, {2160, 4381}, {2183, 4424}, {2172, 4372}, {1513, 3714}, {2185, 4485}, {2198, 4396}},
    {{3068, 6895}, {3138, 6688}, {3112, 6596}, {3030, 6595}, {3046, 6331}, {1977, 5138}, {3091, 6484}, {3155, 6311}},
    {{934, 1874}, {940, 1880}, {936, 1876}, {940, 1880}, {940, 1880}, {936, 1879}, {940, 1880}, {940, 1880}},
    {{1430, 6481}, {1587, 6640}, {1552, 6603}, {1423, 6474}, {1423, 6474}, {1858, 6909}, {1824, 6875}, {1824, 6875}},
    // clang-format on
};

/// Of each method, the counts of scenes that were drawn from the world.
using Sample = std::array<std::vector<Counts>, kMethodCount>;

/// Pooled F of each method over the whole world.
std::array<double, kMethodCount> true_f() {
    std::array<Counts, kMethodCount> sums{};
    for (const auto& scene : kWorld) {
        for (std::size_t m = 0; m < kMethodCount; ++m)
            sums[m] += scene[m];
    }
    std::array<double, kMethodCount> f{};
    for (std::size_t m = 0; m < kMethodCount; ++m)
        f[m] = sums[m].f();
    return f;
}

/// How many of so many intervals hold.
struct Coverage {
    int held = 0;
    int all = 0;

    void add(const std::optional<Interval>& interval, double truth) {
        held += interval->low <= truth && truth <= interval->high ? 1 : 0;
        ++all;
    }
    [[nodiscard]] double percent() const { return 100.0 * held / all; }
};

class KnownCoverage : public testing::TestWithParam<int> {};

TEST_P(KnownCoverage, IsTheLowerOfWhatIntervalsOfFAndOfPairsHold) {
    constexpr int kSamples = 120;
    const std::array<double, kMethodCount> truth = true_f();
    std::mt19937_64 random(5);
    Coverage of_f, of_pairs;
    for (int i = 0; i < kSamples; ++i) {
        Sample sample;
        for (int n = 0; n < GetParam(); ++n) {
            const auto& scene = kWorld[random() % std::size(kWorld)];
            for (std::size_t m = 0; m < kMethodCount; ++m)
                sample[m].push_back(scene[m]);
        }
        const BootstrapOptions options{.resamples = 400, .seed = static_cast<std::uint64_t>(i)};
        for (std::size_t a = 0; a < kMethodCount; ++a) {
            of_f.add(f_interval(sample[a], options), truth[a]);
            for (std::size_t b = 0; b < a; ++b)
                of_pairs.add(paired_interval(sample[a], sample[b], options), truth[a] - truth[b]);
        }
    }
    const double held_percent = std::min(of_f.percent(), of_pairs.percent());
    EXPECT_NEAR(held_percent, known_coverage_percent(GetParam()), 6)
        << "\"about\", as it is printed";
}

INSTANTIATE_TEST_SUITE_P(Scenes, KnownCoverage, testing::Values(6, 16, 36));

}  // namespace
}  // namespace ink::statistics
