// Makes Guigue and Devillers' test in rounded arithmetic, with one error bound for all determinants
// of a pair. Where determinants cannot decide, comparing coordinates may: that is exact.

#include <graze/narrowphase/lanes/two_lanes.h>
#include <graze/narrowphase/lanes/verdicts.h>
#include <graze/narrowphase/predicates/coordinates.h>
#include <graze/narrowphase/triangle_pair/triangle_pair_batch.h>
#include <graze/narrowphase/triangle_pair/triangle_triangle_stages.h>
#include <graze/narrowphase/triangle_triangle.h>
#include <cstdint>

namespace graze::narrowphase {
namespace {

TwoVectors points(const double* a, const double* b) {
  return {TwoLanes{a[0], b[0]}, TwoLanes{a[1], b[1]}, TwoLanes{a[2], b[2]}};
}

/// Returns corner `i` of both triangles: lane 0 is A's, lane 1 is B's.
TwoVectors corner_of_both(const double* a, const double* b, int i) {
  return points(a + 3 * i, b + 3 * i);
}

TwoVectors swapped(const TwoVectors& v) {
  return {narrowphase::swapped(v.x), narrowphase::swapped(v.y), narrowphase::swapped(v.z)};
}

/// Returns the largest minus the smallest of six, the same in both lanes.
TwoLanes extent(TwoLanes a, TwoLanes b, TwoLanes c) {
  const TwoLanes high = larger(larger(a, b), c);
  const TwoLanes low = smaller(smaller(a, b), c);
  return larger(high, narrowphase::swapped(high)) - smaller(low, narrowphase::swapped(low));
}

/// Holds what the signs of three vertices beside a plane, of which two agree and one does not, say
/// about their order. Bit i of an index is set if vertex i is on the negative side; offsets are to
/// the first coordinates of the apex and of the two that follow it.
struct Order {
  std::uint8_t apex, next, last;
};
constexpr Order kOrders[8] = {{0, 3, 6}, {0, 3, 6}, {3, 6, 0}, {6, 0, 3},
                              {6, 0, 3}, {3, 6, 0}, {0, 3, 6}, {0, 3, 6}};

constexpr bool is_apex_negative(unsigned signs) {
  constexpr unsigned kOneNegative = 1u << 0b001 | 1u << 0b010 | 1u << 0b100;
  return (kOneNegative >> signs & 1) != 0;
}

/// This is figure 5 of the paper: the intervals that two crossing triangles cut out of the line
/// that their planes share overlap unless one ends before the other begins. The paper turns both
/// triangles until each has its apex on the positive side of the other's plane, and asks for the
/// signs of [p_a q_a p_b q_b] and [p_a r_a r_b p_b]. Turning one of them instead of both or none,
/// and turning A alone, change no more than the signs and which of q_b and r_b goes with q_a: the
/// two determinants are the lanes.
Verdict triage_intervals(const double* a, unsigned signs_a, const double* b, unsigned signs_b,
                         double bound) {
  const Order order_a = kOrders[signs_a];
  const Order order_b = kOrders[signs_b];
  const bool is_a_negative = is_apex_negative(signs_a);
  const bool is_b_negative = is_apex_negative(signs_b);
  const int with_next = is_a_negative == is_b_negative ? order_b.next : order_b.last;
  const int with_last = is_a_negative == is_b_negative ? order_b.last : order_b.next;
  const TwoVectors origin = points(a + order_a.apex, a + order_a.apex);
  const TwoVectors edges = points(a + order_a.next, a + order_a.last) - origin;
  const TwoVectors offset = points(b + order_b.apex, b + order_b.apex) - origin;
  const TwoVectors ends = points(b + with_next, b + with_last) - origin;
  const TwoLanes determinant = dot(cross(edges, offset), ends);
  const TwoLanes gap = negated(determinant, is_b_negative ? 0b01 : 0b10);
  return verdict_of(sign_bits(are_greater(gap, both(bound))) != 0,
                    sign_bits(are_greater(both(-bound), gap)) == 0b11);
}

}  // namespace

/// A coordinate that is not finite makes all determinants that it enters infinite or NaN, and with
/// infinity the extents are not in range; a comparison with NaN is never passed, so that the
/// verdict is Unsure.
Verdict triage(const Triangle& triangle_a, const Triangle& triangle_b) {
  const double* a = coordinates(triangle_a);
  const double* b = coordinates(triangle_b);
  const TwoVectors own[3] = {corner_of_both(a, b, 0), corner_of_both(a, b, 1),
                             corner_of_both(a, b, 2)};
  const double x = extent(own[0].x, own[1].x, own[2].x)[0];
  const double y = extent(own[0].y, own[1].y, own[2].y)[0];
  const double z = extent(own[0].z, own[1].z, own[2].z)[0];
  const double volume = x * y * z;
  const double bound = kPairBound * volume;
  // Lane 0 is the plane of A with B's corners beside it, lane 1 the plane of B with A's.
  const TwoVectors normal = cross(own[1] - own[0], own[2] - own[0]);
  const TwoLanes first = dot(normal, swapped(own[0]) - own[0]);
  const TwoLanes second = dot(normal, swapped(own[1]) - own[0]);
  const TwoLanes third = dot(normal, swapped(own[2]) - own[0]);
  const TwoLanes limit = both(bound);
  const unsigned sure = sign_bits(
      both_of(both_of(are_greater(magnitude(first), limit), are_greater(magnitude(second), limit)),
              are_greater(magnitude(third), limit)));
  const unsigned signs[3] = {sign_bits(first), sign_bits(second), sign_bits(third)};
  const bool is_in_range = volume >= kSmallestPairVolume && x <= kLargestPairExtent &&
                           y <= kLargestPairExtent && z <= kLargestPairExtent;
  const unsigned one_sided = ~((signs[0] ^ signs[1]) | (signs[0] ^ signs[2]));
  if (is_in_range && (sure & one_sided) != 0) return Verdict::No;
  if (!is_in_range || sure != 0b11) return compare_coordinates(triangle_a, triangle_b);
  const unsigned signs_b = (signs[0] & 1) | (signs[1] & 1) << 1 | (signs[2] & 1) << 2;
  const unsigned signs_a = signs[0] >> 1 | (signs[1] >> 1) << 1 | (signs[2] >> 1) << 2;
  return triage_intervals(a, signs_a, b, signs_b, bound);
}

}  // namespace graze::narrowphase
