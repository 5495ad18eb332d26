#pragma once

#include <string>
#include <vector>

#include <graze/narrowphase/triangle.h>

namespace graze::compare {

/// A test of two triangles as textbooks have it.
enum class ClassicTest {
  Axes,          ///< seventeen directions, along one of which what is apart has a gap
  Determinants,  ///< on which side of planes and edges corners and edges are
};

/// In which numbers.
enum class ClassicNumbers { Double, Float };

/// A number whose sign decides, as it was computed and as it is.
struct ClassicStep {
  std::string name;     ///< "the gap along edge 1 of A x edge 3 of B"
  double computed = 0;  ///< m, m^2 or m^3 with the lengths of edges: not normalised
  double exact = 0;     ///< of the same corners, rounded once
  int computed_sign = 0;
  int exact_sign = 0;
  double ulps = 0;  ///< how far off it is, in units of the last place of its largest term
};

/// What a test says of two triangles, and its steps.
struct ClassicRun {
  bool says = false;
  std::vector<ClassicStep> steps;
  /// The step that misleads it; null if it is right, as far as signs of steps tell.
  const ClassicStep* misleading(bool truth) const;
  ClassicTest test = ClassicTest::Axes;
};

/// The corners are rounded to the numbers first. Finite ones only.
ClassicRun run_classic(ClassicTest test, ClassicNumbers numbers, const Triangle& triangle_a,
                       const Triangle& triangle_b);

}  // namespace graze::compare
