#include "tests/engine/compounds/twins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>

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
  whole_.move(body.id, pose);
  for (const auto& [part, id] : body.parts) {
    const Pose own = is_compound(number) ? placed_part(pose, body.compound.part(part).pose) : pose;
    parts_.move(id, own);
  }
}

void Twins::move(std::uint32_t number, const RigidMotion& motion) {
  Body& body = bodies_[number];
  body.pose = motion.at(1);
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

std::size_t Twins::update() {
  const WorldUpdate of_whole = whole_.update(), of_parts = parts_.update();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const BodyPair& pair : whole_.pairs())
    pairs.push_back({pair.a.index, pair.b.index});
  EXPECT_EQ(pairs, pairs_of_parts());
  EXPECT_TRUE(contacts_of_whole(whole_.contacts()) == contacts_of_parts(parts_.contacts()));
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

std::size_t Twins::expect_same_ways(const WorldUpdate& of_whole,
                                    const WorldUpdate& of_parts) const {
  std::vector<NamedFirstContact> whole, parts;
  for (const BodyFirstContact& c : of_whole.first_contacts)
    whole.push_back({{c.pair.a.index, c.part_a},
                     {c.pair.b.index, c.part_b},
                     c.contact,
                     c.touches_at_start,
                     c.normal,
                     c.point});
  for (const BodyFirstContact& c : of_parts.first_contacts)
    parts.push_back(
        {name(c.pair.a), name(c.pair.b), c.contact, c.touches_at_start, c.normal, c.point});
  EXPECT_TRUE(in_order(whole) == in_order(parts)) << whole.size() << " and " << parts.size();
  return whole.size();
}

std::size_t Twins::ask(const Shape& shape, const Pose& pose, double clearance) {
  std::vector<std::uint32_t> touching, wanted;
  for (const BodyId id : whole_.find_touching({shape, pose}))
    touching.push_back(id.index);
  for (const BodyId id : parts_.find_touching({shape, pose}))
    wanted.push_back(name(id).first);
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  EXPECT_EQ(touching, wanted);

  std::map<std::uint32_t, std::pair<ShapeDistance, std::uint32_t>> nearest;
  for (const BodyDistance& found : parts_.find_within({shape, pose}, clearance)) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = nearest.try_emplace(body, found.distance, part);
    const auto& [distance, number] = at->second;
    if (is_new || found.distance.distance > distance.distance) continue;
    if (found.distance.distance < distance.distance || part < number)
      at->second = {found.distance, part};
  }
  const std::vector<BodyDistance> within = whole_.find_within({shape, pose}, clearance);
  EXPECT_EQ(within.size(), nearest.size());
  for (const BodyDistance& found : within) {
    EXPECT_TRUE(nearest.contains(found.id.index) &&
                (nearest.at(found.id.index) == std::pair{found.distance, found.part}))
        << found.id.index << " " << found.part;
  }
  const auto closest = whole_.find_closest({shape, pose});
  const auto closest_part = parts_.find_closest({shape, pose});
  EXPECT_EQ(closest.has_value(), closest_part.has_value());
  if (closest && closest_part) {
    EXPECT_EQ(closest->distance.distance, closest_part->distance.distance);
  }
  return touching.size() + within.size();
}

std::size_t Twins::cast_ray(const Ray& ray) {
  std::map<std::uint32_t, std::pair<RayHit, std::uint32_t>> first;
  for (const BodyRayHit& found : parts_.cast_ray_all(ray)) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = first.try_emplace(body, found.hit, part);
    if (!is_new && found.hit.distance == at->second.first.distance && part < at->second.second)
      at->second = {found.hit, part};
  }
  const std::vector<BodyRayHit> hits = whole_.cast_ray_all(ray);
  EXPECT_EQ(hits.size(), first.size());
  for (const BodyRayHit& found : hits) {
    EXPECT_TRUE(first.contains(found.id.index) &&
                (first.at(found.id.index) == std::pair{found.hit, found.part}));
  }
  const std::optional<BodyRayHit> hit = whole_.cast_ray(ray);
  EXPECT_EQ(hit.has_value(), !hits.empty());
  if (hit && !hits.empty()) {
    EXPECT_EQ(*hit, hits[0]);
  }
  return hits.size();
}

std::size_t Twins::cast(const Shape& shape, const RigidMotion& motion, double most_off) {
  std::map<std::uint32_t, std::pair<RigidContact, std::uint32_t>> first;
  for (const BodyCast& found : parts_.cast_all(shape, motion)) {
    const auto [body, part] = name(found.id);
    const auto [at, is_new] = first.try_emplace(body, found.contact, part);
    if (!is_new && found.contact.low == at->second.first.low && part < at->second.second)
      at->second = {found.contact, part};
  }
  const std::vector<BodyCast> casts = whole_.cast_all(shape, motion);
  EXPECT_EQ(casts.size(), first.size());
  for (const BodyCast& found : casts) {
    const auto wanted = first.find(found.id.index);
    const bool is_known = wanted != first.end();
    EXPECT_TRUE(is_known);
    if (!is_known) continue;
    const RigidContact& contact = wanted->second.first;
    if (most_off == 0) {
      EXPECT_TRUE(wanted->second == std::pair(found.contact, found.part));
    } else {
      EXPECT_NEAR(found.contact.low, contact.low, most_off);
      EXPECT_EQ(found.contact.status, contact.status);
    }
  }
  return casts.size();
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
