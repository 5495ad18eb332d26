#pragma once

#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/search/box_search.h>
#include <graze/bvh/box_set/store/box_store.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Many boxes that move, each known by its proxy, in blocks of 16 under implicit trees: one tree
/// for each layer of size classes, by factors of 4 or more, and one for boxes that came since the
/// last sort. It finds what overlaps, exactly on the doubles given. It is made of the store that
/// keeps the boxes, their order, and the search.
///
/// Boxes are inserted and moved by BoxOrder, and erased by BoxStore. After that, or after a move of
/// many, one of BoxOrder's functions that prepare has to be called before anything is found.
///
/// What throws for want of memory has lost no box: BoxOrder::insert() has not happened, and what
/// puts boxes in order can be asked for again. BoxOrder::move() and BoxStore::erase() throw
/// nothing: where there is no memory for what saves time later, they do without.
class BoxSet {
 public:
  /// Makes a set whose work `threads` threads share; no result depends on their number.
  explicit BoxSet(int threads)
      : workers_(threads),
        order_(store_, workers_),
        search_(store_, workers_),
        many_moves_(store_, workers_) {}
  BoxSet(const BoxSet&) = delete;
  BoxSet& operator=(const BoxSet&) = delete;

  const Workers& workers() const { return workers_; }
  /// Returns the store, in which near boxes have near places.
  const BoxStore& store() const { return store_; }
  const BoxOrder& order() const { return order_; }
  BoxOrder& order() { return order_; }
  const BoxSearch& search() const { return search_; }
  BoxStore& store() { return store_; }
  BoxSearch& search() { return search_; }
  ManyMoves& many_moves() { return many_moves_; }

  std::size_t bytes() const {
    return store_.bytes() + order_.bytes() + search_.bytes() + many_moves_.bytes();
  }

 private:
  Workers workers_;
  BoxStore store_;
  BoxOrder order_;
  BoxSearch search_;
  ManyMoves many_moves_;
};

}  // namespace graze::bvh
