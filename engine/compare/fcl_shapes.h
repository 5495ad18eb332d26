#pragma once

// Holds shapes of all kinds as FCL does. No type of FCL appears here.

#include <memory>
#include <optional>
#include <vector>

#include <graze/bvh/pose.h>
#include <graze/engine/compare/fcl_engine.h>
#include <graze/engine/world/shape.h>

namespace graze::compare {

/// Holds a shape of FCL's own, made once for many poses. Many threads may query it at once.
class FclShape {
 public:
  explicit FclShape(const Shape& shape);
  ~FclShape();
  FclShape(FclShape&&) noexcept;

 private:
  struct Geometry;
  friend std::optional<bool> intersects(const FclShape&, const Pose&, const FclShape&, const Pose&);
  friend std::optional<double> distance(const FclShape&, const Pose&, const FclShape&, const Pose&);
  friend std::optional<std::vector<FclContact>> find_contacts(const FclShape&, const Pose&,
                                                              const FclShape&, const Pose&);
  std::unique_ptr<const Geometry> geometry_;
};

/// True if FCL has a function for two such shapes. It has none for two half-spaces or planes, and
/// for a hull and a plane it calls one that is not there.
bool fcl_knows(ShapeKind a, ShapeKind b);

/// Returns FCL's answer by its default solver, and nothing for two half-spaces or planes, which it
/// does not know, or for a hull and a plane, with which it crashes.
std::optional<bool> intersects(const FclShape& shape_a, const Pose& pose_a, const FclShape& shape_b,
                               const Pose& pose_b);

/// Returns FCL's distance by its default solver; below 0 FCL says that they meet. Returns nothing
/// for half-spaces and planes, whose distances it does not know, and where it finds none.
std::optional<double> distance(const FclShape& shape_a, const Pose& pose_a, const FclShape& shape_b,
                               const Pose& pose_b);

/// Returns FCL's contacts, with the depth that its solver finds, and nothing where intersects()
/// does.
std::optional<std::vector<FclContact>> find_contacts(const FclShape& shape_a, const Pose& pose_a,
                                                     const FclShape& shape_b, const Pose& pose_b);

}  // namespace graze::compare
