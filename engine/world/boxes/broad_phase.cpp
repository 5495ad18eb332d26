#include <graze/bvh/box_set/overlap_tracker.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/checks.h>
#include <graze/bvh/value/element_error.h>
#include <graze/engine/mesh/query/threads.h>
#include <graze/engine/world/boxes/id_table.h>
#include <graze/engine/world/broad_phase.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <string>

namespace graze {
namespace {

constexpr std::size_t kChunk = 4096;  // how many boxes of a span are checked at a time

// Checks many boxes at a time: finding the least and the greatest numbers takes fewer instructions
// than classifying each number. A comparison with NaN is false.
class BoxCheck {
 public:
  void add(const Aabb& box) {
    const double* low = box.min.data();
    const double* high = box.max.data();
    for (int k = 0; k < 3; ++k) {
      is_ordered_ &= low[k] <= high[k];
      lowest_ = low[k] < lowest_ ? low[k] : lowest_;
      highest_ = high[k] > highest_ ? high[k] : highest_;
    }
  }
  bool is_good() const { return is_ordered_ && std::isfinite(lowest_) && std::isfinite(highest_); }

 private:
  bool is_ordered_ = true;
  double lowest_ = 0, highest_ = 0;
};

}  // namespace

struct BroadPhase::State {
  explicit State(int threads) : tracker(threads) {}

  IdTable<std::uint16_t> ids;  ///< the ids, which take two bytes for each box
  bvh::OverlapTracker tracker;
  std::mutex preparing;
  std::atomic<bool> is_ready{true};  ///< true if the trees fit the boxes
  BroadPhaseWork work;

  void check(BoxId id, const char* what) const {
    if (ids.is_live(id.index, id.generation)) return;
    throw StaleIdError(std::string(what) + ": there is no box with index " +
                           std::to_string(id.index) + " and generation " +
                           std::to_string(id.generation),
                       {.element = "box", .index = id.index});
  }

  void set_changed() { is_ready.store(false, std::memory_order_relaxed); }

  /// Returns the boxes, ready for queries. The first query after a change makes them ready, and
  /// queries that run at the same time wait for it.
  const bvh::BoxSet& ready_set() {
    if (!is_ready.load(std::memory_order_acquire)) {
      const std::lock_guard lock(preparing);
      if (!is_ready.load(std::memory_order_relaxed)) {
        tracker.prepare_for_queries();
        is_ready.store(true, std::memory_order_release);
      }
    }
    return tracker.set();
  }

  /// Returns a box. This needs no bounds of trees, but boxes may change places while another thread
  /// makes them ready.
  bvh::OrderedBox box(std::uint32_t index) {
    if (is_ready.load(std::memory_order_acquire)) return tracker.set().store().box(index);
    const std::lock_guard lock(preparing);
    tracker.make_waiting_changes();
    return tracker.set().store().box(index);
  }
};

BroadPhase::BroadPhase(const BroadPhaseSettings& settings) {
  check_threads(settings.threads);
  state_ = std::make_unique<State>(static_cast<int>(thread_count(settings.threads)));
}

BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

// Public functions do their work in in_standard_arithmetic(), which makes the CPU round as all
// error bounds assume while it calls the function that it is given.

BoxId BroadPhase::add(const Aabb& box) {
  return bvh::in_standard_arithmetic([&]() -> BoxId {
    bvh::check_box(box, "add");
    state_->ids.prepare_take();
    state_->set_changed();
    state_->tracker.insert(state_->ids.next(), box);
    const std::uint32_t index = state_->ids.take();
    return {index, state_->ids.generation(index)};
  });
}

void BroadPhase::move(BoxId id, const Aabb& box) {
  bvh::in_standard_arithmetic([&] {
    state_->check(id, "move");
    bvh::check_box(box, "move");
    state_->set_changed();
    state_->tracker.move(id.index, box);
  });
}

void BroadPhase::move(std::span<const BoxId> ids, std::span<const Aabb> boxes) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    if (ids.size() != boxes.size()) {
      throw InputError("move: " + std::to_string(ids.size()) + " ids, but " +
                       std::to_string(boxes.size()) + " boxes");
    }
    const std::size_t chunks = (ids.size() + kChunk - 1) / kChunk;
    std::atomic<bool> is_valid{true}, is_in_order{true}, is_ascending{true};
    state.tracker.set().workers().for_each(chunks, [&](std::size_t chunk) {
      BoxCheck check;
      bool is_live = true, is_own_number = true, ascends = true;
      for (std::size_t i = chunk * kChunk; i < std::min((chunk + 1) * kChunk, ids.size()); ++i) {
        check.add(boxes[i]);
        is_live &= state.ids.is_live(ids[i].index, ids[i].generation);
        is_own_number &= ids[i].index == i;
        ascends &= i == 0 || ids[i - 1].index < ids[i].index;
      }
      if (!is_live || !check.is_good()) is_valid = false;
      if (!is_own_number) is_in_order = false;
      if (!ascends) is_ascending = false;
    });
    for (std::size_t i = 0; !is_valid && i < ids.size(); ++i) {
      const std::string what = "move, element " + std::to_string(i);
      bvh::at_element("element", i, [&] {
        state.check(ids[i], what.c_str());
        bvh::check_box(boxes[i], what.c_str());
      });
    }
    if (ids.empty()) return;
    state.set_changed();
    const auto proxy_of = [&](std::size_t i) { return ids[i].index; };
    if (!state.tracker.are_many(ids.size())) {
      for (std::size_t i = 0; i < ids.size(); ++i)
        state.tracker.move(ids[i].index, boxes[i]);
    } else if (is_in_order) {
      state.tracker.move_first(boxes);
    } else if (is_ascending) {
      state.tracker.move_ascending(boxes, proxy_of);
    } else {
      state.tracker.move_many(boxes, proxy_of);
    }
  });
}

