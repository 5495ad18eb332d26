#include <graze/bvh/error.h>
#include <graze/engine/compare/exact_simplex.h>
#include <graze/engine/compare/referee.h>
#include <graze/engine/compare/whole_scale.h>
#include <cmath>
#include <string>

namespace graze::compare {
namespace {

void check_finite(const Triangle& triangle, const char* what) {
  const Eigen::Vector3d* corners[] = {&triangle.a, &triangle.b, &triangle.c};
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(corners[k]->data()[axis])) continue;
      throw InputError(std::string(what) + ": coordinate " + "xyz"[axis] + " of vertex " +
                       "abc"[k] + " is not finite");
    }
  }
}

/// Holds the coordinates of a triangle along one axis, as integers in a common scale.
struct WholeTriangle {
  mpz_class a;
  mpz_class b;
  mpz_class c;

  void set(const WholeScale& scale, const Triangle& triangle, int axis) {
    scale.whole(triangle.a.data()[axis], a);
    scale.whole(triangle.b.data()[axis], b);
    scale.whole(triangle.c.data()[axis], c);
  }
};

void include(WholeScale& scale, const Triangle& triangle, int axis) {
  scale.include(triangle.a.data()[axis]);
  scale.include(triangle.b.data()[axis]);
  scale.include(triangle.c.data()[axis]);
}

// The two weights from `first` on are those of vertices b and c; that of a is what remains of 1.
void add_weights(ExactSimplex& program, int first) {
  const int row = program.add_constraint(Relation::AtMost);
  program.coefficient(row, first) = 1;
  program.coefficient(row, first + 1) = 1;
  program.right(row) = 1;
}

/// Keeps the memory of a thread's integers from one call to the next.
struct Workspace {
  ExactSimplex program;
  WholeTriangle p;
  WholeTriangle q;
  mpz_class min;
  mpz_class max;
};

Workspace& workspace() {
  thread_local Workspace instance;
  return instance;
}

// Adds p.a + w0 (p.b - p.a) + w1 (p.c - p.a) = q.a + w2 (q.b - q.a) + w3 (q.c - q.a) along one
// axis. A constraint may be scaled by itself, so each axis has its own power of two.
void add_equal_points(Workspace& work, const Triangle& triangle_a, const Triangle& triangle_b,
                      int axis) {
  WholeScale scale;
  include(scale, triangle_a, axis);
  include(scale, triangle_b, axis);
  work.p.set(scale, triangle_a, axis);
  work.q.set(scale, triangle_b, axis);
  const int row = work.program.add_constraint(Relation::Equal);
  work.program.coefficient(row, 0) = work.p.b - work.p.a;
  work.program.coefficient(row, 1) = work.p.c - work.p.a;
  work.program.coefficient(row, 2) = work.q.a - work.q.b;
  work.program.coefficient(row, 3) = work.q.a - work.q.c;
  work.program.right(row) = work.q.a - work.p.a;
}

// Adds min <= p.a + w0 (p.b - p.a) + w1 (p.c - p.a) <= max along one axis.
void add_point_in_slab(Workspace& work, const Triangle& triangle, const Aabb& box, int axis) {
  WholeScale scale;
  include(scale, triangle, axis);
  scale.include(box.min.data()[axis]);
  scale.include(box.max.data()[axis]);
  work.p.set(scale, triangle, axis);
  scale.whole(box.min.data()[axis], work.min);
  scale.whole(box.max.data()[axis], work.max);
  const int above = work.program.add_constraint(Relation::AtMost);
  work.program.coefficient(above, 0) = work.p.b - work.p.a;
  work.program.coefficient(above, 1) = work.p.c - work.p.a;
  work.program.right(above) = work.max - work.p.a;
  const int below = work.program.add_constraint(Relation::AtMost);
  work.program.coefficient(below, 0) = work.p.a - work.p.b;
  work.program.coefficient(below, 1) = work.p.a - work.p.c;
  work.program.right(below) = work.p.a - work.min;
}

}  // namespace

bool referee_intersects(const Triangle& triangle_a, const Triangle& triangle_b) {
  check_finite(triangle_a, "triangle A");
  check_finite(triangle_b, "triangle B");
  Workspace& work = workspace();
  work.program.start(4);
  add_weights(work.program, 0);
  add_weights(work.program, 2);
  for (int axis = 0; axis < 3; ++axis)
    add_equal_points(work, triangle_a, triangle_b, axis);
  return work.program.is_feasible();
}

bool referee_intersects(const Triangle& triangle, const Aabb& box) {
  check_finite(triangle, "triangle");
  check_box(box, "box");
  Workspace& work = workspace();
  work.program.start(2);
  add_weights(work.program, 0);
  for (int axis = 0; axis < 3; ++axis)
    add_point_in_slab(work, triangle, box, axis);
  return work.program.is_feasible();
}

}  // namespace graze::compare
