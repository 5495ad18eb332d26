#pragma once

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <string>

namespace graze::cli {

/// Holds what `graze motion` found of one stretch.
struct MotionAnswer {
  std::size_t number = 0;  ///< the number of the stretch, from 0
  RigidContact contact;
  Pose pose_b;              ///< the pose of B at the witness, where there is one
  std::string certificate;  ///< the file that holds the proof; empty for none
  std::string picture;      ///< the file that shows the contact; empty for none
  Work work;
};

/// Returns one JSON object on one line.
std::string to_json(const MotionAnswer& answer);

/// Return the titles of the table for people, and one of its rows.
std::string motion_header();
std::string to_text(const MotionAnswer& answer);

}  // namespace graze::cli
