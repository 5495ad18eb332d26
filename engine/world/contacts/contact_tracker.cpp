#include <graze/bvh/error.h>
#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/bvh/value/number_text.h>
#include <graze/engine/world/contact_tracker.h>

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

/// The contacts of one manifold, and where its bodies were.
struct TrackedManifold {
  std::uint32_t part_a = 0, part_b = 0;
  const BodyShape* shape_a = nullptr;
  const BodyShape* shape_b = nullptr;
  double size = 0;  ///< of the smaller body, metres
  Pose pose_a, pose_b;
  std::vector<TrackedContact> contacts;
};

/// A pair of an old and a new contact that may be one, and how far they are apart.
struct TrackedMatch {
  double distance;
  std::uint32_t old, now;
  auto operator<=>(const TrackedMatch&) const = default;
};

/// What the bodies of a pair did since it was last listed.
struct PairCourse {
  Pose a, b;          ///< where they are now
  double size;        ///< of the smaller body, metres
  double same_place;  ///< metres
  double moved = 0;   ///< how far points of the two moved, metres: the farthest that is known
};

namespace {

/// The diagonal of the box around the shape in its own frame; infinite of a half-space.
double diagonal_of(const BodyShape& shape) {
  const Aabb box = shape.bounds(Pose::Identity());
  const double size = (box.max - box.min).norm();
  return std::isfinite(size) ? size : std::numeric_limits<double>::infinity();
}

constexpr double kDegree = std::numbers::pi / 180;

/// Whether a normal that turned this far may belong to the same contact, where bodies of such a
/// size moved by so much.
bool may_turn(double cosine, double moved, double size) {
  constexpr double kFine = 1e-4;       // of the size: until there a degree is allowed
  constexpr double kMost = 30;         // degrees
  constexpr double kRounding = 1e-12;  // of a cosine of unit vectors; of that of a degree 2e-4
  static const double of_a_degree = std::cos(kDegree);
  if (moved <= kFine * size) return cosine >= of_a_degree + kRounding;
  return cosine >= std::cos(std::min(moved / (kFine * size), kMost) * kDegree) + kRounding;
}

/// Whether law 15, 4 lets `now` go on what `old` was.
bool may_go_on(const TrackedContact& old, const TrackedContact& now, const PairCourse& course) {
  constexpr double kTolerance = 1e-6;  // of the size, as the law has it
  const double change = std::abs(now.depth - old.depth);
  if (!(change <= 2 * course.moved + kTolerance * course.size)) return false;
  return may_turn(old.normal.dot(now.normal), course.moved, course.size);
}

/// How far the farthest of the contacts' points moved with its body. They are points of the bodies,
/// so that what is allowed by them is allowed by the law.
double farthest_moved(std::span<const TrackedContact> contacts, const Pose& before, const Pose& now,
                      Eigen::Vector3d TrackedContact::*point) {
  const Eigen::Matrix3d turn = now.linear() - before.linear();
  const Eigen::Vector3d shift = now.translation() - before.translation();
  if (turn.isZero(0) && shift.isZero(0)) return 0;  // as of what is fixed
  double most = 0;
  for (const TrackedContact& contact : contacts)
    most = std::max(most, (turn * (contact.*point) + shift).squaredNorm());
  return std::sqrt(most);
}

/// How far `now` is from where either body took `old`, on that on which it is nearer.
double distance_between(const TrackedContact& old, const TrackedContact& now) {
  return std::sqrt(std::min((old.point_a - now.point_a).squaredNorm(),
                            (old.point_b - now.point_b).squaredNorm()));
}

/// Whether contacts are the same ones in the same order, as of most pairs at rest: each has the
/// feature that it had, stayed where it was and may go on. Gives them their numbers.
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
  std::unordered_map<BodyPair, std::vector<TrackedManifold>> pairs;
  std::uint64_t last_id = 0;
  std::size_t swept_size = 0;            ///< pairs that were left when gone bodies were looked for
  std::vector<std::uint64_t> ids;        ///< of all contacts of the last update
  std::vector<std::size_t> begins;       ///< of each manifold, in `ids`, and their end
  std::vector<TrackedManifold> now;      ///< of a pair
  std::vector<TrackedContact> contacts;  ///< of a manifold
  std::vector<TrackedMatch> matches;
  std::vector<std::uint8_t> has_gone_on;  ///< of old contacts

  void drop_ended(const World& world, const WorldUpdate& update);
  void drop_gone(const World& world);
  void take_pair(const World& world, std::span<const BodyContact> manifolds);
  void take_manifold(const BodyContact& found, TrackedManifold& kept, PairCourse course);
  void match(std::span<const TrackedContact> old, const PairCourse& course);
};

ContactTracker::ContactTracker(const ContactTrackerSettings& settings)
    : state_(std::make_unique<State>()) {
  check_settings(settings);
  state_->settings = settings;
  state_->begins.push_back(0);
}
ContactTracker::~ContactTracker() = default;
ContactTracker::ContactTracker(ContactTracker&&) noexcept = default;
ContactTracker& ContactTracker::operator=(ContactTracker&&) noexcept = default;

