#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace graze {

/// Where in its input an error lies, as far as that is known. Error::what() says the same in words;
/// this is for programs.
struct ErrorPlace {
  std::string file = {};                  ///< as it was named; empty if no file is to blame
  std::optional<std::size_t> line = {};   ///< of a text file, counted from 1
  std::optional<std::size_t> byte = {};   ///< of a binary file, counted from 0
  std::string element = {};               ///< "vertex", "triangle", "pose", ...; empty if none
  std::optional<std::size_t> index = {};  ///< of that element, counted from 0

  bool operator==(const ErrorPlace&) const = default;
};

/// Everything that graze throws derives from this, but for what the standard library throws when
/// memory is short. what() is one line that names the place. A copy shares the place: copying does
/// not throw.
class Error : public std::runtime_error {
 public:
  /// `what` is the line for people, `place` the same for programs.
  explicit Error(const std::string& what, ErrorPlace place = {});

  /// Where it lies; empty members are not known.
  const ErrorPlace& place() const noexcept;

 private:
  std::shared_ptr<const ErrorPlace> place_;  ///< null where nothing is known
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

/// A mesh that cannot be: what() reads `file:line: why`, `file: byte N: why`, `file: why`, or
/// `triangle 12: why` for a mesh made from arrays.
class MeshError : public Error {
 public:
  using Error::Error;
};

/// An id of what was removed, or which was never given out, or only by another world.
class StaleIdError : public Error {
 public:
  using Error::Error;
};

/// Two shapes of kinds for which a question has no answer; what() names both.
class UnsupportedPairError : public Error {
 public:
  using Error::Error;
};

/// A batch that was asked to stop before all was done. There is no answer: what is done is lost.
class StoppedError : public Error {
 public:
  /// So many elements were done, of so many.
  StoppedError(std::size_t done, std::size_t total);

  /// How many elements were done.
  std::size_t done() const noexcept { return done_; }
  /// How many there were.
  std::size_t total() const noexcept { return total_; }

 private:
  std::size_t done_;
  std::size_t total_;
};

/// A case file that cannot be read: what() reads `file:line: /place/in/it: why`.
class CaseError : public Error {
 public:
  using Error::Error;
};

/// A scene that cannot be read: what() reads `file:line: /place/in/it: why`.
class SceneError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
