#pragma once

#include <string>
#include <vector>

#include <graze/narrowphase/triangle.h>

namespace graze::compare {

/// Names a test of two triangles as textbooks have it.
enum class ClassicTest {
  Axes,          ///< seventeen directions, along one of which triangles that are apart have a gap
  Determinants,  ///< the sides of planes and edges on which corners and edges are
};

/// Says in which numbers a test computes.
enum class ClassicNumbers { Double, Float };

/// Holds a number whose sign decides, as it was computed and as it is.
struct ClassicStep {
  std::string name;     ///< "the gap along edge 1 of A x edge 3 of B"
  double computed = 0;  ///< m, m^2 or m^3, as edges' lengths are in it: not normalised
  double exact = 0;     ///< the number for the same corners, rounded once
  int computed_sign = 0;
  int exact_sign = 0;
  double ulps = 0;  ///< the error, in units of the last place of its largest term
};

/// Holds what a test says of two triangles, and its steps.
struct ClassicRun {
  bool says = false;
  std::vector<ClassicStep> steps;
  /// Returns the step that misleads the test; null if it is right, as far as signs of steps tell.
  const ClassicStep* misleading(bool truth) const;
  ClassicTest test = ClassicTest::Axes;
};

/// Runs a test. Corners are rounded to the numbers first; they must be finite.
ClassicRun run_classic(ClassicTest test, ClassicNumbers numbers, const Triangle& triangle_a,
                       const Triangle& triangle_b);

}  // namespace graze::compare
