#include <graze/narrowphase/convex/contact/clip.h>
#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/contact/touches.h>
#include <graze/narrowphase/convex/gap/closed_gap.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <span>

namespace graze::narrowphase {
namespace {

// Below this share of the smaller set's size a difference of depth is of no account: far more than
// EPA's tolerance, far less than anything modelled.
constexpr double kSameDepth = 1e-6;

// Points of a clipped face that are this share of the scale short of touching still touch: what
// kTouchTolerance of engine/world allows a hit to be.
constexpr double kTouching = 0x1p-34;

// What gaps and their normals are known to, as a share of the scale; a normal's own error is that
// of the points over the gap, so that of gaps below kWellKnown it is looked at.
constexpr double kRoundingOfGaps = 0x1p-40;
constexpr double kWellKnown = 0x1p-10;

// A face takes part if its normal is within 8 degrees of the contact's.
constexpr double kFacing = 0.99;

// Edges of two faces coincide where they are this share of the smaller set's size apart: far more
// than what jitters in a stack, less than anyone sees of a contact that is moved by so much.
constexpr double kCoinciding = 0x1p-8;

// Squares of distances are the same to this share of them.
constexpr double kSame = 1e-4;

// Depths are the same to this share of the contacts' spread. It is given away twice: where corners
// of a face stand for the deepest point, and where one corner stands for the deepest. That spread s
// is of all that is offered, from the first of them. The first that is kept has one s / 2 from it,
// which is kept, too; and the deepest, where it takes the place of its nearest, is s / 4 from one
// of these two. So it is 8e-5 of the spread of those that are left: find_contacts() promises 1e-4.
constexpr double kSameDepths = 1e-5;

// Contacts are level where their depths are within this share of their spread.
constexpr double kLevel = 0.01;

// A contact is one of the outermost at this share of the greatest square from the middle.
constexpr double kOuter = 0.9;

// Segments are one line where the sine between them is below this.
constexpr double kOneLine = 0.02;

/// Takes a face's normal instead, if it costs no more depth, or none that is not allowed: the
/// polytope comes only near it.
void settle_on_faces(const Core& a, const Core& b, Penetration& way) {
  const double allowance = depth_tolerance(a, b);
  const Vec3 found = way.normal;
  double limit = way.is_open ? way.depth : way.lower + allowance;
  for (const Vec3& normal : {face_along(a, found).normal, -face_along(b, -found).normal}) {
    if (dot(normal, found) < kFacing) continue;
    Penetration settled = along(a, b, normal);
    if (settled.depth > limit || settled.depth < 0) continue;
    settled.source = way.source;
    settled.is_open = way.is_open;
    settled.lower = way.lower;
    way = settled;
    limit = settled.depth - allowance;  // the second face must be better than the first
  }
}

enum class Reference { A, B, None };

/// Of two sets of one size the one whose face cuts the other's, by where the normal leads: which of
/// the two is called A may change with each step. No normal along an axis or midway between axes is
/// near where this changes.
Reference by_size(const Core& a, const Core& b, const Vec3& normal) {
  if (a.reach != b.reach) return b.reach > a.reach ? Reference::B : Reference::A;
  return dot(normal, {1, 2, 4}) < 0 ? Reference::B : Reference::A;
}

/// Which face cuts the other: the one that is more nearly at right angles to the normal; of equals
/// the larger set's, so that it stays the same from step to step.
Reference choose(const ContactFace& face_a, const ContactFace& face_b, const Core& a, const Core& b,
                 const Vec3& normal) {
  const double of_a = face_a.count > 2 ? dot(face_a.normal, normal) : -1;
  const double of_b = face_b.count > 2 ? -dot(face_b.normal, normal) : -1;
  if (of_a >= kFacing || of_b >= kFacing) {
    constexpr double kEqual = 1e-3;
    if (std::abs(of_a - of_b) < kEqual) return by_size(a, b, normal);
    return of_a > of_b ? Reference::A : Reference::B;
  }
  if (face_a.count != 2 || face_b.count != 2) return Reference::None;
  if (dot(face_a.normal, normal) < kFacing || -dot(face_b.normal, normal) < kFacing) {
    return Reference::None;
  }
  const Vec3 line_a = unit_or(face_a.corner[1] - face_a.corner[0], normal);
  const Vec3 line_b = unit_or(face_b.corner[1] - face_b.corner[0], normal);
  if (length(cross(line_a, line_b)) > kOneLine) return Reference::None;
  return by_size(a, b, normal);
}

std::uint64_t feature(std::uint32_t face, std::uint32_t part) {
  return (static_cast<std::uint64_t>(face) << 32) | part;
}

// What stands for a whole face.
constexpr std::uint32_t kWhole = 0x20000;

struct Tolerances {
  double touching;
  double coinciding;
};

/// The clipped corners of the incident face that are behind the reference's, whose outward sense
/// along the normal is `sign`: 1 if it is A's. What is clipped along the normal lies, where that
/// leads, in both faces.
void add_clipped(const FaceOf& incident, const FaceOf& reference, const Penetration& way,
                 double sign, const Tolerances& tolerance, std::vector<ContactPoint>& touches) {
  const ContactFace& sides = reference.face;
  const Vec3 out = way.normal * sign;
  const ClippedFace clipped = clip(incident.face, sides, out, tolerance.coinciding);
  const double facing = dot(sides.normal, out);
  for (int i = 0; i < clipped.count; ++i) {
    const ClippedFace::Corner& corner = clipped.corner[i];
    ContactPoint touch;
    touch.normal = way.normal;
    touch.depth = dot(sides.normal, sides.corner[0] - corner.point) / facing;
    const Vec3 met = corner.point + out * touch.depth;
    touch.point_a = sign > 0 ? met : corner.point;
    touch.point_b = sign > 0 ? corner.point : met;
    if (sides.count == 2 && !settle_between(incident, reference, sign, tolerance.touching, touch))
      continue;
    if (touch.depth < -tolerance.touching) continue;
    touch.depth = std::clamp(touch.depth, 0.0, std::max(way.depth, 0.0));
    const std::uint64_t of_incident = feature(incident.face.id, corner.own);
    const std::uint64_t of_reference = feature(sides.id, corner.other != 0 ? corner.other : kWhole);
    touch.feature_a = sign > 0 ? of_reference : of_incident;
    touch.feature_b = sign > 0 ? of_incident : of_reference;
    touches.push_back(touch);
  }
}

/// One point of each, where the two meet once B is moved out along the way.
void add_single(const Core& a, const Core& b, const Parting& parting,
                std::vector<ContactPoint>& touches) {
  const Penetration& way = parting.way;
  const MeetingPoints met =
      parting.has_witnesses ? MeetingPoints{way.point_a, way.point_b} : meeting_points(a, b, way);
  touches.push_back({met.on_a, met.on_b, way.normal, way.depth, kPointFeature, kPointFeature});
}

}  // namespace

Parting part_boxes(const BoxAxes& boxes) {
  Parting parting;
  parting.way = boxes.least_way();
  parting.way.depth = std::max(parting.way.depth, 0.0);
  parting.has_witnesses =
      parting.way.has_witnesses && lie_along(parting.way, kTouching * boxes.scale());
  return parting;
}

namespace {

/// Along the way between cores that are apart, or nearly so. False if that is not the least way to
/// depth_tolerance().
bool part_along_gap(const Core& a, const Core& b, const CoreGap& gap, Parting& parting) {
  const double radii = a.radius + b.radius;
  const double scale = pair_scale(a, b);
  if (!(gap.upper > kRoundingOfGaps * scale || (radii == 0 && gap.upper > 0))) return false;
  const Vec3 between = unit_or(gap.point_b - gap.point_a, gap.normal);
  Penetration& way = parting.way;
  way.normal = gap.lower > 0 ? gap.normal : between;
  way.depth = radii - gap.upper;  // which is no more than the least
  // Planes at right angles to the normal are as far apart as the bound says, which is then enough.
  if (gap.upper - gap.lower <= kRoundingOfGaps * scale && gap.upper > kWellKnown * scale)
    return true;
  if (gap.lower > 0) way.normal = settled_normal(a, b, gap);
  const double along_normal = along(a, b, way.normal).depth;
  if (along_normal - way.depth > depth_tolerance(a, b)) return false;
  if (along_normal - way.depth > kRoundingOfGaps * scale) way.depth = along_normal;
  return true;
}

}  // namespace

Parting part(const Core& a, const Core& b, const CoreGap& gap) {
  Parting parting;
  Penetration& way = parting.way;
  if (part_along_gap(a, b, gap, parting)) {
    way.depth = std::max(way.depth, 0.0);
    way.point_a = gap.point_a + way.normal * a.radius;
    way.point_b = gap.point_b - way.normal * b.radius;
    parting.has_witnesses = gap.verdict == GapVerdict::Apart;
    return parting;
  }
  if (a.kind == CoreKind::Box && b.kind == CoreKind::Box) {
    return part_boxes(BoxAxes(a, b));
  } else if (a.kind == CoreKind::Box && b.kind == CoreKind::Point) {
    way = nearest_face(a, b);
  } else if (a.kind == CoreKind::Point && b.kind == CoreKind::Box) {
    const Penetration found = nearest_face(b, a);
    way = {-found.normal, found.depth, found.point_b, found.point_a, found.source, false};
  } else {
    way = penetration(a, b);
    parting.is_asked = true;
    // Between points and segments no polytope proves that the cores meet: the gap tells how nearly.
    const double least = a.radius + b.radius - gap.upper;
    const bool is_unproved =
        way.source == PenetrationSource::Fixed && way.depth - least > depth_tolerance(a, b);
    parting.is_failed = way.is_open || is_unproved;
    settle_on_faces(a, b, way);
  }
  way.depth = std::max(way.depth, 0.0);
  return parting;
}

void add_face_touches(const Core& a, const Core& b, const Penetration& way,
                      std::vector<ContactPoint>& touches) {
  const auto has_face = [](const Core& core) {
    return core.kind != CoreKind::Point && core.kind != CoreKind::Ellipsoid;
  };
  if (!has_face(a) || !has_face(b)) return;
  const Vec3& normal = way.normal;
  const ContactFace face_a = face_along(a, normal);
  const ContactFace face_b = face_along(b, -normal);
  if (face_a.count == 1 || face_b.count == 1) return;
  const Tolerances tolerance{kTouching * pair_scale(a, b), kCoinciding * smaller_size(a, b)};
  switch (choose(face_a, face_b, a, b, normal)) {
    case Reference::A:
      add_clipped({face_b, b}, {face_a, a}, way, 1, tolerance, touches);
      break;
    case Reference::B:
      add_clipped({face_a, a}, {face_b, b}, way, -1, tolerance, touches);
      break;
    case Reference::None:
      break;
  }
}

namespace {

double square_between(const ContactPoint& s, const ContactPoint& t) {
  const Vec3 way = middle_of(s) - middle_of(t);
  return dot(way, way);
}

/// The least depth and the greatest, and how far the contacts are spread.
struct Extent {
  double shallowest = std::numeric_limits<double>::infinity();
  double deepest = -1;
  double spread = 0;
};

Extent extent_of(std::span<const ContactPoint> touches) {
  Extent extent;
  for (const ContactPoint& touch : touches) {
    extent.shallowest = std::min(extent.shallowest, touch.depth);
    extent.deepest = std::max(extent.deepest, touch.depth);
    extent.spread = std::max(extent.spread, square_between(touch, touches[0]));
  }
  extent.spread = std::sqrt(extent.spread);
  return extent;
}

}  // namespace

void add_touches(const Core& a, const Core& b, const Parting& parting,
                 std::vector<ContactPoint>& touches) {
  const std::size_t before = touches.size();
  add_face_touches(a, b, parting.way, touches);
  // What the corners of a face leave out, above all of a round one, is the deepest point itself.
  const Extent extent = extent_of(std::span(touches).subspan(before));
  const double missed = parting.way.depth - extent.deepest;
  if (extent.deepest < 0 ||
      missed > std::max(kSameDepth * smaller_size(a, b), kSameDepths * extent.spread))
    add_single(a, b, parting, touches);
}

namespace {

bool comes_before(const ContactPoint& s, const ContactPoint& t) {
  if (s.feature_a != t.feature_a) return s.feature_a < t.feature_a;
  if (s.feature_b != t.feature_b) return s.feature_b < t.feature_b;
  return s.depth > t.depth;
}

using Points = std::vector<ContactPoint>;

/// Moves it to the front of those that are not kept yet, which stay in the order of their features.
void keep(Points& touches, std::size_t kept, std::size_t next) {
  const auto at = [&](std::size_t i) { return touches.begin() + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(kept), at(next), at(next + 1));
}

/// Beside the first, which is kept, whichever is farthest from all that are, until there are
/// `most`.
void keep_farthest(Points& touches, std::size_t most) {
  for (std::size_t kept = 1; kept < most; ++kept) {
    const auto away = [&](std::size_t i) {
      double least = square_between(touches[i], touches[0]);
      for (std::size_t j = 1; j < kept; ++j)
        least = std::min(least, square_between(touches[i], touches[j]));
      return least;
    };
    std::size_t next = kept;
    double farthest = away(kept);
    for (std::size_t i = kept + 1; i < touches.size(); ++i) {
      const double square = away(i);
      if (square > farthest * (1 + kSame)) farthest = square, next = i;
    }
    keep(touches, kept, next);
  }
}

/// The first of those that are about as far from the middle of all as any is.
std::size_t outermost(const Points& touches) {
  Vec3 middle{0, 0, 0};
  for (const ContactPoint& touch : touches)
    middle = middle + middle_of(touch) * (1.0 / static_cast<double>(touches.size()));
  const auto away = [&](const ContactPoint& touch) {
    const Vec3 way = middle_of(touch) - middle;
    return dot(way, way);
  };
  double farthest = 0;
  for (const ContactPoint& touch : touches)
    farthest = std::max(farthest, away(touch));
  std::size_t at = 0;
  while (!(away(touches[at]) >= kOuter * farthest))
    ++at;
  return at;
}

std::size_t first_so_deep(const Points& touches, double depth) {
  std::size_t at = 0;
  while (touches[at].depth < depth)
    ++at;
  return at;
}

}  // namespace

// Depths and distances that are nearly equal count as equal, and then the lower feature is taken:
// otherwise which four of the corners of a round cap are left would change with every rounding.
// Where all are level one of the outermost is the first to stay, as which is deepest changes with
// every jitter; and the deepest takes the place of the one next to it, if none is so deep.
void reduce(Points& touches, std::size_t most) {
  std::sort(touches.begin(), touches.end(), comes_before);
  if (touches.size() > most) {
    const Extent extent = extent_of(touches);
    const double deep_enough = extent.deepest - kSameDepths * extent.spread;
    const bool is_level = extent.deepest - extent.shallowest < kLevel * extent.spread;
    keep(touches, 0, is_level ? outermost(touches) : first_so_deep(touches, deep_enough));
    keep_farthest(touches, most);
    const std::size_t deepest = first_so_deep(touches, deep_enough);
    if (deepest >= most) {
      const auto end = touches.begin() + static_cast<std::ptrdiff_t>(most);
      *std::min_element(touches.begin(), end, [&](const auto& s, const auto& t) {
        return square_between(s, touches[deepest]) < square_between(t, touches[deepest]);
      }) = touches[deepest];
    }
    touches.resize(most);
  }
  std::sort(touches.begin(), touches.end(), [](const ContactPoint& s, const ContactPoint& t) {
    return s.depth != t.depth ? s.depth > t.depth : comes_before(s, t);
  });
}

}  // namespace graze::narrowphase
