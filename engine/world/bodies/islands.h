#pragma once

// Which bodies hang together by touching. Private to engine/world.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze {

/// What keeping islands up took.
struct IslandWork {
  std::uint64_t merged = 0;  ///< two islands became one
  std::uint64_t split = 0;   ///< one became two
  std::uint64_t steps = 0;   ///< bodies relabelled, and touches looked at by searches
};

/// Bodies that touch, and the connected components of that graph. Where two islands meet, the
/// smaller one is relabelled. Where a touch ends, two searches go from both of its ends in turns:
/// either they meet, or one has seen its whole side, which then becomes an island of its own. So a
/// split costs no more than twice what the smaller side does; where the two still hang together it
/// costs as much as the shortest ways around, which in a pile are short, and in a ring are the
/// ring.
class Islands {
 public:
  /// Memory for bodies with indices below `bodies`, and for so many more touches: after that
  /// nothing throws but list(). What throws has changed nothing.
  void make_room(std::size_t bodies, std::size_t more_touches);

  bool has(std::uint32_t body) const {
    return body < nodes_.size() && nodes_[body].island != kNone;
  }
  /// The body, which was not there, is an island of its own.
  void add(std::uint32_t body);
  /// Takes the body out, with all its touches.
  void remove(std::uint32_t body);
  /// Two bodies that are there touch; to say so again changes nothing.
  void connect(std::uint32_t a, std::uint32_t b);
  /// They do not, or not any more.
  void disconnect(std::uint32_t a, std::uint32_t b);

  /// Appends the bodies of a body's island, in an order of no meaning. O(island).
  void list(std::uint32_t body, std::vector<std::uint32_t>& into) const;

  /// What was done since the last call.
  IslandWork take_work();

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Node {
    std::uint32_t touches = kNone;  ///< the first of a list of touches
    std::uint32_t degree = 0;
    std::uint32_t island = kNone;
    std::uint32_t next = kNone, previous = kNone;  ///< the ring of the bodies of its island
    std::uint32_t stamp = 0;                       ///< which search has seen it, and from which end
  };
  /// A touch as one of its two bodies sees it; the other half is beside it.
  struct Half {
    std::uint32_t other;
    std::uint32_t next, previous;
  };
  struct Island {
    std::uint32_t first;  ///< any of its bodies; of a free one, the next that is free
    std::uint32_t size;
  };
  /// The bodies that a search has seen from one end: a part of queue_, from one of its ends.
  struct Side {
    std::uint32_t stamp;
    std::uint32_t seen = 0, asked = 0;
  };

  std::uint32_t& queued(const Side& side, std::uint32_t i) {
    return (side.stamp & 1) == 0 ? queue_[i] : queue_[queue_.size() - 1 - i];
  }
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
  void link(std::uint32_t half, std::uint32_t body, std::uint32_t other);
  void unlink(std::uint32_t half, std::uint32_t body);
  void open_island(std::uint32_t body);
  void close_island(std::uint32_t island);
  void merge(std::uint32_t a, std::uint32_t b);
  void see(Side& side, std::uint32_t body);
  bool meets_other(Side& side);
  void split_if_apart(std::uint32_t a, std::uint32_t b);
  void split_off(const Side& side, std::uint32_t stays);

  std::vector<Node> nodes_;      ///< by body
  std::vector<Island> islands_;  ///< as many as bodies
  std::uint32_t free_island_ = kNone;
  std::vector<Half> halves_;
  std::uint32_t free_touch_ = kNone;  ///< the first half of a free touch, which names the next
  std::size_t free_touches_ = 0;
  std::vector<std::uint32_t> queue_;  ///< as many as bodies
  std::uint32_t last_stamp_ = 0;
  IslandWork work_;
};

}  // namespace graze
