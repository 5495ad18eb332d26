#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include <graze/engine/world/world.h>

namespace graze {

/// How a ContactTracker recognises contacts.
struct ContactTrackerSettings {
  /// How far a contact may be from where the bodies took an old one for it to be the same, as a
  /// share of the smaller body's size: finite and not negative.
  double same_place = 0.01;
};

/// Which contacts of a world go on from one update to the next: a number for each contact, the same
/// as long as it goes on, and never given to another one. That is what a solver keeps impulses by.
/// A ContactFeature says which parts meet, from the poses alone: where a round mesh rolls from
/// facet to facet, or what lies trembles, features change although the contact goes on, and where a
/// piece of two meshes is suddenly left by another facet a feature stays although it does not.
///
/// Law 15: while a number lasts, and no point of the two bodies moves by more than m, the depth
/// changes by at most 2 m and a millionth of the smaller size, and the normal, while m is at most a
/// ten-thousandth of that size, by at most one degree. It is kept by asking, with an m that is no
/// more than the law's: how far the points of the pair's contacts move with their bodies. Beyond a
/// ten-thousandth of the size the normal may change by a degree more for each, up to 30. Of a pair
/// all contacts go on if each kept its feature and its place. Else they go on by their places,
/// nearest ones first, measured on the body along which a contact moved less; then by their
/// features. Where a body has another shape than before, the same rules say what goes on. What an
/// update does not list stays as it is, and what ends, or has become a sensor, is forgotten.
///
/// It is for one world, whose settings ask for contacts. Not for use by several threads at once.
/// Time: of each pair listed a step along those that the update before listed, or a hash lookup,
/// and for each manifold the square of the number of its contacts; memory: some 900 bytes a pair,
/// four contacts among them, and 100 for each of more.
class ContactTracker {
 public:
  /// Throws InputError for settings that are none.
  explicit ContactTracker(const ContactTrackerSettings& settings = {});
  ~ContactTracker();
  ContactTracker(ContactTracker&&) noexcept;
  ContactTracker& operator=(ContactTracker&&) noexcept;

  /// Takes what an update said: of each one, in turn, before a body is moved again. Throws
  /// StaleIdError for bodies that are gone. If it throws, as where memory is short, no numbers are
  /// told of this update, and contacts of the pair at hand begin anew.
  void take(const World& world, const WorldUpdate& update);

  /// Forgets all contacts, as is to be done after World::restore(). Numbers are not given again.
  void clear();

  /// The numbers of the contacts of `update.contacts[index]` as last taken, in their order, each
  /// above 0. Valid until take(). Throws InputError for an index out of range.
  std::span<const std::uint64_t> ids(std::size_t index) const;

  /// How many contacts are known, listed by the last update or not.
  std::size_t size() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace graze
