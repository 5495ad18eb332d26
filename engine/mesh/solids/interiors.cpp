// Do the open interiors O of two closed meshes A and B meet?
//
// Triangles without area change no parity and are left out. Let a triangle T of A be *clear*: no
// other triangle of A meets its inside. Then A lies on one side of T, the same all over its inside:
// its *inner side*. The interiors meet if, for such T and such triangles t of B,
//   1. t reaches the inside of T in some point and has a corner on T's inner side: beside that
//      point the inside of t is within A, and B lies on one of its sides; or
//   2. t lies in T's plane, their insides meet, and their inner sides are the same; or
//   3. B encloses what is beside some point of T's inside on its inner side.
// With A and B exchanged the same holds. If they meet, one of these is so: the intersection is a
// bounded open set, of whose boundary some piece with area lies on a triangle, T say, with the set
// on T's inner side. Beside a point of that piece B encloses what is on that side, or it has a
// triangle there, of T's plane and on the same side (2). Where neither 1 nor 2 is so of T, all that
// meets T's inside stays on the other side of it, so that no surface of B parts what is beside T's
// inside on the inner side: B encloses all of it or nothing, and one sample decides (3).
//
// A triangle that is not clear is asked cell by cell: all triangles of both meshes that meet it
// divide it into cells, and beside one point of each, on both sides, it is seen whether both meshes
// enclose what is there. That finds every piece of the boundary of the intersection that lies on
// it. And where such a triangle of B reaches the inside of a clear T from the inner side, and parts
// what is beside that, a piece is on both of them.
//
// Triangles that share no point with B lie on one side of it together with all that hang together
// with them by such triangles. So one of these stands for all: beside each corner of what touches,
// and in each component. Where it lies within B, a clear one tells that the interiors meet; a mesh
// of which none is clear there is asked cell by cell.

#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/mesh/inside/parity.h>
#include <graze/engine/mesh/pair.h>
#include <graze/engine/mesh/query/query_results.h>
#include <graze/engine/mesh/solids/face_cells.h>
#include <graze/engine/mesh/solids/face_sides.h>
#include <graze/engine/mesh/solids/representatives.h>
#include <graze/narrowphase/predicates/plane_sides.h>
#include <graze/narrowphase/triangle_pair/inside_contact.h>

#include <set>
#include <vector>

namespace graze {
namespace {

using narrowphase::Sign;

/// One of the two meshes in the question, as a solid.
struct Solid {
  Solid(const PlacedMeshView& placed, Work& work) : sides(placed, work) {}

  FaceSides sides;
  std::set<std::uint32_t> open;  ///< triangles that are to be asked cell by cell
};

class InteriorQuery {
 public:
  InteriorQuery(const PlacedMeshView& a, const PlacedMeshView& b, Work& work)
      : a_(a, work), b_(b, work), work_(work) {}

  bool answer() {
    if (do_some_cross()) return true;
    const TrianglePairs touching =
        find_triangle_pairs(a_.sides.placed(), b_.sides.placed(), {}, &work_);
    for (const TrianglePair& pair : touching) {
      if (!a_.sides.has_area(pair.a) || !b_.sides.has_area(pair.b)) continue;
      if (does_contact_tell(pair)) return true;
    }
    Representatives of_a(a_.sides.placed().mesh), of_b(b_.sides.placed().mesh);
    for (const TrianglePair& pair : touching)
      of_a.add_touched(pair.a), of_b.add_touched(pair.b);
    if (do_samples_tell(a_, b_, of_a) || do_samples_tell(b_, a_, of_b)) return true;
    return do_cells_tell(a_, b_) || do_cells_tell(b_, a_);
  }

 private:
  /// True if triangles are found that cross and are clear: each has corners on both sides of the
  /// other.
  bool do_some_cross() {
    const TrianglePairs crossing = find_triangle_pairs(
        a_.sides.placed(), b_.sides.placed(), {.limit = 1, .touch = Touch::Exclude}, &work_);
    if (crossing.empty()) return false;
    const auto [a, b] = crossing[0];
    return a_.sides.has_area(a) && b_.sides.has_area(b) && !a_.sides.intruder(a) &&
           !b_.sides.intruder(b);
  }

  /// True if nothing of its own mesh meets the triangle's inside; otherwise it is left open.
  static bool is_clear(Solid& solid, std::uint32_t index) {
    if (!solid.sides.intruder(index)) return true;
    solid.open.insert(index);
    return false;
  }

