#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/world/contact_tracker.h>
#include <graze/engine/world/contacts/few_or_many.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>
#include <utility>
#include <vector>

namespace graze {

/// A contact as it was when its pair was last listed.
struct TrackedContact {
  std::uint64_t id;
  ContactFeature feature;
  Eigen::Vector3d point_a, point_b;  ///< in the frames of A and of B
  Eigen::Vector3d normal;            ///< in the world's frame
  double depth;
};

/// The contacts of one manifold: of two bodies, or of two parts of them.
struct TrackedManifold {
  std::pair<std::uint32_t, std::uint32_t> parts;
  FewOrMany<TrackedContact, Manifold::kMostOfRegion> contacts;
};

/// A pair as it was when it was last listed.
struct TrackedPair {
  BodyPair pair;
  const BodyShape* shape_a = nullptr;
  const BodyShape* shape_b = nullptr;
  double size = 0;  ///< of the smaller body, metres
  Pose pose_a = Pose::Identity(), pose_b = Pose::Identity();
  FewOrMany<TrackedManifold, 1> manifolds;  ///< ascending by parts
};

/// A pair of an old and a new contact that may be one, and how far they are apart.
struct TrackedMatch {
  double distance;
  std::uint32_t old, now;
  auto operator<=>(const TrackedMatch&) const = default;
};

/// The motion of a pair's bodies since it was last listed, and what it allows.
struct PairCourse {
  Pose a, b;                ///< where they are now
  double size = 0;          ///< of the smaller body, metres
  double same_place = 0;    ///< metres
  double moved = 0;         ///< how far points of the two moved, metres: the farthest that is known
  double least_cosine = 1;  ///< by which a normal may turn
};

namespace {

/// Returns the diagonal of the box around the shape in its own frame. It is infinite for a
/// half-space.
double diagonal_of(const BodyShape& shape) {
  const auto bounds = [&] { return shape.bounds(Pose::Identity()); };
  const Aabb box = shape.shape() != nullptr ? bounds() : bvh::in_users_arithmetic(bounds);
  const double size = (box.max - box.min).norm();
  return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

constexpr double kDegree = std::numbers::pi / 180;

/// Returns the least cosine by which a normal may turn, where bodies of such a size moved by so
/// much.
double least_cosine(double moved, double size) {
  constexpr double kFine = 1e-4;       // of the size: until there a degree is allowed
  constexpr double kMost = 30;         // degrees
  constexpr double kRounding = 1e-12;  // of a cosine; a degree takes 1.5e-4 from it
  if (moved <= kFine * size) return std::cos(kDegree) + kRounding;
  return std::cos(std::min(moved / (kFine * size), kMost) * kDegree) + kRounding;
}

/// True if law 15 lets `now` be the same contact as `old`.
bool may_go_on(const TrackedContact& old, const TrackedContact& now, const PairCourse& course) {
  constexpr double kTolerance = 1e-6;  // of the size, as the law has it
  const double change = std::abs(now.depth - old.depth);
  if (!(change <= 2 * course.moved + kTolerance * course.size)) return false;
  return old.normal.dot(now.normal) >= course.least_cosine;
}

/// Returns how far the farthest of the contacts' points moved with its body. The law takes the
/// farthest of all points of the bodies, so it allows whatever is allowed by this length.
double farthest_moved(std::span<const TrackedContact> contacts, const Pose& before, const Pose& now,
                      Eigen::Vector3d TrackedContact::*point) {
  const Eigen::Matrix3d turn = now.linear() - before.linear();
  const Eigen::Vector3d shift = now.translation() - before.translation();
  if (turn.isZero(0) && shift.isZero(0)) return 0;  // the body has not moved
  double most = 0;
  for (const TrackedContact& contact : contacts)
    most = std::max(most, (turn * (contact.*point) + shift).squaredNorm());
  return std::sqrt(most);
}

/// Returns how far `now` is from the place to which a body took `old`, the nearer of both places.
double distance_between(const TrackedContact& old, const TrackedContact& now) {
  return std::sqrt(std::min((old.point_a - now.point_a).squaredNorm(),
                            (old.point_b - now.point_b).squaredNorm()));
}

/// Gives contacts their old numbers and returns true if they are the same ones in the same order,
/// which is so for most pairs at rest: each has the feature that it had, stayed where it was and
/// may go on.
bool go_on_in_order(std::span<const TrackedContact> old, std::span<TrackedContact> now,
                    const PairCourse& course) {
  if (old.size() != now.size()) return false;
  for (std::size_t i = 0; i < old.size(); ++i) {
    if (old[i].feature != now[i].feature) return false;
    if (!(distance_between(old[i], now[i]) <= course.same_place)) return false;
    if (!may_go_on(old[i], now[i], course)) return false;
  }
  for (std::size_t i = 0; i < old.size(); ++i)
    now[i].id = old[i].id;
  return true;
}

void check_settings(const ContactTrackerSettings& settings) {
  if (std::isfinite(settings.same_place) && settings.same_place >= 0) return;
  throw InputError("ContactTracker: same_place is " + bvh::number_text(settings.same_place) +
                   ", but must be finite and not negative");
}

}  // namespace

struct ContactTracker::State {
  ContactTrackerSettings settings;
  std::vector<TrackedPair> pairs;                       ///< all pairs, and free places
  std::vector<std::uint32_t> free;                      ///< the free places
  std::unordered_map<BodyPair, std::uint32_t> numbers;  ///< the places in `pairs`
  /// The pairs that the last update listed, in its order, which ascends, and those of this one.
  /// Most pairs that are listed were listed before, and are found by going along `listed`.
  std::vector<std::uint32_t> listed, listing;
  std::size_t at = 0;  ///< in `listed`
  std::uint64_t last_id = 0;
  std::vector<std::uint64_t> ids;        ///< of all contacts of the last update
  std::vector<std::size_t> begins{0};    ///< of each manifold, in `ids`, and their end
  FewOrMany<TrackedManifold, 1> now;     ///< of a pair
  std::vector<TrackedContact> contacts;  ///< of a manifold
  std::vector<TrackedMatch> matches;
  std::vector<std::uint8_t> has_gone_on;  ///< of old contacts

