#pragma once

#include <stdexcept>

namespace graze {

/// Everything that graze throws derives from this; what() is one line that names the place.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value that no query can answer for: NaN, infinity, a box whose minimum exceeds its maximum.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A pose that is not rigid, not finite, moves a mesh out of the range of double, or cannot be
/// read.
class PoseError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
