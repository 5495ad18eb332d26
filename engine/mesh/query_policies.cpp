#include <graze/bvh/error.h>
#include <graze/engine/mesh/query_policies.h>
#include <string>

namespace graze {

void require_touch_included(const QuerySettings& settings, const char* query) {
  if (settings.touch == Touch::Include) return;
  throw InputError(std::string(query) + ": touch must be Touch::Include");
}

}  // namespace graze
