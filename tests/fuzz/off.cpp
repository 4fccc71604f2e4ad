// Any file gives a sound scene or an Error to the reader of OFF.

#include "import/meshes/mesh_readers.h"
#include "tests/fuzz/mesh_reader.h"

namespace ink::fuzz {

void check_off(Bytes bytes) {
    check_mesh_reader(import::read_off, bytes);
}

}  // namespace ink::fuzz
