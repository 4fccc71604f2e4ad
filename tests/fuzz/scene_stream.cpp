// Any bytes are a reply that becomes a sound scene, or an Error, or no reply.

#include "import/scene_stream.h"

#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

void check_scene_stream(Bytes bytes) {
    const auto reply = import::read_reply(std::as_bytes(bytes));
    if (reply) expect_scene_or_error(*reply);
}

}  // namespace ink::fuzz
