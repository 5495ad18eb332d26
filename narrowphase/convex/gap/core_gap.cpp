#include <graze/narrowphase/convex/core/contact_face.h>
#include <graze/narrowphase/convex/gap/core_gap.h>
#include <graze/narrowphase/convex/gap/nearest_on_simplex.h>

#include <cmath>
#include <initializer_list>

namespace graze::narrowphase {
namespace {

// u = 2^-53. The direction is off by 3 u in each coordinate of the core's frame, where a wrong
// choice of the farthest point costs as much times twice the bounding radius: 10.4 u of it. The
// core's own formula takes 12.5 u at most, turning back 5.2 u, sums 2 u: below 31 u of the radius
// and 2 u of the largest coordinate. For both, of which the scale is the sum, with their
// difference, the dot product and the direction's length, that is below 40 u. 128 u covers it.
constexpr double kRelativeSlack = 128 * 0x1p-53;

// Bounds that are closer than this to each other, relative to the gap, are one.
constexpr double kRelativeGoal = 0x1p-46;

/// The bounds are close enough at this share of what users call the scale of a pair, as curved
/// cores close in slowly: 2^-34, less what rounding takes off the bounds of sets.
constexpr double kRelativeTolerance = 0x1p-34 * (1 - 0x1p-8);

// Looking across faces ends after so many rounds, or when one gains less than this share.
constexpr int kMostRounds = 16;
constexpr double kWorthwhile = 0x1p-4;

// These numbers say how often the features at hand are looked along, and how far aside: along an
// edge by enough that a corner of it goes before rounding, and by little enough that other features
// do not; around round sides by ever less. Which directions are tried decides how soon a search
// ends, no answer.
constexpr int kMostFeatureRounds = 4;
constexpr double kTilt = 0x1p-20;
constexpr double kMostTilt = 0x1p-8;
constexpr double kLeastTilt = 0x1p-28;
constexpr double kTiltShare = 0x1p-2;

/// Holds the directions of a face's edges.
class Edges {
 public:
  explicit Edges(const ContactFace& face) {
    if (face.count < 2) return;
    count_ = face.count == 2 ? 1 : face.count;
    for (int i = 0; i < count_; ++i)
      edge_[i] = unit_or(face.corner[(i + 1) % face.count] - face.corner[i], {});
  }
  const Vec3* begin() const { return edge_; }
  const Vec3* end() const { return edge_ + count_; }

 private:
  Vec3 edge_[ContactFace::kMostCorners];
  int count_ = 0;
};

class Search {
 public:
  Search(const Core& a, const Core& b, const GapGoal& goal)
      : a_(a), b_(b), goal_(goal), scale_(pair_scale(a, b)), slack_(kRelativeSlack * scale_) {
    // The unit is a power of two, so that scaling rounds nothing and no product of six lengths
    // overflows.
    int exponent = 0;
    std::frexp(scale_, &exponent);
    to_units_ = std::ldexp(1.0, -exponent);
    const double sizes = (a.bounding_radius + b.bounding_radius) + (a.radius + b.radius);
    extent_units_ = (sizes + length(b.at - a.at)) * to_units_;
    slack_units_ = slack_ * to_units_;
  }

  CoreGap run() {
    start();
    for (int round = 0;; ++round) {
      if (descend() == Step::Inside) return touching();
      if (is_settled() || round == kMostFeatureRounds) break;
      Step found = look_along_features();
      if (found == Step::None && !is_settled()) found = look_about_edges();
      if (found == Step::None && !is_settled()) found = meet_in_faces();
      if (found == Step::Inside) return touching();
      if (found == Step::None) break;
    }
    return finish();
  }

 private:
  enum class Step { Inside, Nearer, None };

  void start() {
    bound_along(unit_or(b_.at - a_.at, {1, 0, 0}));
    add_candidate();
    simplex_.weight[0] = 1;
    nearest_ = {simplex_.point[0], simplex_.point[0]};
    upper_ = length(nearest_.point);
  }

