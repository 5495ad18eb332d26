#include <graze/engine/version.h>

namespace graze {

// The numbers stand in version.h alone, which CMake reads.
const char* library_version() {
  return GRAZE_VERSION;
}

}  // namespace graze