  void drop_ended(const WorldUpdate& update);
  void forget(const BodyPair& pair);
  std::uint32_t number_of(const BodyPair& pair);
  void take_pair(const World& world, std::span<const BodyContact> manifolds);
  void take_manifolds(std::span<const BodyContact> manifolds, TrackedPair& pair,
                      const PairCourse& course);
  void take_manifold(const Manifold& found, const TrackedPair& pair, TrackedManifold& kept,
                     PairCourse course);
  void match(std::span<const TrackedContact> old, const PairCourse& course);
};

ContactTracker::ContactTracker(const ContactTrackerSettings& settings)
    : state_(std::make_unique<State>()) {
  bvh::in_standard_arithmetic([&] { check_settings(settings); });
  state_->settings = settings;
}
ContactTracker::~ContactTracker() = default;
ContactTracker::ContactTracker(ContactTracker&&) noexcept = default;
ContactTracker& ContactTracker::operator=(ContactTracker&&) noexcept = default;

/// Forgets pairs that ended, and pairs that touch but have no contacts any more because one body is
/// a sensor now. A pair that no longer touches may still be within its margin. Then it is listed,
/// and is kept.
void ContactTracker::State::drop_ended(const WorldUpdate& update) {
  for (const std::span<const BodyPair> list : {update.ended, update.ended_near, update.moved}) {
    auto next = update.contacts.begin();
    const auto end = update.contacts.end();
    for (const BodyPair& pair : list) {
      // The pair is mostly the next one.
      if (next != end && next->pair < pair) ++next;
      if (next != end && next->pair < pair)
        next = std::ranges::lower_bound(next, end, pair, {}, &BodyContact::pair);
      if (next == end || next->pair != pair) forget(pair);
    }
  }
}

void ContactTracker::State::forget(const BodyPair& pair) {
  const auto found = numbers.find(pair);
  if (found == numbers.end()) return;
  const std::uint32_t number = found->second;
  numbers.erase(found);
  pairs[number] = {};
  pairs[number].pair = pair;  // so that `listed` still ascends
  free.push_back(number);
}

/// Returns the place of a pair. A new pair gets a new place. Within an update pairs must be asked
/// for in ascending order.
std::uint32_t ContactTracker::State::number_of(const BodyPair& pair) {
  while (at < listed.size() && pairs[listed[at]].pair < pair)
    ++at;
  if (at < listed.size() && pairs[listed[at]].pair == pair) return listed[at++];
  if (free.empty()) {
    pairs.emplace_back();
    free.push_back(static_cast<std::uint32_t>(pairs.size() - 1));
  }
  const auto [found, is_new] = numbers.try_emplace(pair, free.back());
  if (!is_new) return found->second;
  free.pop_back();
  pairs[found->second].pair = pair;
  return found->second;
}

/// Gives numbers to `contacts`: those of old ones that go on, and new ones.
void ContactTracker::State::match(std::span<const TrackedContact> old, const PairCourse& course) {
  if (go_on_in_order(old, contacts, course)) return;
  matches.clear();
  for (std::uint32_t i = 0; i < old.size(); ++i) {
    for (std::uint32_t j = 0; j < contacts.size(); ++j) {
      double distance = distance_between(old[i], contacts[j]);
      const bool is_near = distance <= course.same_place;
      if (!is_near && old[i].feature != contacts[j].feature) continue;
      if (!may_go_on(old[i], contacts[j], course)) continue;
      if (!is_near) distance = std::numeric_limits<double>::infinity();
      matches.push_back({distance, i, j});
    }
  }
  std::ranges::sort(matches);
  has_gone_on.assign(old.size(), 0);
  for (const TrackedMatch& each : matches) {
    if (has_gone_on[each.old] != 0 || contacts[each.now].id != 0) continue;
    has_gone_on[each.old] = 1;
    contacts[each.now].id = old[each.old].id;
  }
  for (TrackedContact& contact : contacts) {
    if (contact.id == 0) contact.id = ++last_id;
  }
}

/// Takes a manifold. `kept` holds the contacts that it had, and is given the new ones.
void ContactTracker::State::take_manifold(const Manifold& found, const TrackedPair& pair,
                                          TrackedManifold& kept, PairCourse course) {
  contacts.clear();
  const Pose to_a = course.a.inverse(Eigen::Isometry);
  const Pose to_b = course.b.inverse(Eigen::Isometry);
  for (const ShapeContact& contact : found) {
    contacts.push_back({.id = 0,
                        .feature = contact.feature,
                        .point_a = to_a * contact.point_a,
                        .point_b = to_b * contact.point_b,
                        .normal = contact.normal,
                        .depth = contact.depth});
  }
  const std::span<const TrackedContact> old = kept.contacts.all();
  for (const std::span<const TrackedContact> list :
       {old, std::span<const TrackedContact>(contacts)}) {
    course.moved = std::max(
        {course.moved, farthest_moved(list, pair.pose_a, course.a, &TrackedContact::point_a),
         farthest_moved(list, pair.pose_b, course.b, &TrackedContact::point_b)});
  }
  course.least_cosine = least_cosine(course.moved, course.size);
  match(old, course);
  for (const TrackedContact& contact : contacts)
    ids.push_back(contact.id);
  begins.push_back(ids.size());
  kept.contacts.assign(contacts);
}

/// Takes the manifolds of a pair. Compounds have one for each two parts that meet, and old and new
/// ones ascend by parts.
void ContactTracker::State::take_manifolds(std::span<const BodyContact> manifolds,
                                           TrackedPair& pair, const PairCourse& course) {
  const std::span<TrackedManifold> before = pair.manifolds.all();
  const auto parts_of = [](const BodyContact& each) {
    return std::pair(each.manifold.part_a(), each.manifold.part_b());
  };
  if (manifolds.size() == 1 && before.size() == 1 && before[0].parts == parts_of(manifolds[0])) {
    take_manifold(manifolds[0].manifold, pair, before[0], course);
  } else {
    now.clear();
    auto old = before.begin();
    for (const BodyContact& each : manifolds) {
      const std::pair parts = parts_of(each);
      while (old != before.end() && old->parts < parts)
        ++old;
      const bool was_there = old != before.end() && old->parts == parts;
      now.push_back(was_there ? std::move(*old++)
                              : TrackedManifold{.parts = parts, .contacts = {}});
      take_manifold(each.manifold, pair, now.back(), course);
    }
    std::swap(pair.manifolds, now);
  }
  pair.pose_a = course.a;
  pair.pose_b = course.b;
}

void ContactTracker::State::take_pair(const World& world, std::span<const BodyContact> manifolds) {
  const BodyPair ids_of_pair = manifolds.front().pair;
  const BodyShape& shape_a = world.shape(ids_of_pair.a);
  const BodyShape& shape_b = world.shape(ids_of_pair.b);
  PairCourse course{.a = world.pose(ids_of_pair.a), .b = world.pose(ids_of_pair.b)};
  const std::uint32_t number = number_of(ids_of_pair);
  TrackedPair& pair = pairs[number];
  try {
    if (pair.shape_a != &shape_a || pair.shape_b != &shape_b) {
      pair.size = std::min(diagonal_of(shape_a), diagonal_of(shape_b));
      pair.shape_a = &shape_a, pair.shape_b = &shape_b;
    }
    course.size = pair.size;
    course.same_place = settings.same_place * pair.size;
    take_manifolds(manifolds, pair, course);
    listing.push_back(number);
  } catch (...) {
    forget(ids_of_pair);
    throw;
  }
}

void ContactTracker::take(const World& world, const WorldUpdate& update) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    state.ids.clear();
    state.begins.resize(1);
    state.drop_ended(update);
    state.listing.clear();
    state.at = 0;
    const std::span<const BodyContact> all = update.contacts;
    try {
      for (std::size_t begin = 0; begin < all.size();) {
        std::size_t end = begin + 1;
        while (end < all.size() && all[end].pair == all[begin].pair)
          ++end;
        state.take_pair(world, all.subspan(begin, end - begin));
        begin = end;
      }
      std::swap(state.listed, state.listing);
    } catch (...) {
      state.listed.clear();
      state.begins.resize(1);
      throw;
    }
  });
}

void ContactTracker::clear() {
  state_->pairs.clear();
  state_->free.clear();
  state_->numbers.clear();
  state_->listed.clear();
  state_->ids.clear();
  state_->begins.resize(1);
}

std::span<const std::uint64_t> ContactTracker::ids(std::size_t index) const {
  const std::vector<std::size_t>& begins = state_->begins;
  if (index >= begins.size() - 1) {
    throw InputError("ContactTracker::ids: there is no manifold " + std::to_string(index) +
                         "; there are " + std::to_string(begins.size() - 1),
                     {.element = "manifold", .index = index});
  }
  return std::span(state_->ids).subspan(begins[index], begins[index + 1] - begins[index]);
}

std::size_t ContactTracker::size() const {
  std::size_t count = 0;
  for (const TrackedPair& pair : state_->pairs) {
    for (const TrackedManifold& each : pair.manifolds.all())
      count += each.contacts.size();
  }
  return count;
}

}  // namespace graze
