#include <graze/bvh/box_set/overlap_tracker.h>
#include <graze/bvh/box_set/sorted_pairs.h>

#include <algorithm>

namespace graze::bvh {
namespace {

// One box in so many may change before searching for all pairs is the cheaper way.
constexpr std::size_t kFewShare = 16;
constexpr std::size_t kAlwaysFew = 2;

constexpr std::size_t kAhead = 4;  // movers whose blocks are fetched before they are needed

BoxPair ordered_pair(std::uint32_t s, std::uint32_t t) {
  return {std::min(s, t), std::max(s, t)};
}

}  // namespace

bool OverlapTracker::are_many(std::size_t changes) const {
  return changes > kAlwaysFew + set_.size() / kFewShare;
}

void OverlapTracker::move_now(std::span<const std::uint32_t> owners, std::span<const Aabb> boxes) {
  set_.move_many(owners, boxes);
  end_moves();
}

void OverlapTracker::move_first_now(std::span<const Aabb> boxes) {
  set_.move_first(boxes);
  end_moves();
}

void OverlapTracker::end_moves() {
  set_.refit();
  all_moved_ = true;
}

bool OverlapTracker::update(BoxChanges& changes) {
  begun_.clear();
  ended_.clear();
  if (!all_moved_ && changes.size() == 0) {
    has_difference_ = true;
    return false;
  }
  if (all_moved_ || are_many(changes.size())) {
    search_all(changes);
  } else {
    search_movers(changes);
  }
  // A crowd of newcomers comes once; movers come again in each step.
  if (2 * changes.moves < changes.size() && are_many(changes.size())) changes = {};
  changes.clear();
  return true;
}

void OverlapTracker::apply(const BoxChanges& changes) {
  if (changes.moves == changes.size() && are_many(changes.size())) {
    set_.move_many(changes.owner, changes.box);
    return;
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::uint32_t owner = changes.owner[i];
    if (changes.kind[i] == BoxChanges::Kind::Erase) {
      if (set_.contains(owner)) set_.erase(owner);
    } else if (set_.contains(owner)) {
      set_.move(owner, ordered_box(changes.box[i]));
    } else {
      set_.insert(owner, ordered_box(changes.box[i]));
    }
  }
}

void OverlapTracker::search_all(BoxChanges& changes) {
  apply(changes);
  set_.refit();
  set_.sort_if_worthwhile();
  std::swap(pairs_, before_);
  std::swap(rows_, rows_before_);
  is_before_grouped_ = is_grouped_;
  is_grouped_ = is_sorted_ = false;
  set_.find_all_pairs(pairs_);
  index_.reset();
  has_difference_ = false;
  all_moved_ = false;
  ++searches_for_all_;
}

/// One mover for each box that changes, by the last entry that names it.
void OverlapTracker::list_movers(const BoxChanges& changes) {
  movers_.clear();
  for (std::size_t i = changes.size(); i-- > 0;) {
    const std::uint32_t owner = changes.owner[i];
    if (owner >= is_mover_.size()) is_mover_.resize(owner + std::size_t{1});
    if (is_mover_[owner]) continue;
    is_mover_[owner] = true;
    movers_.push_back({set_.place(owner), static_cast<std::uint32_t>(i)});
  }
  std::sort(movers_.begin(), movers_.end(), [](const Mover& s, const Mover& t) {
    return s.place != t.place ? s.place < t.place : s.change < t.change;
  });
}

/// Both places of a mover are looked up at once, after all have moved. That tells what began and
/// ended with boxes that did not move. What began between two movers the list does not know yet;
/// what ended between two is found among the places where they were.
void OverlapTracker::compare_places(const BoxChanges& changes) {
  boxes_before_.resize(movers_.size());
  former_.clear();
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Mover& later = movers_[std::min(i + kAhead, movers_.size() - 1)];
    if (later.place != kNobody) set_.prefetch(later.place);
    boxes_before_[i] = no_box();
    if (movers_[i].place == kNobody) continue;
    const std::uint32_t owner = changes.owner[movers_[i].change];
    boxes_before_[i] = set_.box(owner);
    former_.add(owner, boxes_before_[i]);
  }
  apply(changes);
  set_.refit();
  is_mover_.resize(std::max<std::size_t>(is_mover_.size(), set_.owner_limit()));
  for (std::size_t first = 0; first < movers_.size(); first += kLanes)
    look_up_some(changes, first);
  end_pairs_of_movers();
}

