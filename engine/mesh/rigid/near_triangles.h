#pragma once

// This is private to engine/mesh/rigid.

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

  /// True if the normal of one of them, as it stands at that time, keeps them apart in the whole
  /// span; then it is the direction. That takes a tenth of is_near()'s work, and is enough where a
  /// surface is smooth.
  bool are_apart_by_normals(const TimeSpan& span, std::uint64_t time, ApartDirection& direction);

  /// True if distance() is not above the limit at this time. If it is above, the direction is set.
  bool is_near(std::uint64_t time, ApartDirection& direction);

 private:
  bool set_to_normal(const PlacedBodies& placed, const BodyTriangle& triangle, const Pose& pose,
                     ApartDirection& direction) const;

  MovingPair& pair_;
  TrianglePair indices_;
  BodyTriangle a_;
  BodyTriangle b_;
  Work& work_;
};

}  // namespace graze
