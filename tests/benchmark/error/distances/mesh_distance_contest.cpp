#include <graze/engine/mesh/distance.h>
#include <graze/engine/mesh/load_mesh.h>
#include <graze/engine/mesh/placement.h>
#include <graze/engine/pose_text.h>
#include <graze/narrowphase/triangle_distance.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/benchmark/common/thread_clock.h"
#include "tests/benchmark/error/bundled_meshes.h"
#include "tests/benchmark/error/distances/distance_contest.h"
#include "tests/benchmark/error/distances/rounded_distance.h"

namespace graze::benchmark {
namespace {

struct Placed {
  Triangle triangle;
  Aabb box;
};

/// Ascending by the low end along x.
std::vector<Placed> placed_triangles(const Mesh& mesh, const Pose& pose) {
  std::vector<Placed> all;
  for (std::uint32_t i = 0; i < mesh.triangles().size(); ++i) {
    const Triangle t = place(pose, mesh.triangle(i));
    all.push_back({t, {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)}});
  }
  std::sort(all.begin(), all.end(),
            [](const Placed& s, const Placed& t) { return s.box.min.x() < t.box.min.x(); });
  return all;
}

double square_of_gap(const Aabb& a, const Aabb& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0).squaredNorm();
}

/// Calls visit(a, b) for pairs whose boxes are within `reach` of each other, metres, and perhaps
/// for some that are a little further; visit may shorten the reach.
template <typename Visit>
void sweep(const std::vector<Placed>& all_a, const std::vector<Placed>& all_b, double& reach,
           const Visit& visit) {
  constexpr double kMore = 1 + 1e-9;  // far above the rounding of a gap
  double widest = 0;
  for (const Placed& b : all_b)
    widest = std::max(widest, b.box.max.x() - b.box.min.x());
  for (const Placed& a : all_a) {
    const double from = a.box.min.x() - kMore * (widest + reach);
    auto b = std::lower_bound(all_b.begin(), all_b.end(), from,
                              [](const Placed& p, double x) { return p.box.min.x() < x; });
    for (; b != all_b.end() && b->box.min.x() <= a.box.max.x() + kMore * reach; ++b) {
      if (square_of_gap(a.box, b->box) <= kMore * reach * reach) visit(a.triangle, b->triangle);
    }
  }
}

struct MeshDistanceTruth {
  double distance;
  double ulp;  ///< of the largest absolute placed coordinate
};

/// Starts with a pair that a query names, whether it is right or not. The distances of pairs, which
/// law 7 bounds and the contest of triangles checks, say which pairs go to rational arithmetic.
MeshDistanceTruth truth_of(const Mesh& mesh_a, const Mesh& mesh_b, const Pose& pose_b) {
  const std::vector<Placed> all_a = placed_triangles(mesh_a, Pose::Identity());
  const std::vector<Placed> all_b = placed_triangles(mesh_b, pose_b);
  double largest = 0;
  for (const std::vector<Placed>* all : {&all_a, &all_b}) {
    for (const Placed& p : *all)
      largest = std::max(largest, largest_coordinate(p.triangle));
  }
  const double ulp = ulp_of(largest);
  const graze::TrianglePair start = graze::distance({mesh_a}, {mesh_b, pose_b}).pair;
  double reach = graze::distance(place(Pose::Identity(), mesh_a.triangle(start.a)),
                                 place(pose_b, mesh_b.triangle(start.b)))
                     .distance;
  reach += 16 * ulp;
  double least = reach;
  std::vector<std::pair<Triangle, Triangle>> candidates;
  sweep(all_a, all_b, reach, [&](const Triangle& a, const Triangle& b) {
    const double found = graze::distance(a, b).distance + 16 * ulp;
    if (found > least + 16 * ulp) return;
    least = std::min(least, found);
    reach = least;
    candidates.emplace_back(a, b);
  });
  double truth = HUGE_VAL;
  for (const auto& [a, b] : candidates) {
    if (graze::distance(a, b).distance > least) continue;
    truth = std::min(truth, rounded_distance(a, b));
    if (truth == 0) break;
  }
  return {truth, ulp};
}

class MeshDistanceContest {
 public:
  MeshDistanceContest(const MeshDistanceContestants& contestants,
                      const MeshDistanceSettings& settings)
      : contestants_(contestants), settings_(settings) {
    for (const auto& contestant : contestants)
      result_.labels.push_back(contestant->label());
    result_.scores.resize(contestants.size());
  }

  void run(const MeshFiles& files) {
    const Mesh mesh_a = load_mesh(settings_.data / "meshes" / files.a);
    const Mesh mesh_b = load_mesh(settings_.data / "meshes" / files.b);
    for (const auto& contestant : contestants_)
      contestant->prepare(mesh_a, mesh_b);
    for (const auto& file : pose_files(settings_.data / "poses", files.name)) {
      std::fprintf(stderr, "\rdistances of meshes: %-40s", file.stem().c_str());
      run(file.stem(), mesh_a, mesh_b, spread(load_poses(file), settings_.poses));
    }
  }

  DistanceResult result() && {
    std::fputc('\n', stderr);
    return std::move(result_);
  }

 private:
  void run(const std::string& name, const Mesh& mesh_a, const Mesh& mesh_b,
           const std::vector<Pose>& poses) {
    std::vector<DistanceScore> scores(contestants_.size());
    DistanceFacts facts{name, false, poses.size(), 0};
    for (const Pose& pose : poses) {
      const MeshDistanceTruth truth = truth_of(mesh_a, mesh_b, pose);
      facts.touching += truth.distance == 0;
      for (std::size_t i = 0; i < contestants_.size(); ++i)
        ask(*contestants_[i], pose, truth, scores[i]);
    }
    result_.categories.push_back(facts);
    for (std::size_t i = 0; i < contestants_.size(); ++i) {
      scores[i].nanoseconds /= static_cast<double>(poses.size());
      result_.scores[i].push_back(scores[i]);
    }
  }

  void ask(MeshDistanceContestant& contestant, const Pose& pose, const MeshDistanceTruth& truth,
           DistanceScore& score) const {
    std::vector<double> times;
    double answer = 0;
    for (int i = 0; i < settings_.repetitions; ++i) {
      const ThreadClock clock;
      answer = contestant.distance(pose);
      times.push_back(clock.nanoseconds());
    }
    score.nanoseconds += median(times);
    count(score, answer, truth.distance, truth.ulp);
  }

  const MeshDistanceContestants& contestants_;
  const MeshDistanceSettings& settings_;
  DistanceResult result_{"distance of meshes", {}, {}, {}};
};

}  // namespace

DistanceResult contest_of_mesh_distances(const MeshDistanceContestants& contestants,
                                         const MeshDistanceSettings& settings) {
  MeshDistanceContest contest(contestants, settings);
  for (const MeshFiles& files : mesh_files())
    contest.run(files);
  return std::move(contest).result();
}

}  // namespace graze::benchmark
