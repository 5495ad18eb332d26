#pragma once

// The news of an update: what it has found. Private to engine/world.

#include <graze/engine/world/bodies/contact_list.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace graze {

/// Makes room for so many more elements, so that appending them throws nothing.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t more) {
  if (of.capacity() - of.size() < more) of.reserve(std::max(2 * of.size(), of.size() + more));
}

/// The news of pairs, in the order in which they were tested, and the work of the update.
struct PairNews {
  std::vector<BodyPair> begun, ended, begun_near, ended_near, moved;
  ContactList contacts;
  std::vector<BodyFirstContact> first_contacts;
  WorldWork work;

  void clear() {
    begun.clear(), ended.clear(), begun_near.clear(), ended_near.clear();
    clear_all_but_changes();
  }
  /// Clears all lists but those of the pairs that began and ended.
  void clear_all_but_changes() {
    moved.clear(), contacts.clear(), first_contacts.clear();
    work = {};
  }
};

/// The places in all news to which the news of a part of the pairs go, except for contacts.
struct NewsPlace {
  std::size_t begun, ended, begun_near, ended_near, moved;
};

}  // namespace graze