void BroadPhase::remove(BoxId id) {
  bvh::in_standard_arithmetic([&] {
    state_->check(id, "remove");
    state_->ids.prepare_free();
    state_->set_changed();
    state_->tracker.erase(id.index);
    state_->ids.free(id.index);
  });
}

void BroadPhase::update() {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    const bool has_changed = state.tracker.update();
    ++state.work.updates;
    state.is_ready = true;
    state.ids.next_round();
    if (!has_changed) return;
    state.work.searches_for_all = state.tracker.searches_for_all();
    state.work.searches_for_movers = state.tracker.searches_for_movers();
    state.work.sorts = state.tracker.set().order().sorts();
    state.work.groups_sorted = state.tracker.set().order().groups_sorted();
    state.work.blocks_met = state.tracker.set().search().blocks_met();
  });
}

std::size_t BroadPhase::size() const {
  return state_->ids.live_count();
}

bool BroadPhase::contains(BoxId id) const {
  return state_->ids.is_live(id.index, id.generation);
}

Aabb BroadPhase::box(BoxId id) const {
  return bvh::in_standard_arithmetic([&]() -> Aabb {
    state_->check(id, "box");
    return bvh::box_of_keys(state_->box(id.index));
  });
}

BoxId BroadPhase::id(std::uint32_t index) const {
  if (!state_->ids.is_live(index)) {
    throw StaleIdError("id: there is no box with index " + std::to_string(index),
                       {.element = "box", .index = index});
  }
  return {index, state_->ids.generation(index)};
}

std::span<const BoxPair> BroadPhase::pairs() const {
  return state_->tracker.pairs();
}

std::span<const BoxPair> BroadPhase::sorted_pairs() {
  return state_->tracker.sorted_pairs();
}

std::span<const BoxPair> BroadPhase::begun() {
  return bvh::in_standard_arithmetic(
      [&]() -> std::span<const BoxPair> { return state_->tracker.begun(); });
}

std::span<const BoxPair> BroadPhase::ended() {
  return bvh::in_standard_arithmetic(
      [&]() -> std::span<const BoxPair> { return state_->tracker.ended(); });
}

void BroadPhase::find_overlapping(const Aabb& box, std::vector<std::uint32_t>& indices) const {
  bvh::in_standard_arithmetic([&] {
    bvh::check_box(box, "find_overlapping");
    state_->ready_set().search().find_overlapping(bvh::ordered_box(box), indices);
  });
}

void BroadPhase::visit_along(const Ray& ray, const RayBoxVisitor& visit) const {
  bvh::in_standard_arithmetic([&] {
    check_ray(ray, "visit_along");
    const bvh::ScaledDirection scaled = bvh::scaled_direction(ray.direction.data());
    const bvh::RaySlabs slabs(ray.origin.data(), scaled.component);
    const auto limit_for = [&, length = bvh::length_of(scaled)](double distance) {
      return distance / length * (1 + 0x10p-53) + 0x1p-1050;
    };
    double limit = limit_for(ray.max_distance);
    const auto visited = [&](std::uint32_t index) {
      return bvh::in_users_arithmetic([&] { return visit(index); });
    };
    const auto look = [&](std::uint32_t index) { return limit_for(visited(index)); };
    state_->ready_set().search().walk_along(slabs, limit, std::cref(look));
  });
}

const BroadPhaseWork& BroadPhase::work() const {
  return state_->work;
}

std::size_t BroadPhase::bytes_for_boxes() const {
  const State& state = *state_;
  return state.tracker.set().bytes() + state.ids.bytes();
}

std::size_t BroadPhase::bytes_for_pairs() const {
  return state_->tracker.bytes_for_pairs();
}

}  // namespace graze
