#include "buffers/code_layout.h"

#include <gtest/gtest.h>

#include <array>

#include "buffers/packed_buffer.h"
#include "methods/registry.h"

namespace ink::buffers {
namespace {

using raster::Overflow;

const Field kSum{.ranges = {.depth = 63, .normal = {63, 63, 63}}};

template <class T>
int packed(const Packer& packer, float depth, std::array<float, 3> n) {
    T code = 0;
    packer.pack_row<T>(0, {&depth, &n[0], &n[1], &n[2], 1, false, 17}, &code);
    return code;
}

TEST(Packer, SumsTheRangesOfItsChannels) {
    const Packer packer(
        {raster::Store::u8, 1, {kSum}}, DepthSign::near_high, Quantise::sum, Overflow::saturate);
    EXPECT_EQ(packer.at_vertex(0, 1, {1, 1, 1}), 4 * 63 + 0.5);
    EXPECT_EQ(packer.at_vertex(0, 0, {-1, -1, -1}), 0.5);
    EXPECT_EQ(packer.at_vertex(0, 0.5, {0, 0, 1}), 31.5 * 3 + 63 + 0.5);
    EXPECT_EQ(packed<std::uint8_t>(packer, 0.5F, {0, 0, 1}), 158);  // 157.5, rounded
}

TEST(Packer, OffsetKeepsNegativeRangesInTheByte) {
    const Field field{.ranges = {.depth = 100, .normal = {-80, 0, 75}, .offset = 80}};
    const Packer packer(
        {raster::Store::u8, 1, {field}}, DepthSign::near_high, Quantise::sum, Overflow::saturate);
    EXPECT_EQ(packer.at_vertex(0, 0, {1, 0, -1}), 0.5);
    EXPECT_EQ(packer.at_vertex(0, 1, {-1, 0, 1}), 255.5);
    EXPECT_EQ(packed<std::uint8_t>(packer, 0, {1, 0, -1}), 0);
    EXPECT_EQ(packed<std::uint8_t>(packer, 1, {-1, 0, 1}), 255);
}

TEST(Packer, FarHighTurnsDepthRound) {
    const Packer packer(
        {raster::Store::u8, 1, {kSum}}, DepthSign::far_high, Quantise::sum, Overflow::saturate);
    EXPECT_EQ(packed<std::uint8_t>(packer, 1, {-1, -1, -1}), 0);
    EXPECT_EQ(packed<std::uint8_t>(packer, 0, {-1, -1, -1}), 63);
}

TEST(Packer, EachRoundsBeforeItSums) {
    const CodeLayout layout{raster::Store::u8, 1, {kSum}};
    const Packer once(layout, DepthSign::near_high, Quantise::sum, Overflow::saturate);
    const Packer apart(layout, DepthSign::near_high, Quantise::each, Overflow::saturate);
    // Every channel at 31.4: 125.6 as a sum, 4 x 31 apart.
    const float d = 31.4F / 63;
    const float n = 2 * d - 1;
    EXPECT_EQ(packed<std::uint8_t>(once, d, {n, n, n}), 126);
    EXPECT_EQ(packed<std::uint8_t>(apart, d, {n, n, n}), 124);
}

TEST(Packer, BitFieldsStandSideBySide) {
    const Field depth{.ranges = {.depth = 255}, .shift = 8, .bits = 8};
    const Field normal{.ranges = {.normal = {85, 85, 85}}, .shift = 0, .bits = 8};
    const CodeLayout layout{raster::Store::u16, 1, {depth, normal}};
    const Packer packer(layout, DepthSign::near_high, Quantise::sum, Overflow::saturate);
    EXPECT_EQ(packed<std::uint16_t>(packer, 1, {-1, -1, -1}), 0xff00);
    EXPECT_EQ(packed<std::uint16_t>(packer, 0, {1, 1, 1}), 0x00ff);
    EXPECT_EQ(packed<std::uint16_t>(packer, 2, {3, 3, 3}), 0xffff);
    EXPECT_EQ(packer.at_vertex(0, 1, {-1, -1, 1}), 0xff55 + 0.5);
}

TEST(LinearCode, IsDeclaredByTheSumsAlone) {
    const auto code_of = [](const std::string& method, const core::ParamValues& values) {
        return methods::find_method(method).make(values)->code();
    };
    const auto mote2 = code_of("mote2", {{"depth_encoding", "log"}});
    ASSERT_TRUE(mote2);
    EXPECT_EQ(mote2->encoding, raster::DepthEncoding::log);
    EXPECT_EQ(mote2->depth_weight, 127);
    EXPECT_EQ(mote2->normal_weight[0], 0);
    EXPECT_EQ(mote2->normal_weight[2], 127);
    EXPECT_EQ(mote2->bits, 8);

    const auto mote16 = code_of("mote16", {{"depth_sign", "far_high"}, {"overflow", "wrap"}});
    ASSERT_TRUE(mote16);
    EXPECT_EQ(mote16->depth_weight, -16383);
    EXPECT_EQ(mote16->bits, 16);
    EXPECT_TRUE(mote16->wraps);
    EXPECT_EQ(mote16->response.scale_bits, -6);

    EXPECT_TRUE(code_of("mote4", {}));
    EXPECT_FALSE(code_of("mote4", {{"quantise", "each"}}));
    EXPECT_FALSE(code_of("mote2", {{"combine", "separate"}}));
    EXPECT_FALSE(code_of("mote16", {{"layout", "8+8"}}));
    EXPECT_FALSE(code_of("decaudin", {}));
}

}  // namespace
}  // namespace ink::buffers