/// A pair ends where it is neither touching nor within its margin: where it is still listed it is.
void ContactTracker::State::drop_ended(const World& world, const WorldUpdate& update) {
  const auto is_listed = [&](const BodyPair& pair) {
    const auto at = std::ranges::lower_bound(update.contacts, pair, {}, &BodyContact::pair);
    return at != update.contacts.end() && at->pair == pair;
  };
  for (const std::span<const BodyPair> ended : {update.ended, update.ended_near}) {
    for (const BodyPair& pair : ended) {
      if (!is_listed(pair)) pairs.erase(pair);
    }
  }
  constexpr std::size_t kFew = 64;
  if (pairs.size() > 2 * swept_size + kFew) drop_gone(world);
}

/// What only sides bring together ends without a word, as it does not touch.
void ContactTracker::State::drop_gone(const World& world) {
  std::erase_if(pairs, [&](const auto& each) {
    return !world.contains(each.first.a) || !world.contains(each.first.b);
  });
  swept_size = pairs.size();
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

void ContactTracker::State::take_manifold(const BodyContact& found, TrackedManifold& kept,
                                          PairCourse course) {
  contacts.clear();
  const Pose to_a = course.a.inverse(Eigen::Isometry);
  const Pose to_b = course.b.inverse(Eigen::Isometry);
  for (const ShapeContact& contact : found.manifold) {
    contacts.push_back({.id = 0,
                        .feature = contact.feature,
                        .point_a = to_a * contact.point_a,
                        .point_b = to_b * contact.point_b,
                        .normal = contact.normal,
                        .depth = contact.depth});
  }
  for (const std::span<const TrackedContact> list :
       {std::span(kept.contacts), std::span(contacts)}) {
    course.moved = std::max(
        {course.moved, farthest_moved(list, kept.pose_a, course.a, &TrackedContact::point_a),
         farthest_moved(list, kept.pose_b, course.b, &TrackedContact::point_b)});
  }
  match(kept.contacts, course);
  for (const TrackedContact& contact : contacts)
    ids.push_back(contact.id);
  begins.push_back(ids.size());
  std::swap(kept.contacts, contacts);
  kept.pose_a = course.a;
  kept.pose_b = course.b;
}

/// Of compounds there is a manifold for each two parts that meet.
void ContactTracker::State::take_pair(const World& world, std::span<const BodyContact> manifolds) {
  const BodyPair ids_of_pair = manifolds.front().pair;
  const Pose& pose_a = world.pose(ids_of_pair.a);
  const Pose& pose_b = world.pose(ids_of_pair.b);
  const BodyShape& shape_a = world.shape(ids_of_pair.a);
  const BodyShape& shape_b = world.shape(ids_of_pair.b);
  std::vector<TrackedManifold>& old = pairs[ids_of_pair];
  now.resize(manifolds.size());
  const auto parts_of = [](const TrackedManifold& each) {
    return std::pair(each.part_a, each.part_b);
  };
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const Manifold& manifold = manifolds[i].manifold;
    const std::pair parts(manifold.part_a(), manifold.part_b());
    // They stand in one order, so that most are where they were.
    auto at = i < old.size() && parts_of(old[i]) == parts
                  ? old.begin() + static_cast<std::ptrdiff_t>(i)
                  : std::ranges::find(old, parts, parts_of);
    TrackedManifold& kept = now[i];
    if (at == old.end() || at->shape_a != &shape_a || at->shape_b != &shape_b) {
      kept.contacts.clear();
      kept.part_a = parts.first, kept.part_b = parts.second;
      kept.shape_a = &shape_a, kept.shape_b = &shape_b;
      kept.size = std::min(diagonal_of(shape_a), diagonal_of(shape_b));
      kept.pose_a = pose_a, kept.pose_b = pose_b;
    } else {
      std::swap(kept, *at);
    }
    take_manifold(manifolds[i], kept,
                  {.a = pose_a,
                   .b = pose_b,
                   .size = kept.size,
                   .same_place = settings.same_place * kept.size});
  }
  std::swap(old, now);
}

void ContactTracker::take(const World& world, const WorldUpdate& update) {
  bvh::in_standard_arithmetic([&] {
    State& state = *state_;
    state.ids.clear();
    state.begins.assign(1, 0);
    state.drop_ended(world, update);
    const std::span<const BodyContact> all = update.contacts;
    for (std::size_t begin = 0; begin < all.size();) {
      std::size_t end = begin + 1;
      while (end < all.size() && all[end].pair == all[begin].pair)
        ++end;
      state.take_pair(world, all.subspan(begin, end - begin));
      begin = end;
    }
  });
}

std::span<const std::uint64_t> ContactTracker::ids(std::size_t index) const {
  const std::vector<std::size_t>& begins = state_->begins;
  if (index + 1 >= begins.size()) {
    throw InputError("ContactTracker::ids: there is no manifold " + std::to_string(index) +
                     "; there are " + std::to_string(begins.size() - 1));
  }
  return std::span(state_->ids).subspan(begins[index], begins[index + 1] - begins[index]);
}

std::size_t ContactTracker::size() const {
  std::size_t count = 0;
  for (const auto& [pair, manifolds] : state_->pairs) {
    for (const TrackedManifold& each : manifolds)
      count += each.contacts.size();
  }
  return count;
}

}  // namespace graze
