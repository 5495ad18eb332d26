#pragma once

#include <graze/bvh/box_set/order/box_order.h>
#include <graze/bvh/box_set/search/box_search.h>
#include <graze/bvh/box_set/store/box_store.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::bvh {

/// Many boxes that move, each known by its proxy, in blocks of 16 under implicit trees: one tree
/// for each group of sizes, by factors of 4 or more, and one for boxes that came since the last
/// sort. Finds what overlaps, exactly on the doubles given. It holds where boxes are kept, in which
/// order, and how they are searched.
///
/// After insert(), move(), erase() or a move of many one of BoxOrder's functions that prepare has
/// to be called before anything is found.
///
/// What throws for want of memory has lost no box: insert() has not happened, and what puts boxes
/// in order can be asked for again. move() and erase() throw nothing: where there is no memory for
/// what saves time later, they do without.
class BoxSet {
 public:
  /// `threads` share the work; no result depends on their number.
  explicit BoxSet(int threads)
      : workers_(threads),
        order_(store_, workers_),
        search_(store_, workers_),
        many_moves_(store_, workers_) {}
  BoxSet(const BoxSet&) = delete;
  BoxSet& operator=(const BoxSet&) = delete;

  const Workers& workers() const { return workers_; }
  /// Near boxes have near places in it.
  const BoxStore& store() const { return store_; }
  const BoxOrder& order() const { return order_; }
  BoxOrder& order() { return order_; }
  const BoxSearch& search() const { return search_; }
  ManyMoves& many_moves() { return many_moves_; }

  /// Memory for so many more boxes, of proxies below the limit: insert() will throw nothing.
  void reserve(std::size_t boxes, std::uint32_t proxy_limit) { store_.reserve(boxes, proxy_limit); }
  void insert(std::uint32_t proxy, const OrderedBox& box) { order_.insert(proxy, box); }
  void move(std::uint32_t proxy, const OrderedBox& box) { order_.move(proxy, box); }
  void erase(std::uint32_t proxy) { store_.erase(proxy); }

  /// All pairs that overlap, each once, in an order that the history of the set decides.
  void find_all_pairs(PairBuffer& out) { order_.note_search(search_.find_all_pairs(out)); }

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
