#pragma once

#include <graze/bvh/error.h>
#include <graze/engine/cases/text/json_cursor.h>

namespace graze::cases {

/// Calls `make()` and gives its error the place that the cursor stands at.
template <typename Make>
auto at_place(const JsonCursor& at, Make&& make) {
  try {
    return make();
  } catch (const Error& error) {
    at.fail(error.what());
  }
}

}  // namespace graze::cases
