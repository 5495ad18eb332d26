#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace graze {

/// Says where in its input an error lies, as far as that is known. Error::what() says the same in
/// words; this is for programs.
struct ErrorPlace {
  std::string file = {};                  ///< its name as it was given; empty if no file is to
                                          ///< blame
  std::optional<std::size_t> line = {};   ///< the line of a text file, counted from 1
  std::optional<std::size_t> byte = {};   ///< the place in a binary file, counted from 0
  std::string element = {};               ///< "vertex", "triangle", "pose", ...; empty if none
  std::optional<std::size_t> index = {};  ///< the number of that element, counted from 0

  bool operator==(const ErrorPlace&) const = default;
};

/// Everything that graze throws derives from this, but for what the standard library throws when
/// memory is short. what() is one line that names the place. A copy shares the place: copying does
/// not throw.
class Error : public std::runtime_error {
 public:
  /// Takes `what`, the line for people, and `place`, the same for programs.
  explicit Error(const std::string& what, ErrorPlace place = {});

  /// Returns where the error lies; empty members are not known.
  const ErrorPlace& place() const noexcept;

 private:
  std::shared_ptr<const ErrorPlace> place_;  ///< null where nothing is known
};

/// Thrown for a value that no query can answer for: NaN, infinity, a box whose minimum exceeds its
/// maximum.
class InputError : public Error {
 public:
  using Error::Error;
};

/// Thrown for a pose that is not rigid, not finite, moves a mesh out of the range of double, or
/// cannot be read.
class PoseError : public Error {
 public:
  using Error::Error;
};

/// Thrown for a mesh that cannot be: what() reads `file:line: why`, `file: byte N: why`, `file:
/// why`, or `triangle 12: why` for a mesh made from arrays.
class MeshError : public Error {
 public:
  using Error::Error;
};

/// Thrown for an id of what was removed, or which was never given out, or only by another world.
class StaleIdError : public Error {
 public:
  using Error::Error;
};

/// Thrown for two shapes of kinds for which a question has no answer; what() names both.
class UnsupportedPairError : public Error {
 public:
  using Error::Error;
};

/// Thrown by a batch that was asked to stop before all was done. There is no answer: what is done
/// is lost.
class StoppedError : public Error {
 public:
  /// Says that `done` of `total` elements were done.
  StoppedError(std::size_t done, std::size_t total);

  /// Returns how many elements were done.
  std::size_t done() const noexcept { return done_; }
  /// Returns how many elements there were.
  std::size_t total() const noexcept { return total_; }

 private:
  std::size_t done_;
  std::size_t total_;
};

/// Thrown for a case file that cannot be read: what() reads `file:line: /place/in/it: why`.
class CaseError : public Error {
 public:
  using Error::Error;
};

/// Thrown for a scene that cannot be read: what() reads `file:line: /place/in/it: why`.
class SceneError : public Error {
 public:
  using Error::Error;
};

}  // namespace graze
