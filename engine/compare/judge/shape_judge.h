#pragma once

#include <graze/bvh/pose.h>
#include <graze/engine/compare/judge/judge.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/world/shape.h>

#include <memory>
#include <optional>

namespace graze::compare {

/// Beyond this share of the scale of a pair (their sizes and the distance of their middles) an
/// error about curved shapes is no longer one of tolerance: solvers by support mappings stop at
/// 1e-6.
inline constexpr double kShapeTolerance = 1e-6;

/// Holds a shape in a pose.
struct PlacedBody {
  const Shape& shape;
  const Pose& pose;
};

/// Judges whether two placed shapes intersect, as far as it can be proved.
///
/// The referee decides exactly about two meshes, a mesh and a ball or box, two balls, a ball and a
/// box, and two boxes unless the readings of their poses differ. All others are decided by proof:
/// "apart" by a plane that has both on different sides, "hit" by a point that is in both. The
/// library proposes plane and point; whether they prove anything is computed from what the shapes
/// are. Where neither is proved, as between a cone and the hollow of a mesh, nothing is judged.
class ShapeJudge {
 public:
  /// Keeps shapes and poses, which must outlive it.
  ShapeJudge(const PlacedBody& a, const PlacedBody& b);
  ~ShapeJudge();

  /// Judges an answer. For a wrong one about shapes other than two meshes the error is the gap or
  /// the depth, and the class is touching up to kShapeTolerance of the pair's scale, else real.
  /// graze is right to call shapes a hit that miss each other by its own kTouchTolerance, or for
  /// which its search does not end, where law 11 says so.
  Judgement judge(bool says, const CaseWitness& witness) const;

  /// Returns whether they meet; nothing if that is not proved, and for two meshes.
  std::optional<bool> is_hit() const;

  /// Returns the class of an error of so many metres in what else is said of them.
  ErrorClass class_of(double error) const;

  /// Returns the distance from the largest coordinate that a proof computes with to the next
  /// double.
  double ulp() const;

  /// Returns the question as a case, if there is one: about meshes, boxes and balls.
  const std::optional<Case>& as_case() const;

 private:
  struct Truth;
  std::unique_ptr<Truth> truth_;
};

/// Judges the questions any and pairs about shapes of which B, or both, are volumes. It is exact;
/// graze is right to call oriented boxes a hit that are apart by rounding, and is not judged where
/// it does so though they are further apart (law 11: there only "apart" is sure).
Judgement judge_volumes(const Case& query, const CaseAnswer& answer, bool is_graze);

}  // namespace graze::compare
