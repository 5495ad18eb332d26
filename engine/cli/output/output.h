#pragma once

#include <graze/bvh/error.h>

#include <cstdio>
#include <string_view>

namespace graze::cli {

/// Thrown if standard output could not be written: a full disk, for example.
class OutputError : public Error {
 public:
  using Error::Error;
};

/// Thrown if whoever read the output has closed it, as `head` does: no failure, but no use going
/// on.
class OutputClosed {};

/// A stream whose reader sees each piece of text at once.
class Output {
 public:
  /// Keeps the stream, which must outlive it.
  explicit Output(std::FILE* stream) : stream_(stream) {}

  /// Writes and flushes. Throws OutputClosed or OutputError.
  void write(std::string_view text);

 private:
  std::FILE* stream_;
};

/// Takes the numbers of standard input, output and error where the caller has closed them. Else the
/// next file that is opened would get one, and whatever the program, or a library, says would be
/// written into it. What is written to such a stream fails, as it does to a closed one.
void reserve_standard_streams();

}  // namespace graze::cli
