#include <graze/bvh/box_set/overlap_tracker.h>

#include <algorithm>
#include <new>

namespace graze::bvh {
namespace {

// One box in so many may change before searching for all pairs is the cheaper way.
constexpr std::size_t kFewShare = 16;
constexpr std::size_t kAlwaysFew = 2;

constexpr std::size_t kAhead = 8;  // pairs whose entries are fetched before they are needed

BoxPair ordered_pair(std::uint32_t s, std::uint32_t t) {
  return {std::min(s, t), std::max(s, t)};
}

}  // namespace

void OverlapTracker::insert(std::uint32_t proxy, const Aabb& box) {
  hold({Verb::Insert, proxy, box});
}

void OverlapTracker::move(std::uint32_t proxy, const Aabb& box) {
  hold({Verb::Move, proxy, box});
}

void OverlapTracker::erase(std::uint32_t proxy) {
  hold({Verb::Erase, proxy, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}});
}

/// Holds a change until later. Changes are made in the order in which they came. Those that wait
/// cannot fail any more: each takes at most one new place.
void OverlapTracker::hold(const WaitingChange& change) {
  if (waiting_count_ == kMostWaiting) make_waiting_changes();
  if (change.verb == Verb::Insert) set_.store().reserve(kMostWaiting, change.proxy + 1);
  waiting_[waiting_count_++] = change;
  const std::uint32_t place = set_.store().place(change.proxy);
  if (place != kNullIndex) set_.store().prefetch(place);
}

void OverlapTracker::make_waiting_changes() {
  for (std::size_t i = 0; i < waiting_count_; ++i) {
    const auto& [verb, proxy, box] = waiting_[i];
    note(proxy);
    switch (verb) {
      case Verb::Insert:
        set_.order().insert(proxy, ordered_box(box));
        break;
      case Verb::Move:
        set_.order().move(proxy, ordered_box(box));
        break;
      case Verb::Erase:
        set_.store().erase(proxy);
        break;
    }
  }
  waiting_count_ = 0;
}

/// Notes a proxy's box before it changes. If there is no memory to note it, it counts as one of
/// many.
void OverlapTracker::note(std::uint32_t proxy) {
  if (have_many_changed_) return;
  try {
    note_one(proxy);
  } catch (const std::bad_alloc&) {
    count_all_as_changed();
  }
}

void OverlapTracker::note_one(std::uint32_t proxy) {
  if (proxy >= is_changed_.size()) is_changed_.resize(proxy + std::size_t{1});
  if (is_changed_[proxy]) return;
  if (are_many(changed_.size() + 1)) {
    count_all_as_changed();
    return;
  }
  if (changed_.size() == changed_.capacity())
    changed_.reserve(std::min(2 * changed_.size() + 8, most_changes()));
  changed_.push_back({set_.store().contains(proxy) ? set_.store().box(proxy) : no_box(),
                      set_.store().place(proxy), proxy});
  is_changed_[proxy] = true;
}

/// Counts all boxes as changed and forgets what was noted: until the next update nobody asks what
/// was where.
void OverlapTracker::count_all_as_changed() {
  if (have_many_changed_) return;
  forget_changes();
  have_many_changed_ = true;
}

void OverlapTracker::forget_changes() {
  for (const ChangedBox& changed : changed_)
    is_changed_[changed.proxy] = false;
  changed_.clear();
  have_many_changed_ = false;
}

bool OverlapTracker::are_many(std::size_t changes) const {
  return changes > most_changes();
}

std::size_t OverlapTracker::most_changes() const {
  return kAlwaysFew + set_.store().size / kFewShare;
}

bool OverlapTracker::update() {
  make_waiting_changes();
  begun_.clear();
  ended_.clear();
  is_difference_sorted_ = has_difference_ = true;
  if (!have_many_changed_ && changed_.empty()) return false;
  // Boxes that came from far away have other neighbours now than those that were looked up before
  // them.
  if (are_many(changed_.size() + set_.order().arrivals())) count_all_as_changed();
  try {
    have_many_changed_ ? search_all() : search_movers();
  } catch (...) {
    begun_.clear(), ended_.clear();
    throw;
  }
  forget_changes();
  return true;
}

void OverlapTracker::search_all() {
  set_.order().prepare_for_search();
  set_.order().note_search(set_.search().find_all_pairs(before_));
  std::swap(pairs_, before_);
  std::swap(rows_, rows_before_);
  is_before_grouped_ = is_grouped_;
  is_grouped_ = is_sorted_ = false;
  index_.reset();
  has_difference_ = false;
  ++searches_for_all_;
}

void OverlapTracker::search_movers() {
  if (!index_.is_built()) index_.build(pairs_);
  set_.order().prepare_for_lookups(changed_.size());
  list_former_boxes();
  list_movers();
  look_up_all();
  end_pairs_of_movers();
  edit_list();
  if (begun_.size() + ended_.size() != 0) is_grouped_ = is_sorted_ = false;
  has_difference_ = true;
  is_difference_sorted_ = false;
  ++searches_for_movers_;
}

/// Lists the former boxes in the order of their places, so that neighbours share blocks of the tree
/// over them.
void OverlapTracker::list_former_boxes() {
  movers_.clear();
  for (std::uint32_t i = 0; i < changed_.size(); ++i) {
    if (changed_[i].place != kNullIndex) movers_.push_back({changed_[i].place, i});
  }
  sort_movers();
  former_.clear();
  for (const Mover& mover : movers_)
    former_.add(changed_box_of(mover).proxy, changed_box_of(mover).before);
}

