#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <graze/engine/world/world.h>

namespace graze {

/// The settings of a ContactTracker.
struct ContactTrackerSettings {
  /// The place to which a body took an old contact may be this far from a new one that is taken for
  /// the same, as a share of the smaller body's size: finite and not negative.
  double same_place = 0.01;
};

/// Gives each contact of a world a number. A contact keeps its number from one update to the next
/// as long as it goes on, and no other contact ever gets it, so a solver can keep impulses by it.
/// A ContactFeature does not serve for that, because it says which parts meet from the poses alone.
/// If a round mesh rolls from facet to facet, or a resting body trembles, features change although
/// the contact goes on. If a piece of two meshes is suddenly left by another facet, a feature stays
/// although the contact does not go on.
///
/// Law 15: while a number lasts, and no point of the two bodies moves by more than m, the depth
/// changes by at most 2 m and a millionth of the smaller size. The normal turns by at most one
/// degree if m is at most a ten-thousandth of that size. Beyond that the tracker lets it turn by a
/// degree more for each further ten-thousandth, up to 30. The tracker tests each contact with an m
/// that is no more than the law's: it is how far the points of the manifold's contacts move with
/// their bodies. All contacts of a manifold go on if each kept its feature and its place. Otherwise
/// contacts go on by their places, nearest ones first; a place is measured on the body along which
/// the contact moved less. Contacts that are left go on by their features. The same rules hold if a
/// body has another shape than before. The tracker keeps contacts that an update does not list, and
/// forgets those that ended and those of a body that has become a sensor.
///
/// A tracker is for one world, whose settings ask for contacts, and for one thread at a time. For
/// each listed pair it takes one step along the pairs that the update before listed, or a hash
/// lookup. For each manifold its time grows with the square of the number of contacts. It takes
/// some 900 bytes for a pair, in which four contacts have room, and 100 for each further contact.
class ContactTracker {
 public:
  /// Makes a tracker that knows no contacts. Throws InputError for invalid settings.
  explicit ContactTracker(const ContactTrackerSettings& settings = {});
  ~ContactTracker();
  ContactTracker(ContactTracker&&) noexcept;
  ContactTracker& operator=(ContactTracker&&) noexcept;

  /// Takes the contacts of an update. It must be called for each update, in turn, before a body is
  /// moved again. Throws StaleIdError for bodies that are gone. If it throws, for lack of memory
  /// for example, ids() knows no numbers of this update, and the contacts of the pair at which it
  /// threw begin anew.
  void take(const World& world, const WorldUpdate& update);

  /// Forgets all contacts, which is necessary after World::restore(). Numbers are not given again.
  void clear();

  /// Returns the numbers of the contacts of `update.contacts[index]`, in their order, for the
  /// update that was taken last. Each number is above 0. They are valid until take(). Throws
  /// InputError for an index out of range.
  std::span<const std::uint64_t> ids(std::size_t index) const;

  /// Returns the number of known contacts, whether the last update listed them or not.
  std::size_t size() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
