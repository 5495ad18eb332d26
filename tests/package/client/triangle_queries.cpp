#include <graze/engine/mesh/placement.h>
#include <graze/graze.h>

#include "digest.h"
#include "numbers.h"
#include "queries.h"

namespace client {
namespace {

graze::Triangle random_triangle(Random& random, int range, int exponent) {
  const Eigen::Vector3d a = random.point(range, exponent);
  const Eigen::Vector3d b = random.point(range, exponent);
  const Eigen::Vector3d c = random.point(range, exponent);
  return {a, b, c};
}

/// Range and exponent of the lattice for the n-th query: coarse ones, where most pairs touch and
/// many triangles are degenerate, and fine, huge, tiny and denormal ones.
graze::Triangle nth_triangle(Random& random, int n) {
  switch (n % 6) {
    case 0:
      return random_triangle(random, 2, 0);
    case 1:
      return random_triangle(random, 5, -3);
    case 2:
      return random_triangle(random, 1 << 20, -20);
    case 3:
      return random_triangle(random, 3, 500);
    case 4:
      return random_triangle(random, 3, -400);
    default:
      return random_triangle(random, 3, -1073);
  }
}

/// Turned, and one corner moved by ulps: pairs that touched now touch or miss by a hair.
graze::Triangle turned(const graze::Pose& pose, const graze::Triangle& triangle, int ulps) {
  graze::Triangle result = graze::place(pose, triangle);
  result.a.z() = moved_by_ulps(result.a.z(), ulps);
  return result;
}

void count(Answers& answers, Digest& digest, bool is_hit) {
  ++answers.queries;
  answers.hits += is_hit;
  digest.add(std::uint64_t{is_hit});
}

graze::Aabb random_box(Random& random) {
  const Eigen::Vector3d center = random.point(4, -1);
  const double x = random.integer(2), y = random.integer(2), z = random.integer(2);
  const Eigen::Vector3d half(x, y, z);
  return {center - half.cwiseAbs(), center + half.cwiseAbs()};
}

}  // namespace

Answers test_triangles() {
  Random random;
  Answers answers;
  Digest digest;
  for (int n = 0; n < 6000; ++n) {
    graze::Triangle s = nth_triangle(random, n);
    graze::Triangle t = nth_triangle(random, n);
    if (random.integer(1) == 0) t.b = s.b;
    count(answers, digest, graze::intersects(s, t));
    const graze::Pose pose = rotation(random.next());
    s = turned(pose, s, random.integer(2));
    t = turned(pose, t, 0);
    count(answers, digest, graze::intersects(s, t));
    const graze::Aabb box = random_box(random);
    count(answers, digest, graze::intersects(s, box));
    const graze::Obb turned_box{rotation(random.next()), (box.max - box.min) * 0.5};
    count(answers, digest, graze::intersects(t, turned_box));
  }
  answers.digest = digest.value();
  return answers;
}

Answers place_points() {
  Random random;
  Answers answers;
  Digest digest;
  for (int n = 0; n < 4000; ++n) {
    graze::Pose pose = rotation(random.next());
    pose.translation() = random.point(1 << 20, -30);
    const Eigen::Vector3d placed = graze::place(pose, random.point(1 << 20, -10 - n % 900));
    for (double coordinate : {placed.x(), placed.y(), placed.z()})
      digest.add(coordinate);
    ++answers.queries;
  }
  answers.digest = digest.value();
  return answers;
}

}  // namespace client
