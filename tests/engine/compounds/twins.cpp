#include "tests/engine/compounds/twins.h"

#include <graze/engine/print.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/engine/motion/moving_bodies.h"

namespace graze::tests {
namespace {

bool is_before(const NamedContact& s, const NamedContact& t) {
  return std::tie(s.a, s.b) < std::tie(t.a, t.b);
}

bool is_before(const NamedFirstContact& s, const NamedFirstContact& t) {
  return std::tie(s.a, s.b, s.contact.low) < std::tie(t.a, t.b, t.contact.low);
}

template <typename T>
std::vector<T> in_order(std::vector<T> list) {
  std::stable_sort(list.begin(), list.end(),
                   [](const T& s, const T& t) { return is_before(s, t); });
  return list;
}

/// Names the first two that differ.
void expect_same(const std::vector<NamedContact>& whole, const std::vector<NamedContact>& parts) {
  EXPECT_EQ(whole.size(), parts.size());
  const auto [s, t] = std::mismatch(whole.begin(), whole.end(), parts.begin(), parts.end());
  const auto tell = [](const char* world, const NamedContact& of) {
    ADD_FAILURE() << world << ": body " << of.a.first << ", part " << of.a.second << ", and body "
                  << of.b.first << ", part " << of.b.second << ": " << of.manifold;
  };
  if (s != whole.end()) tell("whole", *s);
  if (t != parts.end()) tell("parts", *t);
}

}  // namespace

Twins::Twins(const WorldSettings& settings) : whole_(settings), parts_(settings) {
  parts_.set_pair_filter([this](BodyId a, BodyId b) { return name(a).first != name(b).first; });
}

BodyId Twins::add_part(std::uint32_t body, std::uint32_t part) {
  const Body& of = bodies_[body];
  const PlacedShape& placed = of.compound.part(part);
  BodySettings settings = of.settings;
  if (const auto& filter = of.compound.settings(part).filter) settings.filter = *filter;
  const BodyId id = parts_.add({placed.shape, placed_part(of.pose, placed.pose)}, settings);
  if (id.index >= names_.size()) names_.resize(id.index + 1);
  names_[id.index] = {body, part};
  return id;
}

std::uint32_t Twins::add(const Compound& compound, const Pose& pose, const BodySettings& settings) {
  const auto number = static_cast<std::uint32_t>(bodies_.size());
  bodies_.push_back({whole_.add({share(compound), pose}, settings), compound, pose, settings, {}});
  for (const std::uint32_t part : compound.parts())
    bodies_[number].parts.push_back({part, add_part(number, part)});
  return number;
}

std::uint32_t Twins::add(const Shape& shape, const Pose& pose, const BodySettings& settings) {
  const auto number = static_cast<std::uint32_t>(bodies_.size());
  bodies_.push_back({whole_.add({shape, pose}, settings), {}, pose, settings, {}});
  const HeightField* field = shape.as<HeightField>();
  const BodyId id = parts_.add({field == nullptr ? shape : Shape(field->mesh()), pose}, settings);
  if (id.index >= names_.size()) names_.resize(id.index + 1);
  names_[id.index] = {number, 0};
  bodies_[number].parts.push_back({0, id});
  return number;
}

void Twins::move(std::uint32_t number, const Pose& pose) {
  Body& body = bodies_[number];
  body.pose = pose;
  body.is_way_other = is_compound(number);
  whole_.move(body.id, pose);
  move_parts(number);
}

void Twins::move_parts(std::uint32_t number) {
  const Body& body = bodies_[number];
  for (const auto& [part, id] : body.parts) {
    const Pose own =
        is_compound(number) ? placed_part(body.pose, body.compound.part(part).pose) : body.pose;
    parts_.move(id, own);
  }
}

void Twins::move_alone(std::uint32_t number, const Pose& pose) {
  Body& body = bodies_[number];
  body.pose = pose;
  body.is_ahead = true;
  whole_.move(body.id, pose);
}

void Twins::catch_up() {
  for (std::uint32_t number = 0; number < bodies_.size(); ++number) {
    if (bodies_[number].is_ahead) move_parts(number);
    bodies_[number].is_ahead = false;
  }
  parts_.update();
}

void Twins::move(std::uint32_t number, const RigidMotion& motion) {
  Body& body = bodies_[number];
  body.pose = motion.at(1);
  body.is_way_other = false;
  whole_.move(body.id, motion);
  RigidCourse course{.centre = motion.centre(),
                     .shift = motion.shift(),
                     .axis = motion.axis(),
                     .angle = motion.angle()};
  for (const auto& [part, id] : body.parts) {
    const Pose start = is_compound(number)
                           ? placed_part(motion.start(), body.compound.part(part).pose)
                           : motion.start();
    if (course.angle == 0) course.centre = start.translation();
    parts_.move(id, RigidMotion(start, course));
  }
}

void Twins::set_compound(std::uint32_t number, const Compound& compound) {
  Body& body = bodies_[number];
  whole_.set_shape(body.id, share(compound));
  for (const auto& [part, id] : body.parts)
    parts_.remove(id);
  body.parts.clear();
  body.compound = compound;
  for (const std::uint32_t part : compound.parts())
    bodies_[number].parts.push_back({part, add_part(number, part)});
}

std::vector<NamedContact> Twins::contacts_of_whole(std::span<const BodyContact> contacts) const {
  std::vector<NamedContact> named;
  for (const BodyContact& contact : contacts)
    named.push_back({{contact.pair.a.index, contact.manifold.part_a()},
                     {contact.pair.b.index, contact.manifold.part_b()},
                     contact.manifold});
  for (NamedContact& each : named)
    each.manifold.set_parts(0, 0);
  EXPECT_TRUE(std::is_sorted(named.begin(), named.end(), [](const auto& s, const auto& t) {
    return std::tie(s.a.first, s.b.first, s.a.second, s.b.second) <
           std::tie(t.a.first, t.b.first, t.a.second, t.b.second);
  }));
  return in_order(std::move(named));
}

/// Bodies that came later may have lower indices: then the pair is turned round.
std::vector<NamedContact> Twins::contacts_of_parts(std::span<const BodyContact> contacts) const {
  std::vector<NamedContact> named;
  for (const BodyContact& contact : contacts) {
    NamedContact next{name(contact.pair.a), name(contact.pair.b), contact.manifold};
    if (next.b < next.a) {
      std::swap(next.a, next.b);
      for (std::size_t i = 0; i < next.manifold.size(); ++i) {
        ShapeContact& each = next.manifold[i];
        std::swap(each.point_a, each.point_b);
        std::swap(each.feature.a, each.feature.b);
        each.normal = -each.normal;
      }
    }
    named.push_back(next);
  }
  return in_order(std::move(named));
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> Twins::pairs_of_parts() const {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const BodyPair& pair : parts_.pairs()) {
    const std::uint32_t a = name(pair.a).first, b = name(pair.b).first;
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

bool Twins::is_field(std::uint32_t body) const {
  const Shape* shape = whole_.shape(bodies_[body].id).shape();
  return shape != nullptr && shape->kind() == ShapeKind::HeightField;
}

std::size_t Twins::update() {
  const WorldUpdate of_whole = whole_.update(), of_parts = parts_.update();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const BodyPair& pair : whole_.pairs())
    pairs.push_back({pair.a.index, pair.b.index});
  EXPECT_EQ(pairs, pairs_of_parts());
  expect_same(contacts_of_whole(whole_.contacts()), contacts_of_parts(parts_.contacts()));
  // Of a compound all is asked anew in which something changed: of parts only what moved.
  const std::vector<NamedContact> found = contacts_of_whole(of_whole.contacts);
  for (const NamedContact& contact : contacts_of_parts(of_parts.contacts)) {
    const auto [first, last] = std::equal_range(
        found.begin(), found.end(), contact,
        [](const NamedContact& s, const NamedContact& t) { return is_before(s, t); });
    EXPECT_TRUE(std::find(first, last, contact) != last);
  }

  return found.size() + expect_same_ways(of_whole, of_parts);
}

std::size_t Twins::update_ways() {
  const WorldUpdate of_whole = whole_.update();
  return expect_same_ways(of_whole, parts_.update());
}

// What has gone from pose to pose turns about its own origin: parts of a compound about that of
// all.
std::size_t Twins::expect_same_ways(const WorldUpdate& of_whole, const WorldUpdate& of_parts) {
  std::vector<NamedFirstContact> whole, parts;
  const auto add = [&](std::vector<NamedFirstContact>& list, Named a, Named b,
                       const BodyFirstContact& c) {
    if (bodies_[a.first].is_way_other || bodies_[b.first].is_way_other) return;
    list.push_back({a, b, c.contact, c.is_at_start, c.normal, c.point});
  };
  for (const BodyFirstContact& c : of_whole.first_contacts)
    add(whole, {c.pair.a.index, c.part_a}, {c.pair.b.index, c.part_b}, c);
  for (const BodyFirstContact& c : of_parts.first_contacts)
    add(parts, name(c.pair.a), name(c.pair.b), c);
  EXPECT_EQ(whole.size(), parts.size());
  whole = in_order(std::move(whole)), parts = in_order(std::move(parts));
  for (std::size_t i = 0; i < std::min(whole.size(), parts.size()); ++i) {
    const NamedFirstContact &s = whole[i], &t = parts[i];
    // What slides along a mesh comes next to one of several triangles that it meets at one time.
    const bool is_after_sliding = i > 0 && whole[i - 1].a == s.a && whole[i - 1].b == s.b;
    const bool is_any_triangle = is_after_sliding && (is_field(s.a.first) || is_field(s.b.first));
    const bool is_same =
        is_any_triangle ? s.a == t.a && s.b == t.b && s.contact.low == t.contact.low : s == t;
    EXPECT_TRUE(is_same) << "body " << s.a.first << ", part " << s.a.second << ", and body "
                         << s.b.first << ", part " << s.b.second << ": " << s.contact << " and "
                         << t.contact;
  }
  for (Body& body : bodies_)
    body.is_way_other = false;
  return whole.size();
}

Compound random_compound(RandomSource& source, std::uint32_t parts, double radius) {
  Compound compound;
  for (std::uint32_t i = 0; i < parts; ++i) {
    const int kind = static_cast<int>(source.integer(0, 5));
    compound.add({random_small_shape(source, kind), random_pose(source, radius)});
  }
  return compound;
}

}  // namespace graze::tests
