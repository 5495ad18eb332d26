#include <graze/narrowphase/convex/contact/clip.h>
#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/contact/deepest_of_faces.h>
#include <graze/narrowphase/convex/contact/meeting_points.h>
#include <graze/narrowphase/convex/contact/point_name.h>
#include <graze/narrowphase/convex/contact/reduction.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace graze::narrowphase {
namespace {

// Contacts of faces nearly say how deep the two are where the deepest point is deeper by less than
// one of these shares: of the smaller set's size, or of the width of the contact, which is how far
// from the first of its points any other lies. Both are far more than EPA's tolerance, far less
// than anything modelled.
constexpr double kSameDepth = 1e-6, kSameDepths = 1e-5;

// Contacts are in one point where they are within this share of the smaller set's size.
constexpr double kOnePoint = 1e-6;

// Points of a clipped face that are this share of the scale short of touching still touch: what
// kTouchTolerance of engine/world allows a hit to be.
constexpr double kTouching = 0x1p-34;

// This share of that length is 2^-46 of the scale, more than rounding.
constexpr double kSlack = 0x1p-12;

// A face takes part if its normal is within 8 degrees of the contact's.
constexpr double kFacing = 0.99;

// Edges of two faces coincide where they are this share of the smaller set's size apart: far more
// than what jitters in a stack, less than anyone sees of a contact that is moved by so much.
constexpr double kCoinciding = 0x1p-8;

// Segments are one line where the sine between them is below this.
constexpr double kOneLine = 0.02;

enum class Reference { A, B, None };

/// Chooses of two sets of one size the one whose face cuts the other's, by where the normal leads,
/// because which of the two is called A may change with each step. No normal along an axis or
/// midway between axes is near where this choice changes.
Reference by_size(const Core& a, const Core& b, const Vec3& normal) {
  if (a.bounding_radius != b.bounding_radius)
    return b.bounding_radius > a.bounding_radius ? Reference::B : Reference::A;
  return dot(normal, {1, 2, 4}) < 0 ? Reference::B : Reference::A;
}

/// Chooses which face cuts the other: the one that is more nearly at right angles to the normal,
/// and of equals the larger set's, so that it stays the same from step to step.
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

// This number stands for a whole face where a corner or an edge of it would stand.
constexpr std::uint32_t kWhole = 0x20000;

struct Tolerances {
  double touching;
  double coinciding;
  double margin;
};

/// Moves a contact as if A were grown by the margin along the normal. Without a margin not even a
/// sign of nought changes.
void grow(ContactPoint& contact, double margin) {
  if (!(margin > 0)) return;
  contact.point_a = contact.point_a + contact.normal * margin;
  contact.depth += margin;
}

double grown_depth(const Penetration& penetration, double margin) {
  return margin > 0 ? std::max(penetration.depth + margin, 0.0) : penetration.depth;
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

/// True if polygons of such a set stand for discs.
bool is_round(CoreKind kind) {
  return kind == CoreKind::Cylinder || kind == CoreKind::Cone;
}

/// Adds the clipped corners of the incident face that are behind the reference's, whose outward
/// sense along the normal is `sign`: 1 if it is A's. What is clipped along the normal lies, where
/// that leads, in both faces. Returns whether these are all the corners of what the two have in
/// common.
bool add_clipped(const FaceOf& incident, const FaceOf& reference, const Penetration& penetration,
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
  bool has_dropped = false;
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
                       lies_on(incident, own, tolerance.touching))) {
      has_dropped = true;
      continue;
    }
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
  return !(clipped.has_laid_edges || has_dropped || has_sharp_corners || is_uneven(reference) ||
           is_uneven(incident) || is_round(kind) || is_round(incident.core.kind));
}

/// Two sets, and the parts of them that face each other along a contact's normal.
struct FacePair {
  const Core& a;
  const Core& b;
  ContactFace of_a, of_b;
};

/// Returns one point of each set, where the two meet once B is moved out by the penetration.
MeetingPoints meeting_of(const Core& a, const Core& b, const Parting& parting) {
  const Penetration& penetration = parting.penetration;
  if (parting.has_witnesses) return {penetration.point_a, penetration.point_b};
  return meeting_points(a, b, penetration);
}

