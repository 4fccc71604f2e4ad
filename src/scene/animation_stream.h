#pragma once

#include "scene/animation.h"
#include "scene/byte_stream.h"

namespace ink::scene {

void write_animation(const Animation& animation, ByteWriter& writer);

/// What write_animation wrote; anything at all where the reader fails. Nothing in it is checked but
/// that it is there.
[[nodiscard]] Animation read_animation(ByteReader& reader);

}  // namespace ink::scene