  /// Decides rules 1 and 2 for triangles that touch and have area.
  bool does_contact_tell(const TrianglePair& pair) {
    const Triangle a = a_.sides.triangle(pair.a), b = b_.sides.triangle(pair.b);
    if (does_enter(a_, pair.a, a, b_, pair.b, b)) return true;
    if (does_enter(b_, pair.b, b, a_, pair.a, a)) return true;
    if (!sides_of(a, b).are_all_zero() || !narrowphase::meets_inside(b, a)) return false;
    const bool is_a_clear = is_clear(a_, pair.a), is_b_clear = is_clear(b_, pair.b);
    if (!is_a_clear || !is_b_clear) return false;
    const Sign side_a = a_.sides.enclosed(pair.a).side();
    const Sign side_b = b_.sides.enclosed(pair.b).side();
    return narrowphase::turn_alike(a, b) == (side_a == side_b);
  }

  /// Decides rule 1: whether the other triangle reaches the inside of this one from its inner side.
  /// If it is not clear, it may part what is beside this one all the same, and is left open.
  static bool does_enter(Solid& solid, std::uint32_t index, const Triangle& triangle, Solid& others,
                         std::uint32_t other_index, const Triangle& other) {
    const narrowphase::PlaneSides sides = sides_of(triangle, other);
    if (sides.are_all_zero() || !narrowphase::meets_inside(other, triangle)) return false;
    if (!is_clear(solid, index) || !sides.has(solid.sides.enclosed(index).side())) return false;
    return is_clear(others, other_index);
  }

  static narrowphase::PlaneSides sides_of(const Triangle& plane, const Triangle& of) {
    return narrowphase::sides_of_plane(narrowphase::corners_of(plane), narrowphase::corners_of(of));
  }

  /// Decides rule 3 for what touches and for what stands for the rest.
  bool do_samples_tell(Solid& solid, const Solid& other, Representatives& representatives) {
    const auto has_area = [&](std::uint32_t index) { return solid.sides.has_area(index); };
    for (const std::uint32_t index : representatives.touched()) {
      if (has_area(index) && does_sample_tell(solid, index, other)) return true;
    }
    for (const std::uint32_t index : representatives.untouched(has_area)) {
      if (does_sample_tell(solid, index, other)) return true;
      if (!solid.open.contains(index)) continue;
      for (const std::uint32_t connected : representatives.connected(index, has_area)) {
        if (is_clear(solid, connected)) return true;
      }
    }
    return false;
  }

  /// Decides rule 3 for one triangle. A triangle that lies within the other mesh, and yet has no
  /// side beside its sample on which its own mesh lies, may have one elsewhere, if another triangle
  /// of its mesh meets its inside. Whether one of the other mesh does has been asked.
  bool does_sample_tell(Solid& solid, std::uint32_t index, const Solid& other) {
    if (is_sample_shared(solid, index, other)) return true;
    if (is_enclosed(other, solid.sides.triangle(index), Sign::Positive)) is_clear(solid, index);
    return false;
  }

  bool is_sample_shared(Solid& solid, std::uint32_t index, const Solid& other) {
    const FaceSides::Enclosed own = solid.sides.enclosed(index);
    const Triangle triangle = solid.sides.triangle(index);
    return (own.above && is_enclosed(other, triangle, Sign::Positive)) ||
           (own.below && is_enclosed(other, triangle, Sign::Negative));
  }

  bool is_enclosed(const Solid& solid, const Triangle& triangle, Sign side) const {
    return is_sample_enclosed(solid.sides.placed(), {triangle, side}, work_);
  }

  /// Decides for open triangles beside one point of each of their cells.
  bool do_cells_tell(const Solid& solid, const Solid& other) const {
    for (const std::uint32_t index : solid.open) {
      const Triangle triangle = solid.sides.triangle(index);
      std::vector<Triangle> near;
      for (const FaceSides* sides : {&solid.sides, &other.sides}) {
        for (const std::uint32_t each : solid.sides.meeting(index, *sides))
          near.push_back(sides->triangle(each));
      }
      const auto is_shared = [&](const narrowphase::RationalPoint& point) {
        const Aabb around = narrowphase::box_around(point);
        const auto is_shared_on = [&](Sign side) {
          const narrowphase::RationalSample sample{point, around, triangle, side};
          return is_sample_enclosed(solid.sides.placed(), sample, work_) &&
                 is_sample_enclosed(other.sides.placed(), sample, work_);
        };
        return is_shared_on(Sign::Positive) || is_shared_on(Sign::Negative);
      };
      if (FaceCells(triangle, near).any(is_shared)) return true;
    }
    return false;
  }

  Solid a_;
  Solid b_;
  Work& work_;
};

}  // namespace

bool interiors_intersect(const PlacedMeshView& mesh_a, const PlacedMeshView& mesh_b, Work* work) {
  return bvh::in_standard_arithmetic([&]() -> bool {
    check_closed(mesh_a.mesh, "mesh A");
    check_closed(mesh_b.mesh, "mesh B");
    CountedWork counted(work);
    return InteriorQuery(mesh_a, mesh_b, counted.work()).answer();
  });
}

}  // namespace graze
