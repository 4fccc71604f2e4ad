#pragma once

#include "import/byte_stream.h"
#include "scene/animation.h"

namespace ink::import {

void write_animation(const scene::Animation& animation, ByteWriter& writer);

/// What write_animation wrote; anything at all where the reader fails. Nothing in it is checked but
/// that it is there.
[[nodiscard]] scene::Animation read_animation(ByteReader& reader);

}  // namespace ink::import
