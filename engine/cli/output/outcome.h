#pragma once

#include <graze/bvh/error.h>

namespace graze::cli {

/// Lists what the command tells its caller. The help text and the README promise these numbers.
enum class ExitCode {
  Answered = 0,    ///< an answer was given, whatever it is
  GrazeWrong = 1,  ///< a check was asked for, and the referee overruled graze
  Failed = 1,    ///< the same number: a wrong answer that --fail-on names, no proof, a faulty mesh
  BadInput = 2,  ///< no answer: usage, meshes, poses, memory or output; one line on stderr says why
  Interrupted = 130,  ///< SIGINT ended the run: what is done is in the file of --resume
};

/// Thrown for arguments that cannot be used; what() names the option.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze::cli
