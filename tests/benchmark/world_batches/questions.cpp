#include "tests/benchmark/world_batches/questions.h"

#include <cmath>

#include "tests/shapes/random_meshes.h"

namespace graze::benchmark {
namespace {

constexpr const char* kQuestionNames[] = {"rays", "touching", "within", "closest", "casts"};

Eigen::Vector3d in_cube(double reach, RandomSource& source) {
  const double x = source.uniform(-reach, reach), y = source.uniform(-reach, reach);
  return {x, y, source.uniform(-reach, reach)};
}

}  // namespace

const char* name_of(Question question) {
  return kQuestionNames[static_cast<std::size_t>(question)];
}

Questions make_questions(std::size_t bodies, std::size_t elements) {
  RandomSource source(17);
  const double reach = 1.5 * std::cbrt(static_cast<double>(bodies));
  Questions made;
  made.bodies.reserve(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    const double size = source.uniform(0.25, 0.75);
    const Shape shape =
        i % 2 == 0 ? Shape(Sphere{{0, 0, 0}, size}) : Shape(Box{{size, 0.75 * size, 1.25 * size}});
    made.bodies.push_back({shape, tests::random_pose(reach, source)});
  }
  made.rays.reserve(elements), made.poses.reserve(elements), made.motions.reserve(elements);
  for (std::size_t i = 0; i < elements; ++i) {
    made.rays.push_back({in_cube(reach, source), in_cube(1, source), kSight});
    made.poses.push_back(tests::random_pose(reach, source));
    made.motions.push_back(
        RigidMotion(made.poses.back(), RigidCourse{.shift = in_cube(4, source)}));
  }
  return made;
}

}  // namespace graze::benchmark
