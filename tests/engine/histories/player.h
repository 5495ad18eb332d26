#pragma once

#include <optional>
#include <string>

#include "tests/engine/histories/history.h"

namespace graze::tests {

/// What a world that is not told of something would say: for tests of the tests.
enum class Fault {
  None,
  DeafToFilters,
  DeafToShapes,
  DeafToSleep,
  DeafToParts,
  DeafToMargins,
  DeafToDetection
};

struct Failure {
  std::size_t at = 0;  // the operation
  std::string what;
};

/// What was seen on the way, so that a test can tell that something was.
struct Sights {
  std::size_t updates = 0, begun = 0, ended = 0, contacts = 0, answers = 0, restored = 0;
  std::size_t part_contacts = 0;  // of two parts, or of one and a body
  std::size_t begun_near = 0, contacts_apart = 0, casts = 0;
  std::size_t first_contacts = 0, later_first_contacts = 0;  // all, and those after 0
  std::size_t part_first_contacts = 0;
  std::uint64_t pairs_apart = 0, pairs_at_rest = 0;
};

/// Plays a history to several worlds, which differ in what no answer may depend on: what they skip,
/// whether they find contacts, how many threads they have, in which order bodies come. After each
/// update all is compared with the oracle, contacts bit for bit; questions at any time. Operations
/// on bodies that are not there are passed over, so that any part of a history is a history.
std::optional<Failure> play(const History& history, Sights* sights = nullptr,
                            Fault fault = Fault::None);

/// The history without all operations that it fails without, if it fails: with some other word, it
/// may be. Delta debugging (Zeller and Hildebrandt 2002).
History shrunk(History history, Fault fault = Fault::None);

/// Writes a failing history, shrunk, into the folder of failed cases, and says so and how to play
/// it again. Returns the path.
std::string keep(const History& history, const std::string& name);

}  // namespace graze::tests