/// Lists the movers in the order of their places, so that neighbours are looked up together.
void OverlapTracker::list_movers() {
  movers_.clear();
  for (std::uint32_t i = 0; i < changed_.size(); ++i) {
    const std::uint32_t place = set_.store().place(changed_[i].proxy);
    movers_.push_back({place != kNullIndex ? place : changed_[i].place, i});
  }
  sort_movers();
}

void OverlapTracker::sort_movers() {
  std::sort(movers_.begin(), movers_.end(), [](const Mover& s, const Mover& t) {
    return s.place != t.place ? s.place < t.place : s.changed < t.changed;
  });
}

/// Looks up both places of each mover at once, after all have moved. That tells what began and
/// ended with boxes that did not move. A pair of two movers has begun if the list does not have
/// it.
void OverlapTracker::look_up_all() {
  is_changed_.resize(std::max<std::size_t>(is_changed_.size(), set_.store().proxy_limit()));
  for (std::size_t first = 0; first < movers_.size(); first += kLanes)
    look_up_some(first);
}

/// Looks up the next sixteen movers in both of their places.
void OverlapTracker::look_up_some(std::size_t first) {
  OrderedBox before[kLanes], after[kLanes];
  const std::size_t count = std::min<std::size_t>(kLanes, movers_.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const ChangedBox& change = changed_box_of(movers_[first + i]);
    before[i] = change.before;
    after[i] = set_.store().contains(change.proxy) ? set_.store().box(change.proxy) : no_box();
  }
  overlaps_.clear();
  set_.search().look_up_movers({before, count}, {after, count}, lookup_, overlaps_);
  for (const MoverOverlap& found : overlaps_) {
    const std::uint32_t proxy = changed_box_of(movers_[first + found.mover]).proxy;
    const BoxPair pair = ordered_pair(proxy, found.proxy);
    if (!is_changed_[found.proxy]) {
      if (found.overlaps > found.overlapped) begun_.push_back(pair);
      if (found.overlaps < found.overlapped) ended_.push_back(pair);
    } else if (found.overlaps && proxy < found.proxy &&
               index_.position(pairs_, pair) == PairIndex::kNowhere) {
      begun_.push_back(pair);
    }
  }
}

/// Ends pairs of two movers, which are found among the places where they were.
void OverlapTracker::end_pairs_of_movers() {
  former_.list_overlaps(former_pairs_);
  for (const BoxPair& pair : former_pairs_.pairs()) {
    const auto [a, b] = pair;
    const bool is_over = !set_.store().contains(a) || !set_.store().contains(b) ||
                         !overlap(set_.store().box(a), set_.store().box(b));
    if (is_over) ended_.push_back(pair);
  }
}

/// Makes all edits of the list, or none if it throws.
void OverlapTracker::edit_list() {
  index_.reserve(pairs_, begun_.size());
  const auto ended = ended_.pairs(), begun = begun_.pairs();
  for (std::size_t i = 0; i < ended.size(); ++i) {
    index_.prefetch_removal(pairs_, ended, i);
    index_.remove(pairs_, ended[i]);
  }
  for (std::size_t i = 0; i < begun.size(); ++i) {
    index_.prefetch(begun[std::min(i + kAhead, begun.size() - 1)]);
    index_.add(pairs_, begun[i]);
  }
}

std::span<const BoxPair> OverlapTracker::sorted_pairs() {
  if (!is_sorted_) {
    sort_pairs(pairs_.pairs(), set_.store().proxy_limit(), ends_, sorted_);
    is_sorted_ = true;
  }
  return sorted_.pairs();
}

std::span<const BoxPair> OverlapTracker::begun() {
  work_out_difference();
  return begun_.pairs();
}

std::span<const BoxPair> OverlapTracker::ended() {
  work_out_difference();
  return ended_.pairs();
}

void OverlapTracker::work_out_difference() {
  if (!is_difference_sorted_) {
    std::sort(begun_.data(), begun_.data() + begun_.size());
    std::sort(ended_.data(), ended_.data() + ended_.size());
    is_difference_sorted_ = true;
  }
  if (has_difference_) return;
  if (!is_before_grouped_) rows_before_.group(before_.pairs(), set_.store().proxy_limit());
  if (!is_grouped_) rows_.group(pairs_.pairs(), set_.store().proxy_limit());
  is_before_grouped_ = is_grouped_ = true;
  begun_.clear(), ended_.clear();  // an earlier call may have thrown halfway
  append_changes(rows_before_, rows_, rows_to_sort_, begun_, ended_);
  has_difference_ = true;
}

std::size_t OverlapTracker::bytes_for_pairs() const {
  const std::size_t pairs = pairs_.capacity() + before_.capacity() + sorted_.capacity() +
                            begun_.capacity() + ended_.capacity() + former_pairs_.capacity() +
                            rows_to_sort_.left.capacity() + rows_to_sort_.right.capacity();
  return pairs * sizeof(BoxPair) + rows_.bytes() + rows_before_.bytes() + index_.bytes() +
         ends_.capacity() * 4 + movers_.capacity() * sizeof(Mover) +
         changed_.capacity() * sizeof(ChangedBox) + is_changed_.capacity() / 8 +
         overlaps_.capacity() * sizeof(MoverOverlap) +
         (lookup_.reached.capacity() + lookup_.below.capacity()) * sizeof(Reached) +
         former_.bytes();
}

}  // namespace graze::bvh
