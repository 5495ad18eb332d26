#pragma once

#include <graze/bvh/error.h>

namespace graze {

/// An id of what was removed, or which was never given out.
class StaleIdError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
