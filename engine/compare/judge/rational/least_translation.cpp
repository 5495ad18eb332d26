#include <graze/engine/compare/judge/rational/least_translation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace graze::compare {
namespace {

/// So many hits give directions by their triangles, and keep their slabs.
constexpr std::size_t kMaxKnown = 64;

/// So many pairs are looked at for the size of an error that is not one of rounding.
constexpr std::size_t kMaxEffort = 4096;

/// Directions nearer to each other than this are one.
constexpr double kSameDirection = 0x1p-30;

/// Returns the normals of the facets of the difference of two triangles; if these are in parallel
/// planes, those within the plane, too.
std::vector<RationalPoint> axes_of(const RationalTriangle& a, const RationalTriangle& b) {
  const RationalPoint normal_a = cross(edge_of(a, 0), edge_of(a, 1));
  const RationalPoint normal_b = cross(edge_of(b, 0), edge_of(b, 1));
  std::vector<RationalPoint> axes = {normal_a, normal_b};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      axes.push_back(cross(edge_of(a, i), edge_of(b, j)));
  }
  if (is_zero(cross(normal_a, normal_b))) {
    for (std::size_t i = 0; i < 3; ++i) {
      axes.push_back(cross(normal_a, edge_of(a, i)));
      axes.push_back(cross(normal_b, edge_of(b, i)));
    }
  }
  axes.erase(std::remove_if(axes.begin(), axes.end(), is_zero), axes.end());
  return axes;
}

Eigen::Vector3d rounded_unit(const RationalPoint& p) {
  // They are divided first: numbers beyond the range of doubles have a direction, too.
  mpq_class largest = 0;
  for (const mpq_class& x : p)
    largest = std::max<mpq_class>(largest, abs(x));
  if (largest == 0) return Eigen::Vector3d::Zero();
  const auto component = [&](std::size_t i) { return mpq_class(p[i] / largest).get_d(); };
  return Eigen::Vector3d(component(0), component(1), component(2)).normalized();
}

/// A triangle with the box of another, moved and a little larger, whatever rounding does.
Triangle moved_box(const Triangle& t, const Eigen::Vector3d& by) {
  Triangle box;
  for (int axis = 0; axis < 3; ++axis) {
    const double least = std::min({t.a[axis], t.b[axis], t.c[axis]});
    const double most = std::max({t.a[axis], t.b[axis], t.c[axis]});
    const double slack =
        0x1p-48 * (std::max(std::abs(least), std::abs(most)) + std::abs(by[axis])) + 0x1p-1000;
    box.a[axis] = least + by[axis] - slack;
    box.b[axis] = box.c[axis] = most + by[axis] + slack;
  }
  return box;
}

}  // namespace

LeastTranslation::LeastTranslation(const MeshReferee& referee,
                                   const std::vector<TrianglePair>& hits)
    : referee_(referee), hits_(hits) {
  const std::size_t known = std::min(hits.size(), kMaxKnown);
  for (std::size_t i = 0; i < known; ++i) {
    known_slabs_.push_back(
        slabs_of(exactly(referee.triangle_a(hits[i].a)), exactly(referee.triangle_b(hits[i].b))));
    add_directions(i);
  }
  for (int axis = 0; axis < 3; ++axis)
    add_direction(Eigen::Vector3d::Unit(axis));
}

std::vector<LeastTranslation::Slab> LeastTranslation::slabs_of(const RationalTriangle& a,
                                                               const RationalTriangle& b) {
  std::vector<Slab> slabs;
  for (RationalPoint& axis : axes_of(a, b)) {
    const Extent in_a = extent_of(a, axis);
    const Extent in_b = extent_of(b, axis);
    slabs.push_back({std::move(axis), in_a.min - in_b.max, in_a.max - in_b.min});
  }
  return slabs;
}

LeastTranslation::Interval LeastTranslation::interval_of(const std::vector<Slab>& slabs,
                                                         const RationalPoint& direction) {
  Interval result;
  bool has_slab = false;
  for (const Slab& slab : slabs) {
    const mpq_class speed = dot(slab.normal, direction);
    if (speed == 0) {
      if (slab.low > 0 || slab.high < 0) result.is_empty = true;
      continue;
    }
    const mpq_class at_low = slab.low / speed;
    const mpq_class at_high = slab.high / speed;
    const mpq_class& first = speed > 0 ? at_low : at_high;
    const mpq_class& last = speed > 0 ? at_high : at_low;
    if (!has_slab || first > result.first) result.first = first;
    if (!has_slab || last < result.last) result.last = last;
    has_slab = true;
  }
  result.is_bounded = has_slab;
  if (has_slab && result.first > result.last) result.is_empty = true;
  return result;
}

LeastTranslation::Interval LeastTranslation::interval_of(std::size_t hit,
                                                         const RationalPoint& direction) {
  if (hit < known_slabs_.size()) return interval_of(known_slabs_[hit], direction);
  return interval_of(hits_[hit], direction);
}

LeastTranslation::Interval LeastTranslation::interval_of(const TrianglePair& pair,
                                                         const RationalPoint& direction) const {
  return interval_of(
      slabs_of(exactly(referee_.triangle_a(pair.a)), exactly(referee_.triangle_b(pair.b))),
      direction);
}

