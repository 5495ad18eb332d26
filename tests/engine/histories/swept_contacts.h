#pragma once

// Motions of bodies part by part: what a world that sweeps or casts should say, by asking every
// part about every other, alone and in no tree.

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/world_update.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/engine/histories/oracle.h"

namespace graze::tests {

/// A shape and its motion.
struct MovedShape {
  const Shape& shape;
  RigidMotion motion;
};

/// first_contact(), which is asked only of what comes near enough: no point of either goes farther
/// than a bound. Nothing where motions or the pair are refused.
std::optional<RigidContact> contact_in_motion(const MovedShape& a, const MovedShape& b,
                                              const RigidContactSettings& settings);

/// Where a part goes whose body takes a motion, starting from its own place.
RigidMotion motion_of_part(const RigidMotion& body, const Pose& start);

/// What an update lists of a named pair, A being the one with the smaller name.
struct NamedFirstContact {
  NamePair pair;
  BodyFirstContact contact;  // its ids mean nothing
  bool is_alike = false;     // of one shape in one place: nothing tells A from B
};

/// By pairs of names, then by time, then by parts.
void sort_by_name(std::vector<NamedFirstContact>& contacts);
bool are_equal(const NamedFirstContact& found, const NamedFirstContact& truth);
std::string told(const NamedFirstContact& contact);

/// All that bodies which are swept, and moved since the last update, come to.
std::vector<NamedFirstContact> all_first_contacts(const Oracle& oracle,
                                                  const WorldSettings& settings);

}  // namespace graze::tests
