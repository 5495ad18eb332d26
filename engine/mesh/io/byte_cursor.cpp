#include <graze/engine/mesh/io/byte_cursor.h>
#include <string>

namespace graze::mesh_io {

void ByteCursor::fail_short(std::string_view what) const {
  fail("the file ends within " + std::string(what));
}

}  // namespace graze::mesh_io