/// Of the next 16 movers.
void OverlapTracker::look_up_some(const BoxChanges& changes, std::size_t first) {
  OrderedBox after[kLanes];
  const std::size_t count = std::min<std::size_t>(kLanes, movers_.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t change = movers_[first + i].change;
    after[i] = set_.contains(changes.owner[change]) ? ordered_box(changes.box[change]) : no_box();
  }
  hits_.clear();
  set_.find_overlapping_either(std::span(boxes_before_).subspan(first, count), {after, count},
                               lookup_, hits_);
  for (const MoverHit& hit : hits_) {
    const std::uint32_t owner = changes.owner[movers_[first + hit.mover].change];
    const BoxPair pair = ordered_pair(owner, hit.owner);
    if (!is_mover_[hit.owner]) {
      if (hit.is > hit.was) begun_.push_back(pair);
      if (hit.is < hit.was) ended_.push_back(pair);
    } else if (hit.is && owner < hit.owner &&
               index_.position(pairs_, pair) == PairIndex::kNowhere) {
      begun_.push_back(pair);
    }
  }
}

void OverlapTracker::end_pairs_of_movers() {
  former_.find_pairs(former_pairs_);
  for (const BoxPair& pair : former_pairs_.pairs()) {
    const auto [a, b] = pair;
    const bool is_over =
        !set_.contains(a) || !set_.contains(b) || !overlap(set_.box(a), set_.box(b));
    if (is_over) ended_.push_back(pair);
  }
}

void OverlapTracker::edit_list() {
  const auto ended = ended_.pairs(), begun = begun_.pairs();
  for (std::size_t i = 0; i < ended.size(); ++i) {
    index_.prefetch(ended[std::min(i + kAhead, ended.size() - 1)]);
    index_.remove(pairs_, ended[i]);
  }
  for (std::size_t i = 0; i < begun.size(); ++i) {
    index_.prefetch(begun[std::min(i + kAhead, begun.size() - 1)]);
    index_.add(pairs_, begun[i]);
  }
}

void OverlapTracker::search_movers(const BoxChanges& changes) {
  if (!index_.is_built()) index_.build(pairs_);
  list_movers(changes);
  compare_places(changes);
  for (const Mover& mover : movers_)
    is_mover_[changes.owner[mover.change]] = false;
  edit_list();
  std::sort(begun_.data(), begun_.data() + begun_.size());
  std::sort(ended_.data(), ended_.data() + ended_.size());
  if (begun_.size() + ended_.size() != 0) is_grouped_ = is_sorted_ = false;
  has_difference_ = true;
  ++searches_for_movers_;
  set_.sort_if_crowded();
}

std::span<const BoxPair> OverlapTracker::sorted_pairs() {
  if (!is_sorted_) {
    sort_pairs(pairs_.pairs(), set_.owner_limit(), starts_, sorted_);
    is_sorted_ = true;
  }
  return sorted_.pairs();
}

void OverlapTracker::work_out_difference() {
  if (has_difference_) return;
  if (!is_before_grouped_) rows_before_.group(before_.pairs(), set_.owner_limit());
  if (!is_grouped_) rows_.group(pairs_.pairs(), set_.owner_limit());
  is_before_grouped_ = is_grouped_ = true;
  append_changes(rows_before_, rows_, rows_to_sort_, begun_, ended_);
  has_difference_ = true;
}

std::span<const BoxPair> OverlapTracker::begun() {
  work_out_difference();
  return begun_.pairs();
}

std::span<const BoxPair> OverlapTracker::ended() {
  work_out_difference();
  return ended_.pairs();
}

std::size_t OverlapTracker::bytes_for_pairs() const {
  const std::size_t pairs = pairs_.capacity() + before_.capacity() + sorted_.capacity() +
                            begun_.capacity() + ended_.capacity() + former_pairs_.capacity() +
                            rows_to_sort_.left.capacity() + rows_to_sort_.right.capacity();
  return pairs * sizeof(BoxPair) + rows_.bytes() + rows_before_.bytes() + index_.bytes() +
         starts_.capacity() * 4 + movers_.capacity() * sizeof(Mover) +
         boxes_before_.capacity() * sizeof(OrderedBox) + hits_.capacity() * sizeof(MoverHit) +
         (lookup_.here.capacity() + lookup_.below.capacity()) * sizeof(Reached) + former_.bytes();
}

}  // namespace graze::bvh