  /// Runs GJK from the simplex at hand, until it gains nothing or has taken kLargestSteps. The
  /// answer is Inside if the cores touch.
  Step descend() {
    for (int step = 0; step < kLargestSteps; ++step) {
      if (!(upper_ > slack_units_)) return Step::Inside;
      look_along(unit_or(-nearest_.direction, {1, 0, 0}));
      if (is_enough() || !(upper_ - lower_ > kRelativeGoal * upper_ + slack_units_)) break;
      Step found = step_to_candidate();
      if (found == Step::Inside) return found;
      if (found == Step::Nearer) {
        is_flat_ = false;
        continue;
      }
      // There is no progress. The normal of a flat face may point anywhere: the point itself may do
      // better.
      if (is_flat_) {
        if (is_known()) break;
        found = look_across_faces();
        if (found == Step::Nearer) continue;
        return found;
      }
      is_flat_ = true;
      nearest_.direction = nearest_.point;
    }
    return Step::None;
  }

  /// Takes the candidate in if that brings the nearest point nearer.
  Step step_to_candidate() {
    if (is_repeated()) return Step::None;
    const DifferenceSimplex before = simplex_;
    add_candidate();
    NearestPoint next;
    const bool is_inside = reduce_to_nearest(simplex_, next) == OriginSide::Inside;
    // Planes that part the two are a proof; a tetrahedron as flat as rounding is none against it.
    if (is_inside && !(lower_ > slack_units_)) return Step::Inside;
    if (!is_inside && dot(next.point, next.point) < upper_ * upper_) {
      nearest_ = next;
      upper_ = length(next.point);
      return Step::Nearer;
    }
    simplex_ = before;
    return Step::None;
  }

  /// Where a gap is small a direction that is off by an angle leaves the nearest point farther by
  /// the square of the angle alone, which may be less than rounding, while the bound of the planes
  /// is off by the angle. So the faces that the candidate makes with the simplex tell the direction
  /// when its point does not: their normals are asked until the bound stays, or one leads nearer.
  Step look_across_faces() {
    for (int round = 0; round < kMostRounds; ++round) {
      const double before = lower_;
      const Vec3 apex = candidate_;
      Vec3 best = candidate_, best_a = candidate_a_, best_b = candidate_b_;
      for (int i = 0; i < simplex_.count; ++i) {
        for (int j = i + 1; j < simplex_.count; ++j) {
          const Vec3& p = simplex_.point[i];
          const Vec3 normal = unit_or(cross(simplex_.point[j] - p, apex - p), {});
          if (!(largest(normal) > 0)) continue;
          const double bound = lower_;
          look_along(dot(normal, p) > 0 ? -normal : normal);
          if (lower_ > bound) best = candidate_, best_a = candidate_a_, best_b = candidate_b_;
          const Step step = step_to_candidate();
          if (step != Step::None) return step;
        }
      }
      if (is_enough() || !(lower_ - before > kWorthwhile * (upper_ - lower_))) break;
      candidate_ = best, candidate_a_ = best_a, candidate_b_ = best_b;
    }
    return Step::None;
  }

  /// Where an edge of one lies along an edge or a side of the other the nearest points are many,
  /// and steps from some of them to others gain less and less. So the normals of the faces at hand
  /// are asked, and the directions at right angles to their edges, which bound the gap from below,
  /// and those that lead a little towards the ends of each edge, whose corners hold the points.
  Step look_along_features() {
    const double before = upper_ - lower_;
    const Vec3 toward = lower_ > 0 ? normal_ : unit_or(-nearest_.point, {1, 0, 0});
    const ContactFace faces[2] = {face_along(a_, toward), face_along(b_, -toward)};
    for (int side = 0; side < 2; ++side) {
      const ContactFace& face = faces[side];
      if (face.count < 2) continue;
      if (try_along(side == 0 ? face.normal : -face.normal) == Step::Inside) return Step::Inside;
      for (const Vec3& edge : Edges(face)) {
        const Vec3 across = lower_ > 0 ? normal_ : toward;
        for (const Vec3& direction :
             {across - edge * dot(across, edge), across + edge * kTilt, across - edge * kTilt}) {
          if (try_along(unit_or(direction, across)) == Step::Inside) return Step::Inside;
        }
      }
    }
    if (look_around() == Step::Inside) return Step::Inside;
    return before - (upper_ - lower_) > kWorthwhile * before ? Step::Nearer : Step::None;
  }

