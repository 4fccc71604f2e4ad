// Any file gives a sound scene or an Error to the reader of STL.

#include "import/meshes/mesh_readers.h"
#include "tests/fuzz/mesh_reader.h"

namespace ink::fuzz {

void check_stl(Bytes bytes) {
    check_mesh_reader(import::read_stl, bytes);
}

}  // namespace ink::fuzz
