#pragma once

// What some queries cannot be asked. Private to engine/mesh.

#include <graze/engine/mesh/pair.h>

namespace graze {

/// Throws InputError, which begins with `query`, unless touching counts: the query would ignore the
/// policy.
void require_touch_included(const QuerySettings& settings, const char* query);

/// Throws InputError, which begins with `query`, unless only the surface is asked for.
void require_surface(const QuerySettings& settings, const char* query);

}  // namespace graze