  /// Looks along the best direction so far, tilted to four sides, by less and less: round sides
  /// have no edges.
  Step look_around() {
    const Vec3 first = lower_ > 0 ? normal_ : unit_or(-nearest_.point, {1, 0, 0});
    const Vec3 side = any_normal_to(first);
    const Vec3 across = cross(first, side);
    for (double tilt = kMostTilt; tilt > kLeastTilt; tilt *= kTiltShare) {
      for (const Vec3& aside : {side, -side, across, -across}) {
        const Vec3 base = lower_ > 0 ? normal_ : first;
        if (try_along(unit_or(base + aside * tilt, base)) == Step::Inside) return Step::Inside;
      }
      if (is_settled()) break;
    }
    return Step::None;
  }

  /// A direction that leans along an edge is off by as much as it leans, and one that leans about
  /// it is off by the square of that alone. So the directions at right angles to an edge of either
  /// are asked, and for each edge those about it, nearer and nearer to the best.
  Step look_about_edges() {
    const double before = upper_ - lower_;
    const Edges of_a(face_along(a_, normal_)), of_b(face_along(b_, -normal_));
    for (const Vec3& edge_a : of_a) {
      for (const Vec3& edge_b : of_b) {
        const Vec3 normal = unit_or(cross(edge_a, edge_b), normal_);
        if (try_along(dot(normal, normal_) < 0 ? -normal : normal) == Step::Inside)
          return Step::Inside;
      }
    }
    for (const Edges* edges : {&of_a, &of_b}) {
      for (const Vec3& edge : *edges) {
        if (look_about(edge) == Step::Inside) return Step::Inside;
      }
    }
    return before - (upper_ - lower_) > kWorthwhile * before ? Step::Nearer : Step::None;
  }

  Step look_about(const Vec3& edge) {
    for (double tilt = kMostTilt; tilt > kLeastTilt && !is_settled(); tilt *= kTiltShare) {
      for (const double sign : {-1.0, 1.0}) {
        const Vec3 across = normal_ - edge * dot(normal_, edge);
        const Vec3 tilted = across + cross(edge, across) * (sign * tilt);
        if (try_along(unit_or(tilted, normal_)) == Step::Inside) return Step::Inside;
      }
    }
    return Step::None;
  }

  /// Where round sides all but touch, a direction is better known than the points that it leads to,
  /// which are off by its error and never lead nearer by more than rounding. So the nearest points
  /// of the faces that look along it are taken: few corners, all of them points of the cores.
  Step meet_in_faces() {
    const Vec3 toward = normal_;
    Vec3 corners[2][kMostOfFace];
    const Core of_a = part_along(a_, toward, corners[0]);
    const Core of_b = part_along(b_, -toward, corners[1]);
    Search parts(of_a, of_b, goal_);
    parts.start();
    const bool is_inside = parts.descend() == Step::Inside;
    if (is_inside ? lower_ > slack_units_ : !(parts.upper_ < upper_)) return Step::None;
    simplex_ = parts.simplex_;
    nearest_ = parts.nearest_;
    if (is_inside) return Step::Inside;
    upper_ = parts.upper_;
    return Step::Nearer;
  }

  static constexpr std::size_t kMostOfFace = ContactFace::kMostCorners + 1;

