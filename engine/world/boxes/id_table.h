#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze {

/// Keeps track of which indices are in use, and by which generation. A freed index rests for two
/// rounds before it is given out again, so that no list of the last round can name two different
/// things by it; a round is from one update to the next. An index whose generations are used up,
/// half as many as the type has or are allowed, is not given out again.
template <typename Generation>
class IdTable {
 public:
  /// Sets the limit that generations stay below, which is even; 0 allows all that the type has.
  void set_limit(Generation limit) { limit_ = limit; }

  std::uint32_t take();
  void free(std::uint32_t index);

  /// Make room, so that the next take(), free() or next_round() throws nothing. If they throw they
  /// have changed nothing.
  void prepare_take();
  void prepare_free();
  void prepare_round();

  /// Returns what take() will return.
  std::uint32_t next() const {
    return free_.empty() ? static_cast<std::uint32_t>(generation_.size()) : free_.back();
  }

  /// Begins a round. It throws nothing, because free() has made room, unless the table is a copy:
  /// copies have no memory to spare.
  void next_round();

  bool is_live(std::uint32_t index) const {
    return index < generation_.size() && (generation_[index] & 1) != 0;
  }
  bool is_live(std::uint32_t index, std::uint32_t generation) const {
    return is_live(index) && generation_[index] == generation;
  }
  std::uint32_t generation(std::uint32_t index) const { return generation_[index]; }
  std::size_t live_count() const { return live_count_; }
  std::size_t bytes() const;

 private:
  friend struct IdTableAccess;
  std::vector<Generation> generation_;  ///< odd while the index is in use
  std::vector<std::uint32_t> free_;     ///< the indices that may be taken, the last one first
  std::array<std::vector<std::uint32_t>, 2> resting_;
  std::size_t live_count_ = 0;
  Generation limit_ = 0;
};

/// Gives access to the contents of a table, for code that stores them elsewhere.
struct IdTableAccess {
  /// Calls `visit(generations, free, resting, older resting, live count, limit)`, each by
  /// reference.
  template <typename Table, typename Visit>
  static void visit(Table& table, const Visit& visit) {
    visit(table.generation_, table.free_, table.resting_[0], table.resting_[1], table.live_count_,
          table.limit_);
  }
};

}  // namespace graze
