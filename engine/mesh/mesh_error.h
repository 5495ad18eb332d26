#pragma once

#include <graze/bvh/error.h>

namespace graze {

/// A mesh that cannot be: what() reads `file:line: why`, `file: byte N: why`, `file: why`, or
/// `triangle 12: why` for a mesh made from arrays.
class MeshError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
