// Any file gives a sound scene or an Error to the reader of PLY.

#include "import/meshes/mesh_readers.h"
#include "tests/fuzz/mesh_reader.h"

namespace ink::fuzz {

void check_ply(Bytes bytes) {
    check_mesh_reader(import::read_ply, bytes);
}

}  // namespace ink::fuzz
