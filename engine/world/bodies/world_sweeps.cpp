// Finds when bodies that are swept meet others between the last update and this one.

#include <graze/bvh/error.h>
#include <graze/engine/world/bodies/world_state.h>
#include <graze/engine/world/body_shapes/moving_parts.h>
#include <graze/engine/world/manifold.h>
#include <graze/engine/world/rigid/sliding_contact.h>
#include <graze/engine/world/shapes/shape_work.h>
#include <graze/narrowphase/volumes/aabb_overlap.h>

#include <algorithm>
#include <exception>
#include <limits>

namespace graze {
namespace {

/// A thread asks so many pairs in one go.
constexpr std::size_t kPart = 4;

constexpr RigidContact kUnknown{
    .status = RigidStatus::Close, .low = 0, .high = 1, .is_out_of_budget = true};

Aabb everything() {
  const Eigen::Vector3d all = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  return {-all, all};
}

/// The normal and the point at which two shapes that are near each other meet.
struct Meeting {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

Meeting meeting_of(const PlacedShape& a, const PlacedShape& b) {
  const ShapeDistance found = distance(a, b, &shape_work());
  if (found.distance > 0) return {found.normal, found.point_a / 2 + found.point_b / 2};
  if (pair_method(a.shape.kind(), b.shape.kind()) == PairMethod::Planes) return {};
  const Manifold contacts = find_contacts(a, b, {}, &shape_work());
  const ShapeContact* deepest = nullptr;
  for (const ShapeContact& contact : contacts) {
    if (deepest == nullptr || contact.depth > deepest->depth) deepest = &contact;
  }
  if (deepest == nullptr) return {};
  return {deepest->normal, deepest->point};
}

/// A body and its motion since the last update.
struct BodyInMotion {
  const Bodies::Body& body;
  std::optional<RigidMotion> motion;  ///< nothing if the motion cannot be computed
};

/// The shape of a body that meets another, or a part of it, in motion.
struct SweptBodyShape {
  const BodyShape& shape;
  const std::optional<RigidMotion>& motion;
  std::uint32_t part = 0;

