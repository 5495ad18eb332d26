#pragma once

#include <memory>
#include <string>

#include <graze/engine/mesh/mesh.h>
#include <graze/engine/mesh/rigid_contact.h>
#include <graze/engine/mesh/rigid_motion.h>

namespace graze::cli {

/// Says what a page of motions is about.
struct MotionPageSettings {
  std::string title;
  std::string name_a, name_b;  ///< the names of the meshes, as they are shown
  std::size_t motions = 1;  ///< the number of motions to come: each of many is shown at fewer times
};

/// Makes a page of a mesh that moves past another: pictures along each motion, at even times, and
/// where the answer says that they meet.
class MotionPage {
 public:
  virtual ~MotionPage() = default;

  /// Adds a motion of B, and what was answered. Throws what its queries throw.
  virtual void add(const RigidMotion& motion, const RigidContact& contact) = 0;

  /// Returns the whole page.
  virtual std::string text() const = 0;
};

/// Makes such a page. Throws UsageError where the command was built without pages.
std::unique_ptr<MotionPage> make_motion_page(const Mesh& mesh_a, const Pose& pose_a,
                                             const Mesh& mesh_b,
                                             const MotionPageSettings& settings);

}  // namespace graze::cli
