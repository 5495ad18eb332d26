#include "tests/narrowphase/derived/value_faults.h"

#include <graze/narrowphase/derived/distance_stages.h>
#include <graze/narrowphase/triangle_intersection.h>
#include <graze/narrowphase/triangle_triangle.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "tests/crosscheck/permutations.h"
#include "tests/narrowphase/derived/rational_triangles.h"
#include "tests/oracle/case_text.h"

namespace graze::oracle {
namespace {

bool are_bits_equal(const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
}

bool are_same(const TriangleDistance& x, const TriangleDistance& y) {
  return x.distance == y.distance && are_bits_equal(x.point_a, y.point_a) &&
         are_bits_equal(x.point_b, y.point_b) && x.feature_a == y.feature_a &&
         x.feature_b == y.feature_b;
}

TriangleDistance mirrored(const TriangleDistance& x) {
  return {x.distance, x.point_b, x.point_a, x.feature_b, x.feature_a};
}

bool are_same(const TriangleIntersection& x, const TriangleIntersection& y) {
  if (x.kind != y.kind || x.count != y.count) return false;
  for (int i = 0; i < x.count; ++i) {
    if (std::memcmp(x.corner[i].data(), y.corner[i].data(), 3 * sizeof(double)) != 0) return false;
  }
  return true;
}

/// |value^2 - square| as far as a root that is off by `reach` explains.
bool is_root(double value, const mpq_class& square, const mpq_class& reach) {
  const mpq_class low = mpq_class(value) - reach;
  const mpq_class high = mpq_class(value) + reach;
  return square <= high * high && (low <= 0 || low * low <= square);
}

bool lies_on(const Eigen::Vector3d& point, const Triangle& t, const mpq_class& reach) {
  return squared_distance(exactly(point), t) <= 3 * reach * reach;
}

const char* fault_of(const TrianglePair& pair, const TriangleDistance& found) {
  const mpq_class ulp = ulp_of_coordinates(pair.a, pair.b);
  if ((found.distance == 0) != intersects(pair.a, pair.b)) {
    return "law 7: zero does not mean that they intersect";
  }
  if (!lies_on(found.point_a, pair.a, 2 * ulp) || !lies_on(found.point_b, pair.b, 2 * ulp)) {
    return "law 7: a witness is off its triangle by more than 2 ulp";
  }
  if (found.distance == 0) {
    return are_bits_equal(found.point_a, found.point_b) ? nullptr : "law 7: two witnesses of zero";
  }
  const RationalDistance exact = rational_distance(pair.a, pair.b);
  if (std::isfinite(found.distance) &&
      !is_root(found.distance, exact.square, 4 * ulp_of_differences(pair.a, pair.b))) {
    return "law 7: the distance is off by more than 4 ulp";
  }
  if (exact.nearest.size() > 1) {
    // Each of the witnesses is off by at most 2 ulp in each coordinate.
    const mpq_class between = squared_distance(exactly(found.point_a), exactly(found.point_b));
    const mpq_class reach = 8 * ulp + 4 * ulp_of_differences(pair.a, pair.b);
    return !std::isfinite(found.distance) || is_root(found.distance, between, reach)
               ? nullptr
               : "law 7: the witnesses disagree with the distance";
  }
  const bool are_near = are_within(exact.nearest[0].a, found.point_a, 2 * ulp) &&
                        are_within(exact.nearest[0].b, found.point_b, 2 * ulp);
  return are_near ? nullptr : "law 7: a witness is off by more than 2 ulp";
}

/// The corners are those of the exact intersection, in its order, one way round or the other.
bool follow(const std::vector<RationalPoint>& exact, const TriangleIntersection& found,
            const mpq_class& reach) {
  const int n = found.count;
  for (int first = 0; first < n; ++first) {
    for (int step : {1, n - 1}) {
      bool is_matching = true;
      for (int i = 0; i < n; ++i) {
        const RationalPoint& corner = exact[static_cast<std::size_t>((first + i * step) % n)];
        is_matching &= are_within(corner, found.corner[i], reach);
      }
      if (is_matching) return true;
    }
  }
  return n == 0;
}

}  // namespace

std::string distance_fault(const TrianglePair& pair) {
  const TriangleDistance found = distance(pair.a, pair.b);
  const char* fault = fault_of(pair, found);
  if (fault == nullptr) {
    fault = fault_of(pair, narrowphase::distance_exactly(pair.a, pair.b));
  }
  const auto b_orders = crosscheck::permutations(pair.b);
  for (const Triangle& a : crosscheck::permutations(pair.a)) {
    for (int i = 1; i < 6; i += 2) {
      if (!are_same(distance(a, b_orders[i]), found) ||
          !are_same(mirrored(distance(b_orders[i], a)), found)) {
        fault = "law 4: another order changes the result";
      }
    }
  }
  if (fault == nullptr) return "";
  return std::string(fault) + ":\n" + to_text(pair, intersects(pair.a, pair.b));
}

std::string intersection_fault(const TrianglePair& pair) {
  const std::vector<RationalPoint> exact = rational_intersection(pair.a, pair.b);
  const TriangleIntersection found = intersection(pair.a, pair.b);
  const mpq_class ulp = ulp_of_coordinates(pair.a, pair.b);
  std::string fault;
  if (found.count != static_cast<int>(exact.size())) {
    fault =
        "law 7: " + std::to_string(found.count) + " corners, not " + std::to_string(exact.size());
  } else if ((found.kind == IntersectionKind::None) == intersects(pair.a, pair.b)) {
    fault = "law 7: disagrees with intersects()";
  } else if (!follow(exact, found, 2 * ulp)) {
    fault = "law 7: a corner is off by more than 2 ulp";
  }
  for (const Triangle& a : crosscheck::permutations(pair.a)) {
    for (const Triangle& b : crosscheck::permutations(pair.b)) {
      if (!are_same(intersection(a, b), found) || !are_same(intersection(b, a), found))
        fault = "law 4: another order changes the result";
    }
  }
  return fault.empty() ? "" : fault + ":\n" + to_text(pair, !exact.empty());
}

}  // namespace graze::oracle