/// Returns the same points along the normal, to rounding, and nothing if that line passes a set by.
std::optional<MeetingPoints> ends_of_meeting(const Core& a, const Core& b, const Parting& parting) {
  const MeetingPoints met = meeting_of(a, b, parting);
  const Vec3& normal = parting.penetration.normal;
  const double aside = length(cross(met.on_a - met.on_b, normal));
  if (aside <= kSlack * kTouching * pair_scale(a, b)) return met;
  return ends_on_line(a, b, normal, met);
}

/// Says how much contacts of faces tell of what two sets have in common.
enum class Told {
  Something,  ///< part of it, as contacts of edges do, or nothing
  OfPolygons,
  AllOfPolygons
};

/// Says what contacts of faces leave out.
struct LeftOut {
  double deepest;  ///< the depth of the deepest contact, >= 0, with the margin
  double enough;   ///< the depth that nothing exceeds by more than rounding; without the margin
  Told told;       ///< what the contacts tell
};

double depth_between(const MeetingPoints& ends, const Vec3& normal) {
  return dot(ends.on_a - ends.on_b, normal);
}

std::optional<MeetingPoints> deepest_of(const FacePair& faces, const Vec3& normal) {
  return deepest_of_faces({faces.of_a, faces.a}, {faces.of_b, faces.b}, normal);
}

/// Finds the deepest point of two polygons. What is deepest of the one may lie beside the other,
/// and then the two reach past each other by less than they do along the normal: they are deepest
/// where they are nearest once they are moved apart. Returns nothing if no point is deeper than the
/// contacts `told`.
std::optional<MeetingPoints> deepest_ends(const FacePair& faces, const Parting& parting,
                                          double enough, Told told) {
  const Core &a = faces.a, &b = faces.b;
  const Vec3& normal = parting.penetration.normal;
  const bool are_sure = are_deepest({faces.of_a, a}, {faces.of_b, b}, normal);
  if (are_sure && told == Told::AllOfPolygons) return std::nullopt;
  std::optional<MeetingPoints> best = deepest_of(faces, normal);
  if (best && are_sure) return best;
  const auto is_enough = [&] { return best && depth_between(*best, normal) >= enough; };
  const auto offer = [&](const MeetingPoints& met) {
    const std::optional<MeetingPoints> ends = ends_on_line(a, b, normal, met);
    if (ends && !(best && depth_between(*best, normal) > depth_between(*ends, normal))) best = ends;
  };
  if (!is_enough()) offer({rounded_support(a, normal), rounded_support(b, -normal)});
  if (!is_enough()) offer(meeting_of(a, b, parting));
  return best;
}

/// Adds where two faces or edges are deepest, if that is deeper than their contacts.
void add_meeting(const MeetingPoints& met, const Parting& parting, double deepest, double margin,
                 std::vector<ContactPoint>& contacts) {
  const Vec3& normal = parting.penetration.normal;
  ContactPoint contact{met.on_a,       met.on_b,      normal, depth_between(met, normal),
                       kDeepestOfFace, kDeepestOfFace};
  grow(contact, margin);
  contact.depth = std::min(contact.depth, grown_depth(parting.penetration, margin));
  if (contact.depth > deepest) contacts.push_back(contact);
}

