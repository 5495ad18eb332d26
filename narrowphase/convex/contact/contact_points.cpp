#include <graze/narrowphase/convex/contact/clip.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/meeting_points.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <span>

namespace graze::narrowphase {
namespace {

// Below this share of the smaller set's size a difference of depth is of no account: far more than
// EPA's tolerance, far less than anything modelled.
constexpr double kSameDepth = 1e-6;

// Points of a clipped face that are this share of the scale short of touching still touch: what
// kTouchTolerance of engine/world allows a hit to be.
constexpr double kTouching = 0x1p-34;

// As a share of that, more than rounding: 2^-46 of the scale.
constexpr double kSlack = 0x1p-12;

// A face takes part if its normal is within 8 degrees of the contact's.
constexpr double kFacing = 0.99;

// Edges of two faces coincide where they are this share of the smaller set's size apart: far more
// than what jitters in a stack, less than anyone sees of a contact that is moved by so much.
constexpr double kCoinciding = 0x1p-8;

// Squares of distances count as equal where they differ by no more than this share of them.
constexpr double kSame = 1e-4;

// Depths are the same to this share of the width of the contact, which is how far from the first
// of its points any other lies. It is given away twice: where corners of a face stand for the
// deepest point, and where one corner stands for the deepest. The width w is that of all points
// that are offered. The first that is kept has one w / 2 from it, which is kept, too; and the
// deepest, where it takes the place of its nearest, is w / 4 from one of these two. So it is 8e-5
// of the width of those that are left: find_contacts() promises 1e-4.
constexpr double kSameDepths = 1e-5;

// Contacts are level where their depths differ by less than this share of their width.
constexpr double kLevel = 0.01;

// A contact is one of the outermost at this share of the greatest square from the middle.
constexpr double kOuter = 0.9;

// Segments are one line where the sine between them is below this.
constexpr double kOneLine = 0.02;

enum class Reference { A, B, None };

/// Of two sets of one size the one whose face cuts the other's, chosen by where the normal leads,
/// because which of the two is called A may change with each step. No normal along an axis or
/// midway between axes is near where this choice changes.
Reference by_size(const Core& a, const Core& b, const Vec3& normal) {
  if (a.bounding_radius != b.bounding_radius)
    return b.bounding_radius > a.bounding_radius ? Reference::B : Reference::A;
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

// Stands for a whole face where a corner or an edge of it would stand.
constexpr std::uint32_t kWhole = 0x20000;

struct Tolerances {
  double touching;
  double coinciding;
  double margin;
};

/// As if A were grown by the margin along the normal. Without one not even a sign of nought
/// changes.
void grow(ContactPoint& contact, double margin) {
  if (!(margin > 0)) return;
  contact.point_a = contact.point_a + contact.normal * margin;
  contact.depth += margin;
}

double grown_depth(const Penetration& penetration, double margin) {
  return margin > 0 ? penetration.depth + margin : penetration.depth;
}

bool is_beyond_an_edge(const ContactFace& face, const Vec3& point, double by) {
  for (int i = 0; i < face.count && face.count > 2; ++i) {
    const Vec3 edge = face.corner[i + 1 == face.count ? 0 : i + 1] - face.corner[i];
    const Vec3 out = cross(edge, face.normal);
    if (dot(point - face.corner[i], out) > by * length(out)) return true;
  }
  return false;
}

/// Brings a corner of the clipped face, and the point of the reference along `out` from it, back
/// from past a sharp corner of the reference. The normal of such a face is no better known than
/// where its edges meet: so the one goes onto an edge itself, the other along its own face. False
/// if that takes it off that face.
bool move_within(const ContactFace& incident, const ContactFace& reference, const Vec3& out,
                 double touching, Vec3& met, Vec3& own) {
  constexpr double kSteep = 0.125;
  const std::optional<Vec3> on_edge = on_nearest_edge(reference, met, out, kSlack * touching);
  if (!on_edge) return true;
  const Vec3 by = *on_edge - met;
  const Vec3 aside = by - out * dot(by, out);
  const double facing = dot(incident.normal, out);
  met = *on_edge;
  own = own + aside;
  if (std::abs(facing) > kSteep) own = own - out * (dot(incident.normal, aside) / facing);
  return !is_beyond_an_edge(incident, own, touching);
}

/// The clipped corners of the incident face that are behind the reference's, whose outward sense
/// along the normal is `sign`: 1 if it is A's. What is clipped along the normal lies, where that
/// leads, in both faces.
void add_clipped(const FaceOf& incident, const FaceOf& reference, const Penetration& penetration,
                 double sign, const Tolerances& tolerance, std::vector<ContactPoint>& contacts) {
  const ContactFace& sides = reference.face;
  const Vec3 out = penetration.normal * sign;
  const ClippedFace clipped = clip(incident.face, sides, out, tolerance.coinciding);
  const double facing = dot(sides.normal, out);
  const CoreKind kind = reference.core.kind;
  const bool has_sharp_corners =
      (kind == CoreKind::Points || kind == CoreKind::Triangle) && is_sharp(sides);
  const CoreKind own_kind = incident.core.kind;
  const bool is_needle =
      has_sharp_corners || is_uneven(incident) || is_uneven(reference) ||
      ((own_kind == CoreKind::Points || own_kind == CoreKind::Triangle) && is_sharp(incident.face));
  for (int i = 0; i < clipped.count; ++i) {
    const ClippedFace::Corner& corner = clipped.corner[i];
    ContactPoint contact;
    contact.normal = penetration.normal;
    contact.depth = dot(sides.normal, sides.corner[0] - corner.point) / facing;
    Vec3 met = corner.point + out * contact.depth, own = corner.point;
    if (has_sharp_corners) {
      if (!move_within(incident.face, sides, out, tolerance.touching, met, own)) continue;
      contact.depth = dot(met - own, out);
    }
    if (is_uneven(reference) || is_uneven(incident)) {
      const std::optional<Vec3> on_reference = onto_surface(reference, met, out);
      const std::optional<Vec3> on_incident = onto_surface(incident, own, -out);
      if (!on_reference || !on_incident) continue;
      met = *on_reference, own = *on_incident;
      contact.depth = dot(met - own, out);
    }
    if (is_needle && !(lies_on(reference, met, tolerance.touching) &&
                       lies_on(incident, own, tolerance.touching)))
      continue;
    contact.point_a = sign > 0 ? met : own;
    contact.point_b = sign > 0 ? own : met;
    if (sides.count == 2 &&
        !move_to_deepest(incident, reference, sign, tolerance.touching, contact))
      continue;
    grow(contact, tolerance.margin);
    if (contact.depth < -tolerance.touching) continue;
    const double deepest = grown_depth(penetration, tolerance.margin);
    contact.depth = std::clamp(contact.depth, 0.0, std::max(deepest, 0.0));
    const std::uint64_t of_incident = feature(incident.face.id, corner.own);
    const std::uint64_t of_reference = feature(sides.id, corner.other != 0 ? corner.other : kWhole);
    contact.feature_a = sign > 0 ? of_reference : of_incident;
    contact.feature_b = sign > 0 ? of_incident : of_reference;
    contacts.push_back(contact);
  }
}

/// One point of each, where the two meet once B is moved out by the penetration.
void add_single(const Core& a, const Core& b, const Parting& parting, double margin,
                std::vector<ContactPoint>& contacts) {
  const Penetration& penetration = parting.penetration;
  const MeetingPoints met = parting.has_witnesses
                                ? MeetingPoints{penetration.point_a, penetration.point_b}
                                : meeting_points(a, b, penetration);
  contacts.push_back(
      {met.on_a, met.on_b, penetration.normal, penetration.depth, kPointFeature, kPointFeature});
  grow(contacts.back(), margin);
  if (margin > 0) contacts.back().depth = std::max(contacts.back().depth, 0.0);
}

/// Planes through the edges of a triangle without any area, but for rounding, bound nothing.
bool has_no_area(const Core& triangle) {
  constexpr double kNoArea = 0x1p-48;
  const Vec3 edge_b = triangle.corner[1] - triangle.corner[0];
  const Vec3 edge_c = triangle.corner[2] - triangle.corner[0];
  const double longest = std::max(largest(edge_b), largest(edge_c));
  return !(longest > 0) ||
         !(largest(cross(edge_b * (1 / longest), edge_c * (1 / longest))) > kNoArea);
}

bool has_face(const Core& core) {
  if (core.kind == CoreKind::Triangle) return !has_no_area(core);
  return core.kind != CoreKind::Point && core.kind != CoreKind::Ellipsoid;
}

}  // namespace

void add_face_contact_points(const Core& a, const Core& b, const Penetration& penetration,
                             std::vector<ContactPoint>& contacts, double margin) {
  if (!has_face(a) || !has_face(b)) return;
  const Vec3& normal = penetration.normal;
  const ContactFace face_a = face_along(a, normal);
  const ContactFace face_b = face_along(b, -normal);
  if (face_a.count == 1 || face_b.count == 1) return;
  const Tolerances tolerance{kTouching * pair_scale(a, b), kCoinciding * smaller_size(a, b),
                             margin};
  switch (choose(face_a, face_b, a, b, normal)) {
    case Reference::A:
      add_clipped({face_b, b}, {face_a, a}, penetration, 1, tolerance, contacts);
      break;
    case Reference::B:
      add_clipped({face_a, a}, {face_b, b}, penetration, -1, tolerance, contacts);
      break;
    case Reference::None:
      break;
  }
}

namespace {

double square_between(const ContactPoint& s, const ContactPoint& t) {
  const Vec3 offset = middle_of(s) - middle_of(t);
  return dot(offset, offset);
}

/// The least depth and the greatest, and how far from the first contact any other lies.
struct Extent {
  double shallowest = std::numeric_limits<double>::infinity();
  double deepest = -1;
  double width = 0;
};

Extent extent_of(std::span<const ContactPoint> contacts) {
  Extent extent;
  for (const ContactPoint& contact : contacts) {
    extent.shallowest = std::min(extent.shallowest, contact.depth);
    extent.deepest = std::max(extent.deepest, contact.depth);
    extent.width = std::max(extent.width, square_between(contact, contacts[0]));
  }
  extent.width = std::sqrt(extent.width);
  return extent;
}

}  // namespace

void add_contact_points(const Core& a, const Core& b, const Parting& parting,
                        std::vector<ContactPoint>& contacts, double margin) {
  const std::size_t before = contacts.size();
  add_face_contact_points(a, b, parting.penetration, contacts, margin);
  // What the corners of a face leave out, above all of a round one, is the deepest point itself.
  const Extent extent = extent_of(std::span(contacts).subspan(before));
  const double missed = grown_depth(parting.penetration, margin) - extent.deepest;
  if (extent.deepest < 0 ||
      missed > std::max(kSameDepth * smaller_size(a, b), kSameDepths * extent.width))
    add_single(a, b, parting, margin, contacts);
}

namespace {

bool comes_before(const ContactPoint& s, const ContactPoint& t) {
  if (s.feature_a != t.feature_a) return s.feature_a < t.feature_a;
  if (s.feature_b != t.feature_b) return s.feature_b < t.feature_b;
  return s.depth > t.depth;
}

using Points = std::vector<ContactPoint>;

/// Moves the contact `next` to the front of those that are not kept yet, which stay in the order of
/// their features.
void keep(Points& contacts, std::size_t kept, std::size_t next) {
  const auto at = [&](std::size_t i) { return contacts.begin() + static_cast<std::ptrdiff_t>(i); };
  std::rotate(at(kept), at(next), at(next + 1));
}

/// Keeps, beside the first, whichever contact is farthest from all that are kept, until there are
/// `most`.
void keep_farthest(Points& contacts, std::size_t most) {
  for (std::size_t kept = 1; kept < most; ++kept) {
    const auto away = [&](std::size_t i) {
      double least = square_between(contacts[i], contacts[0]);
      for (std::size_t j = 1; j < kept; ++j)
        least = std::min(least, square_between(contacts[i], contacts[j]));
      return least;
    };
    std::size_t next = kept;
    double farthest = away(kept);
    for (std::size_t i = kept + 1; i < contacts.size(); ++i) {
      const double square = away(i);
      if (square > farthest * (1 + kSame)) farthest = square, next = i;
    }
    keep(contacts, kept, next);
  }
}

/// The first of the contacts that are about as far from the middle of all as any is.
std::size_t outermost(const Points& contacts) {
  Vec3 middle{0, 0, 0};
  for (const ContactPoint& contact : contacts)
    middle = middle + middle_of(contact) * (1.0 / static_cast<double>(contacts.size()));
  const auto away = [&](const ContactPoint& contact) {
    const Vec3 offset = middle_of(contact) - middle;
    return dot(offset, offset);
  };
  double farthest = 0;
  for (const ContactPoint& contact : contacts)
    farthest = std::max(farthest, away(contact));
  std::size_t at = 0;
  while (!(away(contacts[at]) >= kOuter * farthest))
    ++at;
  return at;
}

std::size_t first_so_deep(const Points& contacts, double depth) {
  std::size_t at = 0;
  while (contacts[at].depth < depth)
    ++at;
  return at;
}

}  // namespace

// Depths and distances that are nearly equal count as equal, and then the lower feature is taken:
// otherwise which four of the corners of a round cap are left would change with every rounding.
// Where all are level one of the outermost is the first to stay, as which is deepest changes with
// every jitter; and the deepest takes the place of the one next to it, if none is so deep.
void reduce(Points& contacts, std::size_t most) {
  std::sort(contacts.begin(), contacts.end(), comes_before);
  if (contacts.size() > most) {
    const Extent extent = extent_of(contacts);
    const double deep_enough = extent.deepest - kSameDepths * extent.width;
    const bool is_level = extent.deepest - extent.shallowest < kLevel * extent.width;
    keep(contacts, 0, is_level ? outermost(contacts) : first_so_deep(contacts, deep_enough));
    keep_farthest(contacts, most);
    const std::size_t deepest = first_so_deep(contacts, deep_enough);
    if (deepest >= most) {
      const auto end = contacts.begin() + static_cast<std::ptrdiff_t>(most);
      *std::min_element(contacts.begin(), end, [&](const auto& s, const auto& t) {
        return square_between(s, contacts[deepest]) < square_between(t, contacts[deepest]);
      }) = contacts[deepest];
    }
    contacts.resize(most);
  }
  std::sort(contacts.begin(), contacts.end(), [](const ContactPoint& s, const ContactPoint& t) {
    return s.depth != t.depth ? s.depth > t.depth : comes_before(s, t);
  });
}

}  // namespace graze::narrowphase
