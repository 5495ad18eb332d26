#pragma once

#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/work.h>

#include <cstddef>
#include <string>

namespace graze::cli {

/// What `graze motion` found of one stretch.
struct MotionAnswer {
  std::size_t number = 0;  ///< of the stretch, from 0
  RigidContact contact;
  Pose pose_b;              ///< of B at the witness, where there is one
  std::string certificate;  ///< the file that holds the proof; empty: none
  std::string picture;      ///< the file that shows the contact; empty: none
  Work work;
};

/// One JSON object on one line.
std::string to_json(const MotionAnswer& answer);

/// The titles of the table for people, and one of its rows.
std::string motion_header();
std::string to_text(const MotionAnswer& answer);

}  // namespace graze::cli
