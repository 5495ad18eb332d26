#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/mesh/mesh.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace graze::stress {

/// A nut that turns on its bolt, two turns down and up again and so on, by a rotation that is held
/// in float and multiplied onto the last one, as a simple simulation does: it drifts from a
/// rotation by about 1e-7 a step, until the door refuses it (law 10) and it is made a rotation
/// again.
class TurningNut {
 public:
  TurningNut();

  /// The next pose that the door lets in.
  Pose next();

  std::size_t renormalised() const { return renormalised_; }
  double largest_deviation() const { return largest_deviation_; }

 private:
  Pose pose() const;

  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  double angle_ = 0;
  double direction_ = -1;
  std::size_t renormalised_ = 0;
  double largest_deviation_ = 0;
};

struct TurningReport {
  std::size_t steps = 0;          ///< each with a query of a piece of the nut, or of all of it
  std::size_t whole = 0;          ///< of these, queries of the whole nut
  std::size_t renormalised = 0;   ///< how often the door asked for it
  double largest_deviation = 0;   ///< of a pose that was let in
  std::size_t hits = 0;           ///< of graze: each is wrong, the thread is clear
  std::size_t spot_checks = 0;    ///< poses judged by all near pairs and the referee
  std::size_t spot_wrong = 0;     ///< of graze's answers to these
  std::size_t shifted_wrong = 0;  ///< of its answers when the nut is pushed into the flanks there
};

/// Turns the bundled nut on the bundled bolt, asking at each step whether they touch, on as many
/// threads as there are processors, and judging `spot_checks` steps. The nut is cut into pieces
/// around its axis, whose turns come one after the other: a million queries take minutes.
TurningReport turn_nut(const std::filesystem::path& data, std::size_t steps,
                       std::size_t spot_checks);

}  // namespace graze::stress
