#pragma once

#include <string>
#include <string_view>

#include "import/scene_stream.h"
#include "tests/fuzz/fuzz.h"

namespace ink::fuzz {

using MeshReader = import::ImportReply (*)(std::string_view, const std::string&);

/// Throws BrokenLaw unless `read` makes an Error or a sound scene of any bytes, takes no more from
/// them than they hold, and takes a text the same whether its lines end with LF or with CR LF.
void check_mesh_reader(MeshReader read, Bytes bytes);

}  // namespace ink::fuzz
