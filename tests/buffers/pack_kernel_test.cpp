#include "buffers/pack_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/simd.h"
#include "method/depth_code.h"

namespace ink::buffers {
namespace {

constexpr int kCount = 67;  // no multiple of a vector

struct Setting {
    std::vector<PackField> fields;
    PackRules rules;
    bool renormalise;
};

std::vector<Setting> settings() {
    const PackField sum{.depth = 100, .normal = {63, 63, 63}, .bits = 8, .shift = 0};
    const PackField depth{.depth = 255, .normal = {}, .bits = 8, .shift = 8};
    const PackField wide{.depth = 30000, .normal = {9000, 20000, 9000}, .bits = 16, .shift = 0};
    std::vector<Setting> result;
    for (const std::vector<PackField>& fields :
         std::vector<std::vector<PackField>>{{sum}, {sum, depth}, {wide}}) {
        for (int bits = 0; bits < 16; ++bits)
            result.push_back(
                {fields, {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}, (bits & 8) != 0});
    }
    return result;
}

/// One pixel after the other, as the pages of the methods have it.
template <class T>
std::vector<T> packed_plainly(const Setting& setting, const PixelRow& row) {
    std::vector<T> codes;
    for (int x = 0; x < row.count; ++x) {
        if (row.depth[x] == method::kNothingDrawn) {
            codes.push_back(static_cast<T>(row.sky));
            continue;
        }
        float n[3] = {row.nx[x], row.ny[x], row.nz[x]};
        const float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        if (row.renormalise && square > 0) {
            for (float& component : n)
                component *= 1 / std::sqrt(square);
        }
        int code = 0;
        for (const PackField& field : setting.fields) {
            const float d = setting.rules.is_near_high ? row.depth[x] : 1 - row.depth[x];
            float terms[4] = {field.depth * d};
            for (int i = 0; i < 3; ++i)
                terms[i + 1] = field.normal[i] * (n[i] + 1) * 0.5F;
            for (float& term : terms)
                term = setting.rules.rounds_each ? std::floor(term + 0.5F) : term;
            const float sum = terms[0] + terms[1] + terms[2] + terms[3];
            const long whole = static_cast<long>(std::floor(sum + 0.5F));
            const long most = (1L << field.bits) - 1;
            const long kept = setting.rules.wraps ? whole & most : std::clamp(whole, 0L, most);
            code |= static_cast<int>(kept) << field.shift;
        }
        codes.push_back(static_cast<T>(code));
    }
    return codes;
}

template <class T>
void expect_plain_codes(const Setting& setting, const PixelRow& row) {
    const std::vector<T> expected = packed_plainly<T>(setting, row);
    for (const core::SimdTarget& target : core::simd_targets()) {
        const core::ForcedSimdTarget forced(target);
        std::vector<T> codes(static_cast<std::size_t>(row.count) + 1, T{99});
        pack_pixels(setting.fields, setting.rules, row, codes.data());
        EXPECT_EQ(codes.back(), 99) << target.name;
        codes.pop_back();
        EXPECT_EQ(codes, expected) << target.name << ", " << row.count << " pixels";
    }
}

TEST(PackPixels, AreThePlainFormulasOnEveryTarget) {
    std::mt19937 random(5);
    std::vector<float> channels[4];
    for (int i = 0; i < kCount; ++i) {
        channels[0].push_back(i % 9 == 4 ? method::kNothingDrawn
                                         : std::uniform_real_distribution<float>(-1, 2)(random));
        for (int k = 1; k < 4; ++k)
            channels[k].push_back(
                i % 13 == 7 ? 0 : std::uniform_real_distribution<float>(-1.5F, 1.5F)(random));
    }
    for (const Setting& setting : settings()) {
        for (const int count : {0, 1, 7, 16, 48, kCount}) {
            const PixelRow row{channels[0].data(),
                               channels[1].data(),
                               channels[2].data(),
                               channels[3].data(),
                               count,
                               setting.renormalise,
                               17};
            if (setting.fields.size() == 1 && setting.fields.front().bits == 8)
                expect_plain_codes<std::uint8_t>(setting, row);
            expect_plain_codes<std::uint16_t>(setting, row);
        }
    }
}

}  // namespace
}  // namespace ink::buffers
