// Any bytes under the right hash are a truth that is kept as it is, or none; and nothing else is
// thrown, whatever lengths they claim.

#include <string>
#include <vector>

#include "core/byte_stream.h"
#include "core/hash.h"
#include "harness/crosscheck/crosscheck_cache.h"
#include "tests/fuzz/fuzz.h"
#include "truth/truth_file.h"

namespace ink::fuzz {
namespace {

constexpr const char* kKey = "key";

/// A head as encode_truth writes it in front of `payload`.
std::vector<std::uint8_t> with_head(Bytes payload) {
    std::vector<std::uint8_t> bytes = truth::encode_truth({}, kKey);
    const std::size_t head_bytes = 8 + 8 + std::string(kKey).size();
    bytes.resize(head_bytes);
    const core::ByteSink sink = [&](const void* data, std::size_t size) {
        const auto* begin = static_cast<const std::uint8_t*>(data);
        bytes.insert(bytes.end(), begin, begin + size);
    };
    core::ByteWriter(sink).parts(core::Hasher().bytes(payload.data(), payload.size()).result(),
                                 static_cast<std::uint64_t>(payload.size()));
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
}

void check_truth(Bytes bytes) {
    const auto truth = truth::decode_truth(bytes, kKey);
    if (!truth) return;
    const std::vector<std::uint8_t> kept = truth::encode_truth(*truth, kKey);
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

/// The same with the head that encode_check writes in front of `payload`.
std::string check_with_head(Bytes payload) {
    constexpr std::size_t kMagicBytes = 8;
    const std::string magic = harness::encode_check({}, kKey).substr(0, kMagicBytes);
    const std::string hash = core::Hasher().bytes(payload.data(), payload.size()).hex();
    return magic + kKey + hash + std::string(payload.begin(), payload.end());
}

}  // namespace

void check_kept_truth(Bytes bytes) {
    check_truth(bytes);
    check_truth(with_head(bytes));
    check_crosscheck({bytes.begin(), bytes.end()});
    check_crosscheck(check_with_head(bytes));
}

}  // namespace ink::fuzz
