#pragma once

// What an update has found out. Private to engine/world.

#include <graze/engine/world/bodies/contact_list.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace graze {

/// Memory for so many more elements: to append them throws nothing.
template <typename T>
void make_room_in(std::vector<T>& of, std::size_t more) {
  if (of.capacity() - of.size() < more) of.reserve(std::max(2 * of.size(), of.size() + more));
}

/// What an update has to tell of pairs, in the order in which they were tested, and what it did.
struct PairNews {
  std::vector<BodyPair> begun, ended, begun_near, ended_near, moved;
  ContactList contacts;
  std::vector<BodyFirstContact> first_contacts;
  WorldWork work;

  void clear() {
    begun.clear(), ended.clear(), begun_near.clear(), ended_near.clear();
    clear_all_but_changes();
  }
  /// What began and ended stays listed.
  void clear_all_but_changes() {
    moved.clear(), contacts.clear(), first_contacts.clear();
    work = {};
  }
};

/// Where in all news those of a part of the pairs go, but for contacts.
struct NewsPlace {
  std::size_t begun, ended, begun_near, ended_near, moved;
};

}  // namespace graze
