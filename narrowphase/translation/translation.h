#pragma once

// Triangle B moves by t d, d being its displacement, and A stays. They have a point in common at
// the times t at which t d = p - q for some p of A and q of B. These times are a closed interval,
// and its ends are optima of a linear program in t and the weights of the corners in p and q, so
// they are taken on at basic solutions: where a corner meets a triangle whose plane d goes through,
// or where two edges meet that are not in one plane with d; and, where all these are in one plane
// with d, a corner meets an edge that is not along d, or a corner. Each of these has one time.

#include <graze/narrowphase/derived/sign_of_products.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle.h>

#include <optional>

namespace graze::narrowphase {

/// Holds the corners of A at rest, those of B where it is at t = 0, and d. All that it points to
/// must outlive it.
struct TranslatedPair {
  Corners<double> a;
  Corners<double> b;
  const double* displacement;

  TranslatedPair(const Triangle& triangle_a, const Triangle& triangle_b, const double* d)
      : a(corners_of(triangle_a)), b(corners_of(triangle_b)), displacement(d) {}
};

/// Names what meets: a basic solution.
struct Meeting {
  enum class Kind {
    VertexFace,      ///< corner `a` of A and the triangle of B
    FaceVertex,      ///< the triangle of A and corner `b` of B
    EdgeEdge,        ///< edge `a` of A, from corner `a` to the next, and edge `b` of B
    VertexOnEdge,    ///< corner `a` and edge `b`, which are in one plane with d
    EdgeWithVertex,  ///< edge `a` and corner `b`, which are in one plane with d
    VertexVertex     ///< corner `a` and corner `b`, on one line along d
  };
  Kind kind;
  int a;
  int b;
  int axis;  ///< an axis along which the time of the last three can be told
};

/// Bounds of a time that is not negative, in rounded arithmetic.
struct TimeBounds {
  double low;
  double high;
};

struct TimedMeeting {
  Meeting meeting;
  TimeBounds bounds;
};

/// Returns the first meeting in (0, 1] of triangles that are apart at t = 0. Of several at one time
/// it is that of the lowest corner of A and the triangle of B, then of the triangle of A and a
/// corner of B, then of edges. Exact.
std::optional<TimedMeeting> first_meeting(const TranslatedPair& pair);

/// True if the insides of triangles in different planes share a point at t = 0, or at all times
/// directly after it (crosses()). Exact.
bool crosses_from_start(const TranslatedPair& pair);

}  // namespace graze::narrowphase
