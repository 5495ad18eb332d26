// FCL's continuous collision detection: sampling, which is its default, and advancement.

#include <fcl/narrowphase/continuous_collision.h>

#include <graze/engine/compare/fcl_geometry.h>

#include <limits>

#include "tests/benchmark/rigid_motions/peers/peers.h"

namespace graze::benchmark {
namespace {

ShapePeer fcl_peer(const char* name, fcl::CCDSolverType solver) {
  const auto load = [solver](const Shape& a, const Shape& b) -> AskMotions {
    const compare::FclGeometry of_a = compare::fcl_geometry(a), of_b = compare::fcl_geometry(b);
    return [of_a, of_b, solver](const Ends& ends_a, const Ends& ends_b) {
      fcl::ContinuousCollisionRequestd request;
      request.ccd_motion_type = fcl::CCDM_LINEAR;
      request.ccd_solver_type = solver;
      fcl::ContinuousCollisionResultd result;
      fcl::continuousCollide(of_a.geometry.get(), compare::fcl_transform(ends_a.start, of_a.centre),
                             compare::fcl_transform(ends_a.end, of_a.centre), of_b.geometry.get(),
                             compare::fcl_transform(ends_b.start, of_b.centre),
                             compare::fcl_transform(ends_b.end, of_b.centre), request, result);
      return result.is_collide ? result.time_of_contact : std::numeric_limits<double>::infinity();
    };
  };
  return {name, load};
}

}  // namespace

void add_fcl(std::vector<ShapePeer>& to) {
  to.push_back(fcl_peer("FCL, 10 samples", fcl::CCDC_NAIVE));
  to.push_back(fcl_peer("FCL, advancement", fcl::CCDC_CONSERVATIVE_ADVANCEMENT));
}

}  // namespace graze::benchmark