  template <typename Question>
  auto ask(const Question& question) const {
    return ask_shape(is_users_shape(shape), [&] { return question(shape); });
  }
};

const Shape* known_shape(const SweptBodyShape& moving) {
  return moving.ask([](const BodyShape& shape) { return shape.shape(); });
}

/// Returns a body and its motion. There is none where a pose deviates from a rotation as far as is
/// accepted, because a turn of it could deviate too far.
BodyInMotion in_motion(const Bodies::Body& body, const Mover* mover) {
  if (mover != nullptr && mover->motion) return {body, mover->motion};
  try {
    return {body, RigidMotion::between(mover == nullptr ? body.pose : mover->before, body.pose)};
  } catch (const PoseError&) {
    return {body, std::nullopt};
  }
}

/// Returns a box around all places of a body.
Aabb swept_box(const BodyInMotion& moving) {
  if (!moving.motion) return everything();
  try {
    return swept_box(*moving.body.shape, *moving.motion);
  } catch (const PoseError&) {
    return everything();  // so far away that numbers could overflow
  }
}

RigidContact contact_of(const SweptBodyShape& a, const SweptBodyShape& b,
                        const RigidContactSettings& settings) {
  if (!a.motion || !b.motion) return kUnknown;
  try {
    return a.ask([&](const BodyShape& shape) {
      return shape.first_contact(*a.motion, b.shape, *b.motion, settings);
    });
  } catch (const PoseError&) {
    return kUnknown;  // so far away that numbers could overflow
  } catch (const UnsupportedPairError&) {
    return kUnknown;  // two half-spaces of which one turns
  }
}

/// Adds the first contact of a pair, if there is one, and the one after sliding.
template <typename Add>
void add_first_contacts(const BodyPair& pair, const SweptBodyShape& a, const SweptBodyShape& b,
                        const WorldSettings& settings, const Add& add) {
  BodyFirstContact found{.pair = pair,
                         .contact = contact_of(a, b, settings.sweeps),
                         .is_at_start = false,
                         .normal = Eigen::Vector3d::Zero(),
                         .point = Eigen::Vector3d::Zero(),
                         .part_a = a.part,
                         .part_b = b.part};
  const double low = found.contact.low;
  if (found.contact.status == RigidStatus::Free) return;
  if (a.motion && b.motion && low == 0) {
    found.is_at_start = a.ask([&](const BodyShape& shape) {
      return shape.touches(a.motion->start(), b.shape, b.motion->start());
    });
  }
  const Shape* shape_a = known_shape(a);
  const Shape* shape_b = known_shape(b);
  const bool are_known = a.motion && b.motion && shape_a != nullptr && shape_b != nullptr;
  if (are_known) {
    const Meeting meeting =
        meeting_of({*shape_a, a.motion->at(low)}, {*shape_b, b.motion->at(low)});
    found.normal = meeting.normal, found.point = meeting.point;
  }
  add(found);
  if (!are_known || low > 0) return;
  const auto next = contact_after_sliding(*shape_a, *a.motion, *shape_b, *b.motion, settings.sweeps,
                                          settings.sliding_depth, shape_work());
  if (next) add({pair, next->contact, false, next->normal, next->point, a.part, b.part});
}

/// Adds the first contacts of all pairs of parts, by time. Where motions are too far away to look
/// parts up, the answer for the whole compounds is unknown.
void add_of_parts(const BodyPair& pair, const BodyInMotion& a, const BodyInMotion& b,
                  const WorldSettings& settings, std::vector<BodyFirstContact>& to) {
  const auto add = [&](const BodyFirstContact& found) { to.push_back(found); };
  try {
    for_moving_part_pairs(
        {*a.body.shape, *a.motion, a.body.filter}, {*b.body.shape, *b.motion, b.body.filter},
        settings.sweeps, [&](const MovingPart& s, const MovingPart& t) {
          add_first_contacts(pair, {*s.placed.shape, s.motion, s.placed.number},
                             {*t.placed.shape, t.motion, t.placed.number}, settings, add);
        });
  } catch (const PoseError&) {
    to.assign(1, {.pair = pair,
                  .contact = kUnknown,
                  .is_at_start = false,
                  .normal = Eigen::Vector3d::Zero(),
                  .point = Eigen::Vector3d::Zero()});
  }
  std::stable_sort(to.begin(), to.end(), [](const BodyFirstContact& s, const BodyFirstContact& t) {
    return s.contact.low < t.contact.low;
  });
}

}  // namespace

void World::State::find_first_contacts() {
  if (!movers.are_noted()) return;
  const double others_travel = list_swept();
  list_swept_pairs(others_travel);
  ask_swept_pairs();
}

/// Lists the bodies that are swept, and others that moved by more than they are wide. There are few
/// of these, or such steps would not be used to simulate them. Returns the most that any other body
/// moved, metres.
double World::State::list_swept() {
  swept.clear();
  const auto is_swept = [&](const Mover& mover) {
    const Bodies::Body& body = all.bodies[mover.body];
    return body.detection == Detection::Continuous && body.is_awake;
  };
  double others_travel = 0;
  if (std::none_of(movers.list().begin(), movers.list().end(), is_swept)) return others_travel;
  for (Mover& mover : movers.list()) {
    const Bodies::Body& body = all.bodies[mover.body];
    mover.is_listed = is_swept(mover) || mover.travel > width_of(broad.box(broad.id(body.box)));
    if (mover.is_listed) {
      swept.push_back({mover.body, is_swept(mover), swept_box(in_motion(body, &mover))});
    } else {
      others_travel = std::max(others_travel, mover.travel);
    }
  }
  return others_travel;
}

/// Lists pairs of the listed bodies, by sweep and prune, and pairs of swept bodies and all others,
/// by the broad phase. A pair whose boxes overlap now has passed all filters; other pairs are
/// filtered here.
void World::State::list_swept_pairs(double others_travel) {
  swept_pairs.clear();
  std::sort(swept.begin(), swept.end(), [](const SweptBody& s, const SweptBody& t) {
    return s.box.min.x() != t.box.min.x() ? s.box.min.x() < t.box.min.x() : s.body < t.body;
  });
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const SweptBody& s = swept[i];
    const Aabb box = grown(s.box, settings.sweeps.clearance + settings.sweeps.tolerance);
    for (std::size_t j = i + 1; j < swept.size() && swept[j].box.min.x() <= box.max.x(); ++j) {
      if ((s.is_swept || swept[j].is_swept) && intersects(box, swept[j].box))
        swept_pairs.push_back(ordered_pair(s.body, swept[j].body));
    }
    if (s.is_swept) list_partners_of(s.body, box, others_travel);
  }
  std::sort(swept_pairs.begin(), swept_pairs.end());
  std::erase_if(swept_pairs, [&](const BoxPair& pair) {
    if (candidates.position(pair) != CandidatePairs::kNowhere || all.may_meet(pair.a, pair.b))
      return false;
    if (all.pair_filter) journal.tell(PairChange::Refused, pair.a, pair.b);
    return true;
  });
}

/// Lists the pairs of a swept body, with a box around all its places, and bodies that are not
/// listed.
void World::State::list_partners_of(std::uint32_t index, const Aabb& box, double others_travel) {
  partners.clear();
  broad.find_overlapping(grown(box, others_travel), partners);
  for (const std::uint32_t partner : partners) {
    const std::uint32_t other = body_of_box[partner];
    const Mover* mover = movers.find(other);
    if (other == index || (mover != nullptr && mover->is_listed)) continue;
    const Aabb now = broad.box(broad.id(partner));
    if (intersects(box, mover == nullptr ? now : grown(now, mover->travel)))
      swept_pairs.push_back(ordered_pair(index, other));
  }
}

SweptAnswer World::State::ask_swept_pair(BoxPair pair) const {
  SweptAnswer answer;
  const BodyInMotion a = in_motion(all.bodies[pair.a], movers.find(pair.a));
  const BodyInMotion b = in_motion(all.bodies[pair.b], movers.find(pair.b));
  if (all.has_parts(pair) && a.motion && b.motion) {
    add_of_parts(all.id_pair(pair), a, b, settings, answer.of_parts);
    return answer;
  }
  add_first_contacts(all.id_pair(pair), {*a.body.shape, a.motion}, {*b.body.shape, b.motion},
                     settings, [&](const BodyFirstContact& found) {
                       (answer.first ? answer.after_sliding : answer.first) = found;
                     });
  return answer;
}

/// Asks all pairs for their first contact. The caller's thread asks shapes of a user's own.
void World::State::ask_swept_pairs() {
  const std::size_t count = swept_pairs.size();
  news.work.pairs_swept = count;
  std::vector<SweptAnswer>& answers = swept_answers;
  std::vector<SweptPart>& parts = swept_parts;
  answers.assign(count, {});
  parts.assign((count + kPart - 1) / kPart, {});
  const auto is_for_caller = [&](BoxPair pair) {
    return all.bodies[pair.a].is_users || all.bodies[pair.b].is_users;
  };
  workers.for_each(parts.size(), [&](std::size_t part) {
    const ShapeWorkScope counting(parts[part].work);
    try {
      for (std::size_t i = part * kPart; i < std::min((part + 1) * kPart, count); ++i) {
        if (!is_for_caller(swept_pairs[i])) answers[i] = ask_swept_pair(swept_pairs[i]);
      }
    } catch (...) {
      parts[part].failure = std::current_exception();
    }
  });
  for (const SweptPart& part : parts) {
    if (part.failure) std::rethrow_exception(part.failure);
    news.work.shapes += part.work;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (is_for_caller(swept_pairs[i])) answers[i] = ask_swept_pair(swept_pairs[i]);
    if (answers[i].first) news.first_contacts.push_back(*answers[i].first);
    if (answers[i].after_sliding) news.first_contacts.push_back(*answers[i].after_sliding);
    for (const BodyFirstContact& of_parts : answers[i].of_parts)
      news.first_contacts.push_back(of_parts);
  }
}

}  // namespace graze
