#pragma once

// Keeps the contacts of pairs in one list. Private to engine/world.

#include <graze/engine/world/world.h>

#include <cstddef>
#include <span>
#include <vector>

namespace graze {

/// A list of the contacts of pairs. Its memory is kept from update to update and written over: of a
/// manifold only the contacts in use, mostly one or two of four, are written.
class ContactList {
 public:
  void clear() {
    count_ = further_ = 0;
    is_ascending_ = true;
  }
  /// Adds the contacts of a pair. Those of the parts of one pair come one after the other, in their
  /// order.
  void add(const BodyPair& pair, const Manifold& manifold) {
    if (count_ == list_.size()) list_.emplace_back();
    if (count_ != 0 && !(last_ < pair)) note_no_less(pair);
    last_ = pair;
    write(pair, manifold, list_[count_++]);
    if (count_ < list_.size()) prefetch(list_[count_]);
  }

  /// Makes room for the contacts of another list behind all that are there. Returns the first of
  /// the places that put() has to write them to.
  std::size_t make_room_for(const ContactList& part) {
    const std::size_t place = count_;
    if (part.count_ == 0) return place;
    is_ascending_ &= part.is_ascending_ && (count_ == 0 || last_ < part.list_[0].pair);
    last_ = part.last_;
    count_ += part.count_;
    further_ += part.further_;
    if (list_.size() < count_) list_.resize(count_);
    return place;
  }
  /// Makes room for as many contacts as another list has, which put() has to write in ascending
  /// order.
  void make_room_for_all(const ContactList& other) {
    count_ = other.count_;
    further_ = other.further_;
    is_ascending_ = true;
    if (list_.size() < count_) list_.resize(count_);
  }
  /// Writes contacts to a place. Several threads may write to different places at once.
  void put(std::size_t place, const BodyContact& contact) {
    write(contact.pair, contact.manifold, list_[place]);
  }

  std::span<const BodyContact> all() const { return {list_.data(), count_}; }
  bool is_ascending() const { return is_ascending_; }
  /// Returns of how many pairs of bodies the contacts are: a pair with a compound may have several.
  std::size_t pair_count() const { return count_ - further_; }

 private:
  void note_no_less(const BodyPair& pair) {
    if (last_ == pair) {
      ++further_;
    } else {
      is_ascending_ = false;
    }
  }
  static void write(const BodyPair& pair, const Manifold& manifold, BodyContact& contact) {
    contact.pair = pair;
    contact.manifold = manifold;
  }
  /// Fetches the memory that the next manifold is written to, if it has one contact.
  static void prefetch(const BodyContact& next) {
    __builtin_prefetch(&next, 1);
    constexpr std::ptrdiff_t kLine = 64;
    for (std::ptrdiff_t at = kLine; at < 4 * kLine; at += kLine)
      __builtin_prefetch(reinterpret_cast<const char*>(&next) + at, 1);
  }

  std::vector<BodyContact> list_;
  std::size_t count_ = 0;
  std::size_t further_ = 0;  ///< how many contacts are of a pair that is listed before them
  BodyPair last_;
  bool is_ascending_ = true;
};

}  // namespace graze
