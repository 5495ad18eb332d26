#pragma once

#include <graze/bvh/error.h>

namespace graze::cli {

/// Arguments that cannot be used; what() names the option.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze::cli