void LeastTranslation::add_direction(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d opposite = -direction;
  for (const Eigen::Vector3d& candidate : {direction, opposite}) {
    if (!candidate.allFinite() || candidate.isZero()) continue;
    const bool is_known =
        std::any_of(directions_.begin(), directions_.end(), [&](const Eigen::Vector3d& known) {
          return (known - candidate).cwiseAbs().maxCoeff() < kSameDirection;
        });
    if (!is_known) directions_.push_back(candidate);
  }
}

void LeastTranslation::add_directions(std::size_t hit) {
  const mpq_class unknown = -1;
  mpq_class best = unknown;
  RationalPoint soonest;
  for (const Slab& slab : known_slabs_[hit]) {
    const mpq_class length = dot(slab.normal, slab.normal);
    for (const mpq_class& offset : {slab.low, slab.high}) {
      const mpq_class square = offset * offset / length;
      if (best != unknown && square >= best) continue;
      best = square;
      soonest = slab.normal;
    }
  }
  if (best != unknown) add_direction(rounded_unit(soonest));
  const RationalTriangle a = exactly(referee_.triangle_a(hits_[hit].a));
  const RationalTriangle b = exactly(referee_.triangle_b(hits_[hit].b));
  const Eigen::Vector3d normal_a = rounded_unit(cross(edge_of(a, 0), edge_of(a, 1)));
  const Eigen::Vector3d normal_b = rounded_unit(cross(edge_of(b, 0), edge_of(b, 1)));
  add_direction(normal_a);
  add_direction(normal_b);
  // This leads out of a corner: away from both of its faces.
  if (directions_.size() < 2 * kMaxKnown) {
    add_direction((normal_a + normal_b).normalized());
    add_direction((normal_a - normal_b).normalized());
  }
}

/// Returns how far B must go until a plane across the direction parts the two.
double LeastTranslation::length_along(const Eigen::Vector3d& direction) const {
  double most_a = -std::numeric_limits<double>::infinity();
  double least_b = std::numeric_limits<double>::infinity();
  for (const Triangle& t : referee_.triangles_a())
    most_a = std::max({most_a, direction.dot(t.a), direction.dot(t.b), direction.dot(t.c)});
  for (const Triangle& t : referee_.triangles_b())
    least_b = std::min({least_b, direction.dot(t.a), direction.dot(t.b), direction.dot(t.c)});
  return std::max(most_a - least_b, 0.0);
}

bool LeastTranslation::may_look() {
  if (effort_ == 0) return false;
  --effort_;
  return true;
}

std::optional<mpq_class> LeastTranslation::march(const Eigen::Vector3d& direction,
                                                 const mpq_class& limit) {
  const RationalPoint d = exactly(direction);
  const mpq_class length = dot(d, d);
  const auto is_too_far = [&](const mpq_class& t) { return t * t * length > limit; };
  mpq_class t = 0;
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (i >= known_slabs_.size() && !may_look()) return std::nullopt;
    const Interval interval = interval_of(i, d);
    if (!interval.is_bounded || is_too_far(interval.last)) return std::nullopt;
    t = std::max(t, interval.last);
  }
  const BoxTree tree_a(referee_.triangles_a());
  std::vector<Triangle> moved(referee_.triangles_b().size());
  while (true) {
    std::transform(referee_.triangles_b().begin(), referee_.triangles_b().end(), moved.begin(),
                   [&](const Triangle& b) { return moved_box(b, t.get_d() * direction); });
    const BoxTree tree_b(moved);
    mpq_class next = t;
    bool is_over = false;
    BoxTree::for_each_overlap(tree_a, tree_b, [&](std::uint32_t a, std::uint32_t b) {
      const Interval interval = interval_of(TrianglePair{a, b}, d);
      const bool meets = !interval.is_empty && interval.first <= t;
      if (meets && interval.last > next) next = interval.last;
      const bool is_endless = !interval.is_empty && !interval.is_bounded;
      is_over = is_endless || is_too_far(next) || !may_look();
      return !is_over;
    });
    if (is_over) return std::nullopt;
    if (next == t) return mpq_class(t * t * length);
    t = next;
  }
}

std::optional<double> LeastTranslation::find_within(double limit) {
  std::optional<mpq_class> best;
  mpq_class square = mpq_class(limit) * mpq_class(limit);
  for (const Eigen::Vector3d& direction : directions_) {
    effort_ = std::numeric_limits<std::size_t>::max();
    const std::optional<mpq_class> found = march(direction, square);
    if (!found) continue;
    best = found;
    square = *found;
    if (square == 0) break;
  }
  if (!best) return std::nullopt;
  return rounded_root(*best);
}

double LeastTranslation::find() {
  struct Candidate {
    double length;
    Eigen::Vector3d direction;
  };
  std::vector<Candidate> candidates;
  for (const Eigen::Vector3d& direction : directions_)
    candidates.push_back({length_along(direction), direction});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  double best = candidates.front().length;
  if (!std::isfinite(best)) return best;
  effort_ = kMaxEffort;
  for (const Candidate& candidate : candidates) {
    if (effort_ == 0) break;
    const std::optional<mpq_class> square =
        march(candidate.direction, mpq_class(best) * mpq_class(best));
    if (square) best = std::min(best, rounded_root(*square));
  }
  return best;
}

}  // namespace graze::compare
