#pragma once

#include <graze/bvh/error.h>

#include <cstdio>
#include <string_view>

namespace graze::cli {

/// Standard output could not be written: a full disk, for example.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// Whoever read the output has closed it, as `head` does: no failure, but no use going on.
class OutputClosed {};

/// A stream on which each piece of text is seen at once by whoever reads it.
class Output {
 public:
  /// `stream` must outlive this.
  explicit Output(std::FILE* stream) : stream_(stream) {}

  /// Writes and flushes. Throws OutputClosed or OutputError.
  void write(std::string_view text);

 private:
  std::FILE* stream_;
};

/// Gives back the numbers of standard input, output and error where the caller has closed them:
/// else the next file that is opened would get one, and have written into it whatever the program,
/// or a library, says. What is written to such a stream fails, as it does to a closed one.
void reserve_standard_streams();

}  // namespace graze::cli
