#pragma once

#include <cstdint>

namespace graze::record {

/// Names what begins each change in an update's block. Behind it stands how far the body's index is
/// from that of the change before, but for those without a body.
enum class ChangeKind : std::uint8_t {
  End = 0,    ///< there are no more changes; no body
  Moved = 1,  ///< it is about the body with the next index; no body is named
  MovedElse = 2,
  Added = 3,
  Removed = 4,
  Taken = 5,
  Reshaped = 6,
  Filter = 7,
  Kind = 8,
  Role = 9,
  Margin = 10,
  Detection = 11,
  UserData = 12,
  Slept = 13,
  Woken = 14,
  Excluded = 15,   ///< the other body follows
  Included = 16,   ///< the other body follows
  FilterSet = 17,  ///< no body
  FilterGone = 18,
  Named = 19,
  Restored = 20  ///< no body
};

}  // namespace graze::record