void add_deepest_of_faces(const FacePair& faces, const Parting& parting, const LeftOut& left_out,
                          double margin, std::vector<ContactPoint>& contacts) {
  const std::optional<MeetingPoints> ends =
      deepest_ends(faces, parting, left_out.enough, left_out.told);
  if (!ends) return;
  add_meeting(*ends, parting, left_out.deepest, margin, contacts);
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

Told add_of_faces(const FacePair& faces, const Penetration& penetration, double margin,
                  std::vector<ContactPoint>& contacts) {
  const auto& [a, b, face_a, face_b] = faces;
  if (face_a.count <= 1 || face_b.count <= 1) return Told::Something;
  const Tolerances tolerance{kTouching * pair_scale(a, b), kCoinciding * smaller_size(a, b),
                             margin};
  const Reference reference = choose(face_a, face_b, a, b, penetration.normal);
  if (reference == Reference::None) return Told::Something;
  const bool are_all =
      reference == Reference::A
          ? add_clipped({face_b, b}, {face_a, a}, penetration, 1, tolerance, contacts)
          : add_clipped({face_a, a}, {face_b, b}, penetration, -1, tolerance, contacts);
  if (face_a.count <= 2 || face_b.count <= 2) return Told::Something;
  return are_all ? Told::AllOfPolygons : Told::OfPolygons;
}

/// Where a rim meets an edge or another rim, rounding decides which parts of the polygons that
/// stand for both are met there. So one of the contacts in that point is left, and it is named
/// after the point.
void name_meeting(const FacePair& faces, const Parting& parting, std::size_t first,
                  std::vector<ContactPoint>& contacts) {
  const Core &a = faces.a, &b = faces.b;
  if (!parting.has_witnesses || !(is_round(a.kind) || is_round(b.kind))) return;
  const double within = kOnePoint * smaller_size(a, b);
  const auto is_there = [&](const ContactPoint& contact) {
    return largest(contact.point_b - parting.penetration.point_b) <= within;
  };
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  const auto met = std::find_if(begin, contacts.end(), is_there);
  if (met == contacts.end()) return;
  name_point(a, b, *met);
  contacts.erase(std::remove_if(met + 1, contacts.end(), is_there), contacts.end());
}

/// Returns the faces that face each other: none where one of the two has no face at all.
FacePair faces_of(const Core& a, const Core& b, const Vec3& normal) {
  if (!has_face(a) || !has_face(b)) return {a, b, {}, {}};
  return {a, b, face_along(a, normal), face_along(b, -normal)};
}

}  // namespace

void add_face_contact_points(const Core& a, const Core& b, const Penetration& penetration,
                             std::vector<ContactPoint>& contacts, double margin) {
  add_of_faces(faces_of(a, b, penetration.normal), penetration, margin, contacts);
}

void add_contact_points(const Core& a, const Core& b, const Parting& parting,
                        std::vector<ContactPoint>& contacts, double margin) {
  const std::size_t before = contacts.size();
  const Vec3& normal = parting.penetration.normal;
  const FacePair faces = faces_of(a, b, normal);
  const Told told = add_of_faces(faces, parting.penetration, margin, contacts);
  const bool is_flat = told != Told::Something;
  if (contacts.size() > before) name_meeting(faces, parting, before, contacts);
  double deepest = -1, square = 0;
  for (std::size_t i = before; i < contacts.size(); ++i) {
    deepest = std::max(deepest, contacts[i].depth);
    const Vec3 across = middle_of(contacts[i]) - middle_of(contacts[before]);
    square = std::max(square, dot(across, across));
  }
  // Above all for a round face, what its corners leave out is the deepest point itself.
  const double depth = grown_depth(parting.penetration, margin), size = smaller_size(a, b);
  const auto enough = [&] { return parting.penetration.depth - kTouching * pair_scale(a, b); };
  if (deepest >= 0 &&
      depth - deepest <= std::max(kSameDepth * size, kSameDepths * std::sqrt(square))) {
    const double least = least_offered(depth, {margin, size});
    if (!(deepest < least && deepest - margin < enough() - (depth - least))) return;
    if (is_flat) {
      add_deepest_of_faces(faces, parting, {deepest, enough(), told}, margin, contacts);
    } else {
      const auto ends = ends_of_meeting(a, b, parting);
      if (ends) add_meeting(*ends, parting, deepest, margin, contacts);
    }
    return;
  }
  const std::optional<MeetingPoints> of_faces = is_flat ? deepest_of(faces, normal) : std::nullopt;
  const bool is_there = of_faces && depth_between(*of_faces, normal) >= enough();
  const MeetingPoints met = is_there ? *of_faces : meeting_of(a, b, parting);
  contacts.push_back(
      {met.on_a, met.on_b, normal, parting.penetration.depth, kPointFeature, kPointFeature});
  name_point(a, b, contacts.back());
  grow(contacts.back(), margin);
  if (margin > 0) contacts.back().depth = depth;
}

}  // namespace graze::narrowphase
