#include <graze/bvh/error.h>
#include <graze/engine/mesh/query/query_policies.h>
#include <string>

namespace graze {

void require_touch_included(const QuerySettings& settings, const char* query) {
  if (settings.touch == Touch::Include) return;
  throw InputError(std::string(query) + ": touch must be Touch::Include");
}

void require_surface(const QuerySettings& settings, const char* query) {
  if (settings.interior == Interior::Surface) return;
  throw InputError(std::string(query) + ": interior must be Interior::Surface");
}

}  // namespace graze