  /// Returns as corners the face that looks along a direction, and the farthest point, in a core of
  /// the same size, so that both are measured in the same units.
  static Core part_along(const Core& core, const Vec3& toward, Vec3 (&corners)[kMostOfFace]) {
    Core part;
    part.kind = CoreKind::Points;
    part.at = core.at;
    part.radius = core.radius;
    part.bounding_radius = core.bounding_radius;
    part.points = corners;
    corners[part.point_count++] = support(core, toward) - core.at;
    if (core.kind == CoreKind::Point) return part;
    if (core.kind == CoreKind::Segment) {
      corners[part.point_count++] = support(core, -toward) - core.at;
      return part;
    }
    const ContactFace face = face_along(core, toward);
    for (int i = 0; i < face.count; ++i)
      corners[part.point_count++] = face.corner[i] - core.at;
    return part;
  }

  Step try_along(const Vec3& toward) {
    look_along(toward);
    return step_to_candidate();
  }

  /// Evaluates the support along a direction from A to B, in units, and returns how far apart its
  /// two planes are.
  double bound_along(const Vec3& toward) {
    candidate_a_ = support(a_, toward);
    candidate_b_ = support(b_, -toward);
    candidate_ = (candidate_a_ - candidate_b_) * to_units_;
    return -dot(candidate_, toward) - slack_units_;
  }

  void look_along(const Vec3& toward) {
    const double lower = bound_along(toward);
    if (lower > lower_) lower_ = lower, normal_ = toward;
  }

  void add_candidate() {
    const int i = simplex_.count++;
    simplex_.point[i] = candidate_;
    simplex_.from_a[i] = candidate_a_;
    simplex_.from_b[i] = candidate_b_;
  }

  bool is_repeated() const {
    for (int i = 0; i < simplex_.count; ++i) {
      const Vec3 d = simplex_.point[i] - candidate_;
      if (d.x == 0 && d.y == 0 && d.z == 0) return true;
    }
    return false;
  }

  bool is_enough() const {
    return (goal_.apart_beyond >= 0 && lower_ > goal_.apart_beyond * to_units_) ||
           (goal_.near_enough >= 0 && upper_ <= goal_.near_enough * to_units_);
  }

  bool is_settled() const { return is_known() || is_enough(); }

  bool is_known() const { return upper_ - lower_ <= kRelativeTolerance * extent_units_; }

  CoreGap filled(GapVerdict verdict) const {
    CoreGap gap{};
    gap.verdict = verdict;
    gap.slack = slack_;
    gap.upper = upper_ / to_units_;
    gap.lower = lower_ > 0 ? lower_ / to_units_ : 0;
    for (int i = 0; i < simplex_.count; ++i) {
      gap.point_a = gap.point_a + simplex_.from_a[i] * simplex_.weight[i];
      gap.point_b = gap.point_b + simplex_.from_b[i] * simplex_.weight[i];
    }
    const Vec3 direction = unit_or(-nearest_.direction, unit_or(b_.at - a_.at, {0, 0, 1}));
    gap.normal = lower_ > 0 ? normal_ : direction;
    return gap;
  }

  CoreGap touching() {
    upper_ = 0;
    lower_ = 0;
    return filled(GapVerdict::Touching);
  }

  CoreGap finish() const {
    const bool is_open = !is_settled();
    if (lower_ > 0) return filled(is_open ? GapVerdict::NotReached : GapVerdict::Apart);
    return filled(is_open ? GapVerdict::NotReached : GapVerdict::Touching);
  }

  const Core& a_;
  const Core& b_;
  const GapGoal& goal_;
  double scale_;
  double slack_;
  double to_units_;
  double extent_units_;  ///< the sizes of both and the distance of their middles
  double slack_units_;
  DifferenceSimplex simplex_;
  Vec3 candidate_;
  Vec3 candidate_a_;
  Vec3 candidate_b_;
  NearestPoint nearest_;
  Vec3 normal_;
  bool is_flat_ = false;
  double lower_ = -1;  ///< starts below every bound that could matter
  double upper_ = 0;
};

}  // namespace

CoreGap core_gap(const Core& a, const Core& b, const GapGoal& goal) {
  return Search(a, b, goal).run();
}

}  // namespace graze::narrowphase
