#pragma once

#include <graze/bvh/error.h>

namespace graze::cli {

/// Arguments or pose files that cannot be used; what() names the option or the file and line.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze::cli
