#include <graze/engine/mesh/containment.h>
#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/prepare.h>

#include <cmath>
#include <optional>

#include "tests/benchmark/points/contestant.h"

namespace graze::benchmark {
namespace {

class Graze : public PointContestant {
 public:
  Graze() : PointContestant("graze") {}

  void build(const Mesh& mesh) override {
    mesh_ = mesh;
    prepare(mesh, {.queries = PreparedFor::All});
    mesh.topology();
  }

  double ask(PointQuestion question, std::span<const Eigen::Vector3d> points) override {
    double sum = 0;
    if (question == PointQuestion::Batch) {
      for (const double distance : signed_distances(*mesh_, points, {.threads = 1}))
        sum += distance;
      return sum;
    }
    for (const Eigen::Vector3d& point : points) {
      if (question == PointQuestion::Inside) sum += contains(*mesh_, point);
      if (question == PointQuestion::Nearest) sum += nearest_point(*mesh_, point).distance;
      if (question == PointQuestion::Signed) sum += signed_distance(*mesh_, point);
    }
    return sum;
  }

 private:
  std::optional<Mesh> mesh_;
};

}  // namespace

std::unique_ptr<PointContestant> make_graze_points() {
  return std::make_unique<Graze>();
}

}  // namespace graze::benchmark
