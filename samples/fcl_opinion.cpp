// The second opinion when the samples are built with FCL.

#include <graze/engine/compare/fcl_engine.h>

#include "samples/median_time.h"
#include "samples/second_opinion.h"

namespace graze::samples {

struct SecondOpinion::Models {
  compare::FclMesh a;
  compare::FclMesh b;
};

SecondOpinion::SecondOpinion(const Mesh& mesh_a, const Mesh& mesh_b)
    : models_(new Models{compare::FclMesh(mesh_a), compare::FclMesh(mesh_b)}) {}

SecondOpinion::~SecondOpinion() = default;

std::optional<Opinion> SecondOpinion::on(const Pose& pose_b) const {
  const Pose pose_a = Pose::Identity();
  Opinion opinion{};
  opinion.hit_microseconds = median_microseconds(
      [&] { opinion.is_hit = compare::intersects(models_->a, pose_a, models_->b, pose_b); });
  opinion.pairs_microseconds = median_microseconds([&] {
    opinion.pairs = compare::find_triangle_pairs(models_->a, pose_a, models_->b, pose_b).size();
  });
  return opinion;
}

}  // namespace graze::samples
