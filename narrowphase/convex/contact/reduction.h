#pragma once

#include <graze/narrowphase/convex/contact/contact_points.h>
#include <graze/narrowphase/convex/core/core.h>

#include <cstddef>
#include <span>

namespace graze::narrowphase {

/// The surfaces on which the contacts of a region lie.
class ContactSurfaces {
 public:
  /// Takes a contact between two of a region's, with points on the line between theirs, to both
  /// surfaces along its normal. False if these are not there.
  virtual bool hold(ContactPoint& contact) const = 0;

 protected:
  ~ContactSurfaces() = default;
};

/// Holds the surfaces of two convex sets whose faces face each other along the contacts' normal.
class CoreSurfaces final : public ContactSurfaces {
 public:
  /// A is grown by the margin, metres, along the normal. The sets must outlive it.
  CoreSurfaces(const Core& a, const Core& b, double margin) : a_(a), b_(b), margin_(margin) {}
  bool hold(ContactPoint& contact) const override;

 private:
  const Core& a_;
  const Core& b_;
  double margin_;
};

/// Takes a point along `out`, a unit direction away from a set, to the surface of the set, grown by
/// a margin along `out`, metres. False if only a point of the set faces `out`, if the point is off
/// the plane of a face that is even, or if the line misses the surface of one that is uneven.
bool move_onto_face(const Core& core, const Vec3& out, double margin, Vec3& point);

/// Says by what the greatest depth of contacts is measured.
struct DepthScale {
  double margin = 0;  ///< metres, contained in the depth: the depth without it counts
  double size = 0;    ///< metres, the size of the contact or of what is in contact
};

/// Returns the least that the greatest depth of contacts may be said to be: less than what parts
/// the two by less than the thousandth that law 15 allows, and by 2e-6 of the size at most.
double least_of_deepest(double depth, const DepthScale& scale);
/// Returns the least of all contacts that are offered: where they lack more, so does the deepest
/// point.
double least_offered(double depth, const DepthScale& scale);

struct Reduction {
  std::size_t most;                           ///< the most contacts that are left
  double margin = 0;                          ///< metres, contained in all depths
  const ContactSurfaces* surfaces = nullptr;  ///< null if nobody knows them
};

/// Puts contacts that stand for all of a region in front, the deepest first, and says how many.
/// Where all are nearly level those that are far from each other are left, by their places alone:
/// ties of distances, to 1e-4, go to the lower features. If then none is as deep as
/// least_of_deepest() says, the one of these that has the shortest move moves towards a deeper one
/// until it is, and keeps its features. So what lies and trembles has the same contacts from step
/// to step, and none of them jumps. Where the surfaces do not hold it in between, it takes the
/// place of the deepest. Where no surfaces are known it does so, too, but only where it lacks 1e-5
/// of the width. Takes O(n log n) for n contacts.
std::size_t reduce(std::span<ContactPoint> contacts, const Reduction& reduction);

}  // namespace graze::narrowphase
