#pragma once

// Private to engine/mesh/rigid.

#include <graze/engine/mesh/rigid/keeps_apart.h>
#include <graze/engine/mesh/triangle_pairs.h>
#include <graze/engine/work.h>

namespace graze {

/// Two triangles, one of each body.
class MovingTriangles {
 public:
  MovingTriangles(MovingPair& pair, TrianglePair of_bodies, Work& work)
      : pair_(pair),
        indices_(of_bodies),
        a_(pair.a().triangle(of_bodies.a)),
        b_(pair.b().triangle(of_bodies.b)),
        work_(work) {}

  Apart ask(const TimeSpan& span, const ApartDirection& direction) {
    return keeps_apart(pair_, span, direction, a_, b_);
  }

  /// Whether distance() is not above the limit at this time. If it is, finds a direction.
  bool is_near(std::uint64_t time, ApartDirection& direction);

 private:
  MovingPair& pair_;
  TrianglePair indices_;
  BodyTriangle a_;
  BodyTriangle b_;
  Work& work_;
};

}  // namespace graze
