#include <graze/engine/cli/pair/fcl_check.h>

namespace graze::cli {
namespace {

class BuiltFclCheck : public FclCheck {
 public:
  BuiltFclCheck(const Mesh& mesh_a, const Mesh& mesh_b)
      : mesh_a_(mesh_a), mesh_b_(mesh_b), fcl_a_(mesh_a), fcl_b_(mesh_b) {}

  compare::Comparison check_pairs(const TrianglePairs& graze_pairs, const Pose& pose_a,
                                  const Pose& pose_b) const override {
    return compare::compare_pairs(graze_pairs.pairs,
                                  compare::find_triangle_pairs(fcl_a_, pose_a, fcl_b_, pose_b),
                                  {mesh_a_, pose_a}, {mesh_b_, pose_b});
  }

  compare::Comparison check_any(bool graze_intersects, const Pose& pose_a,
                                const Pose& pose_b) const override {
    return compare::compare_any(graze_intersects, {{mesh_a_, pose_a}, fcl_a_},
                                {{mesh_b_, pose_b}, fcl_b_});
  }

 private:
  Mesh mesh_a_;
  Mesh mesh_b_;
  compare::FclMesh fcl_a_;
  compare::FclMesh fcl_b_;
};

}  // namespace

bool has_fcl_check() {
  return true;
}

std::unique_ptr<FclCheck> make_fcl_check(const Mesh& mesh_a, const Mesh& mesh_b) {
  return std::make_unique<BuiltFclCheck>(mesh_a, mesh_b);
}

}  // namespace graze::cli
