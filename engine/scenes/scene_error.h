#pragma once

#include <graze/bvh/error.h>

namespace graze {

/// A scene that cannot be read: what() reads `file:line: /place/in/it: why`.
class SceneError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
