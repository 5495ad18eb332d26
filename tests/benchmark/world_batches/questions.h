#pragma once

#include <graze/bvh/ray.h>
#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/placed_shape.h>

#include <cstddef>
#include <vector>

namespace graze::benchmark {

/// What many rays, or a shape in many poses or motions, are asked of a world.
enum class Question { Rays, Touching, Within, Closest, Casts };
inline constexpr Question kQuestions[] = {Question::Rays, Question::Touching, Question::Within,
                                          Question::Closest, Question::Casts};

const char* name_of(Question question);

/// How far a shape may be away for Question::Within, metres.
inline constexpr double kClearance = 0.25;
/// How far rays go, metres.
inline constexpr double kSight = 20;

/// Boxes and balls at random, and what is asked of them.
struct Questions {
  std::vector<PlacedShape> bodies;
  Shape probe = Sphere{{0, 0, 0}, 0.5};
  std::vector<Ray> rays;
  std::vector<Pose> poses;
  std::vector<RigidMotion> motions;  ///< straight, from the poses
};

/// So many bodies, of a metre and a half in the mean, one for each 27 cubic metres; and as many
/// elements of each question.
Questions make_questions(std::size_t bodies, std::size_t elements);

}  // namespace graze::benchmark
