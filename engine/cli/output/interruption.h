#pragma once

#include <csignal>

#include <graze/bvh/error.h>

namespace graze::cli {

/// Thrown when a run was stopped by its user, with a record of what is done; what() says how to
/// go on.
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// While it lives the first SIGINT ends nothing, but can be asked about; a second one does what it
/// did before: it ends the program. Where the signal is ignored, as in the background of a script,
/// it stays so. There may be one at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  static bool is_requested();

 private:
  struct sigaction before_;
};

}  // namespace graze::cli
