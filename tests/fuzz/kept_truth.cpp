// Any bytes under the right hash are a truth that is kept as it is, or none; and nothing else is
// thrown, whatever lengths they claim.

#include <algorithm>
#include <string>
#include <string_view>

#include "core/kept_file.h"
#include "harness/truths/compare_truths.h"
#include "tests/fuzz/fuzz.h"
#include "truth/truth_cache.h"

namespace ink::fuzz {
namespace {

constexpr const char* kKey = "key";

void check_truth(std::string_view bytes) {
    const auto truth = truth::decode_truth(bytes, kKey);
    if (!truth) return;
    const std::string kept = truth::encode_truth(*truth, kKey);
    const auto again = truth::decode_truth(kept, kKey);
    expect(again.has_value(), "a truth that was kept can be read");
    expect(truth::encode_truth(*again, kKey) == kept, "a truth is kept as it is");
    expect(!truth::decode_truth(kept, "another key"), "another key is another truth");
}

/// The cross-check of a view is kept beside its truth.
void check_crosscheck(const std::string& text) {
    const auto check = harness::decode_check(text, kKey);
    if (!check) return;
    const std::string kept = harness::encode_check(*check, kKey);
    const auto again = harness::decode_check(kept, kKey);
    expect(again.has_value(), "a cross-check that was kept can be read");
    expect(harness::encode_check(*again, kKey) == kept, "a cross-check is kept as it is");
}

/// `payload` sealed as what is kept in `kept` is.
std::string with_head(const std::string& kept, Bytes payload) {
    core::KeptKind kind{};
    std::copy_n(kept.begin(), kind.size(), kind.begin());
    return core::sealed(
        kind, kKey, {reinterpret_cast<const char*>(payload.data()), payload.size()});
}

}  // namespace

void check_kept_truth(Bytes bytes) {
    const std::string text(bytes.begin(), bytes.end());
    check_truth(text);
    check_truth(with_head(truth::encode_truth({}, kKey), bytes));
    check_crosscheck(text);
    check_crosscheck(with_head(harness::encode_check({}, kKey), bytes));
}

}  // namespace ink::fuzz
