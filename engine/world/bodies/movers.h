#pragma once

// Keeps track of the bodies that moved since the last update, and from where. Private to
// engine/world.

#include <graze/engine/mesh/rigid_motion.h>
#include <graze/engine/world/bodies/pair_news.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace graze {

/// A body that moved.
struct Mover {
  std::uint32_t body;
  Pose before;    ///< the pose at the last update
  double travel;  ///< metres: since the last update no point was further than this from where it is
                  ///< now
  std::optional<RigidMotion> motion = {};  ///< the motion that it made, if that is not
                                           ///< RigidMotion::between()
  bool is_listed = false;                  ///< whether the search for pairs lists it
};

/// All bodies that moved. They are noted only while a body of the world is swept: motions from
/// before the first body was swept count as made before the last update.
class Movers {
 public:
  bool are_noted() const { return swept_bodies_ != 0; }
  /// Count the bodies that are swept.
  void add_swept() { ++swept_bodies_; }
  void remove_swept() {
    if (--swept_bodies_ == 0) clear();
  }

  /// Makes room, so that note() of `more` bodies, of a world with `bodies` indices, throws nothing.
  void make_room(std::size_t more, std::size_t bodies) {
    if (!are_noted()) return;
    if (place_.size() < bodies) place_.resize(bodies, kNowhere);
    make_room_in(list_, more);
  }

  const Mover* find(std::uint32_t body) const {
    return body < place_.size() && place_[body] != kNowhere ? &list_[place_[body]] : nullptr;
  }
  Mover* find(std::uint32_t body) {
    return const_cast<Mover*>(static_cast<const Movers&>(*this).find(body));
  }

  /// Notes that a body, which is not noted yet, moves from a pose.
  Mover& note(std::uint32_t body, const Pose& before) {
    place_[body] = static_cast<std::uint32_t>(list_.size());
    return list_.emplace_back(Mover{body, before, 0});
  }

  /// Removes the note of a body, as if it had not moved.
  void forget(std::uint32_t body) {
    Mover* mover = find(body);
    if (mover == nullptr) return;
    place_[list_.back().body] = place_[body];
    *mover = list_.back();
    place_[body] = kNowhere;
    list_.pop_back();
  }

  void clear() {
    for (const Mover& mover : list_)
      place_[mover.body] = kNowhere;
    list_.clear();
  }

  std::span<Mover> list() { return list_; }

 private:
  static constexpr std::uint32_t kNowhere = 0xffffffff;

  std::size_t swept_bodies_ = 0;
  std::vector<Mover> list_;
  std::vector<std::uint32_t> place_;  ///< the place in the list of each body, by index
};

}  // namespace graze
