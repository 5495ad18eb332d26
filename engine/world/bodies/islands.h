#pragma once

// Keeps track of which bodies are connected by touching. Private to engine/world.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace graze {

/// Counts of the work of keeping islands up to date.
struct IslandWork {
  std::uint64_t merged = 0;  ///< how often two islands became one
  std::uint64_t split = 0;   ///< how often one island became two
  std::uint64_t steps = 0;   ///< bodies relabelled, and edges looked at by searches
};

/// The graph of bodies whose edges are pairs that touch, and its connected components, the islands.
/// Where two islands meet, the smaller one is relabelled. Where an edge is removed, two searches go
/// from both of its ends in turns: either they meet, or one has seen its whole side, which then
/// becomes an island of its own. So a split costs no more than twice a search of the smaller side.
/// If the two bodies are still connected, it costs as much as the shortest ways around, which in a
/// pile are short, and in a ring are the whole ring.
class Islands {
 public:
  /// Makes room for bodies with indices below `bodies`, and for so many more edges: after that only
  /// list() may throw. If this throws it has changed nothing.
  void make_room(std::size_t bodies, std::size_t more_touches);

  bool has(std::uint32_t body) const {
    return body < nodes_.size() && nodes_[body].island != kNone;
  }
  /// Adds a body, which was not there, as an island of its own.
  void add(std::uint32_t body);
  /// Removes the body with all its edges.
  void remove(std::uint32_t body);
  /// Adds an edge between two bodies that are there; if there is one already, nothing changes.
  void connect(std::uint32_t a, std::uint32_t b);
  /// Removes the edge between two bodies, if there is one.
  void disconnect(std::uint32_t a, std::uint32_t b);

  /// Appends the bodies of a body's island, in no particular order. It costs O(island).
  void list(std::uint32_t body, std::vector<std::uint32_t>& into) const;

  /// Returns the work since the last call.
  IslandWork take_work();

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  struct Node {
    std::uint32_t first_edge = kNone;  ///< the first half of the list of the body's edges
    std::uint32_t degree = 0;
    std::uint32_t island = kNone;
    std::uint32_t next = kNone, previous = kNone;  ///< links of the ring of the bodies of its
                                                   ///< island
    std::uint32_t stamp = 0;                       ///< the search that has seen the body, and from
                                                   ///< which end
  };
  /// An edge as one of its two bodies sees it. The other half is beside it.
  struct Half {
    std::uint32_t other;
    std::uint32_t next, previous;
  };
  struct Island {
    std::uint32_t first;  ///< any body of the island; in a free entry, the next free entry
    std::uint32_t size;
  };
  /// The bodies that a search has seen from one end of an edge. They are a part of queue_, from one
  /// of its ends.
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

  std::vector<Node> nodes_;      ///< the nodes by index of bodies
  std::vector<Island> islands_;  ///< as many entries as there are bodies
  std::uint32_t free_island_ = kNone;
  std::vector<Half> halves_;
  std::uint32_t free_touch_ = kNone;  ///< the first half of a free edge, which names the next
  std::size_t free_touches_ = 0;
  std::vector<std::uint32_t> queue_;  ///< as many entries as there are bodies
  std::uint32_t last_stamp_ = 0;
  IslandWork work_;
};

}  // namespace graze
