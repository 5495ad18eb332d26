#pragma once

#include <graze/bvh/error.h>

namespace graze {

/// A case file that cannot be read: what() reads `file:line: /place/in/it: why`.
class CaseError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
