#include "core/simd.h"

#include <fmt/format.h>
#include <hwy/highway.h>

namespace ink::core {
namespace {

/// Highway's fallback is EMU128 where the compiler can be trusted with it (g++ 12.3 and later),
/// else SCALAR: here both have the one name.
SimdTarget with_name(std::int64_t bit) {
    return {bit, hwy::TargetName(bit == HWY_EMU128 ? HWY_SCALAR : bit)};
}

}  // namespace

std::vector<SimdTarget> simd_targets() {
    std::vector<SimdTarget> targets;
    for (const std::int64_t bit : hwy::SupportedAndGeneratedTargets())
        targets.push_back(with_name(bit));
    return targets;
}

SimdTarget current_simd_target() {
    return simd_targets().front();
}

std::string highway_version() {
    return fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH);
}

ForcedSimdTarget::ForcedSimdTarget(const SimdTarget& target) {
    hwy::SetSupportedTargetsForTest(target.bit);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

ForcedSimdTarget::~ForcedSimdTarget() {
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace ink::core
