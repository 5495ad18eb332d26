#include <graze/engine/world/bodies/pair_batches.h>

namespace graze {

void PairBatches::begin_batch() {
  if (count_ == batches_.size()) batches_.emplace_back();
  batches_[count_].first = pairs_;
  if (count_ != 0) batches_[count_ - 1].end = pairs_;
  ++count_;
  open_cost_ = 0;
}

void PairBatches::begin_asking() {
  answers_.resize(pairs_);
  if (count_ != 0) batches_[count_ - 1].end = pairs_;
  next_ = 0;
  failed_ = kNone;
  failure_ = nullptr;
}

void PairBatches::note_failure(std::uint32_t pair) {
  const std::lock_guard lock(failing_);
  if (pair >= failed_) return;
  failed_ = pair;
  failure_ = std::current_exception();
}

void PairBatches::make_room_in(ContactList& all) {
  for (PairBatch& batch : batches())
    batch.place_of_contacts = all.make_room_for(batch.news.contacts);
}

void PairBatches::make_room_in(PairNews& all) {
  NewsPlace next{all.begun.size(), all.ended.size(), all.begun_near.size(), all.ended_near.size(),
                 all.moved.size()};
  for (PairBatch& batch : batches()) {
    batch.place = next;
    next.begun += batch.news.begun.size();
    next.ended += batch.news.ended.size();
    next.begun_near += batch.news.begun_near.size();
    next.ended_near += batch.news.ended_near.size();
    next.moved += batch.news.moved.size();
  }
  all.moved.resize(next.moved);
  graze::make_room_in(all.begun, next.begun - all.begun.size());
  graze::make_room_in(all.ended, next.ended - all.ended.size());
  graze::make_room_in(all.begun_near, next.begun_near - all.begun_near.size());
  graze::make_room_in(all.ended_near, next.ended_near - all.ended_near.size());
  all.begun.resize(next.begun);
  all.ended.resize(next.ended);
  all.begun_near.resize(next.begun_near);
  all.ended_near.resize(next.ended_near);
}

void put_contacts(const PairBatch& batch, ContactList& all) {
  std::size_t place = batch.place_of_contacts;
  for (const BodyContact& contact : batch.news.contacts.all())
    all.put(place++, contact);
}

void put_pairs(const PairBatch& batch, PairNews& all) noexcept {
  const auto put = [](const std::vector<BodyPair>& pairs, std::vector<BodyPair>& to,
                      std::size_t place) {
    std::copy(pairs.begin(), pairs.end(), to.begin() + static_cast<std::ptrdiff_t>(place));
  };
  put(batch.news.begun, all.begun, batch.place.begun);
  put(batch.news.ended, all.ended, batch.place.ended);
  put(batch.news.begun_near, all.begun_near, batch.place.begun_near);
  put(batch.news.ended_near, all.ended_near, batch.place.ended_near);
  put(batch.news.moved, all.moved, batch.place.moved);
}

}  // namespace graze
