#include <graze/bvh/value/checks.h>
#include <graze/engine/record/coding/pose_track.h>
#include <graze/engine/record/shapes/settings_content.h>
#include <graze/engine/record/updates/state_content.h>
#include <graze/engine/world/contacts/sides/enclosure.h>

#include <algorithm>
#include <cmath>

namespace graze::record {
namespace {

constexpr std::uint64_t kMostIndex = 0xfffffffe;

void write_list(const std::vector<std::uint32_t>& list, ByteWriter& to) {
  to.number(list.size());
  for (const std::uint32_t number : list)
    to.number(number);
}

std::vector<std::uint32_t> read_list(ByteReader& from, const char* what) {
  std::vector<std::uint32_t> list(from.count(1, what));
  for (std::uint32_t& number : list)
    number = from.number_up_to(0xffffffff, what);
  return list;
}

void write_ids(const IdTable<std::uint32_t>& ids, ByteWriter& to) {
  IdTableAccess::visit(ids, [&](const auto& generations, const auto& free, const auto& resting,
                                const auto& older, std::size_t, std::uint32_t limit) {
    for (const auto* list : {&generations, &free, &resting, &older})
      write_list(*list, to);
    to.number(limit);
  });
}

void read_ids(ByteReader& from, IdTable<std::uint32_t>& ids) {
  IdTableAccess::visit(ids, [&](auto& generations, auto& free, auto& resting, auto& older,
                                std::size_t& live, std::uint32_t& limit) {
    generations = read_list(from, "generations");
    live = static_cast<std::size_t>(std::count_if(generations.begin(), generations.end(),
                                                  [](std::uint32_t g) { return (g & 1) != 0; }));
    std::vector<bool> is_listed(generations.size(), false);
    for (auto* list : {&free, &resting, &older}) {
      *list = read_list(from, "indices");
      for (const std::uint32_t index : *list) {
        if (index >= generations.size() || (generations[index] & 1) != 0 || is_listed[index])
          from.fail("an index that is free and in use, or twice free");
        is_listed[index] = true;
      }
    }
    limit = from.number_up_to(0xffffffff, "limit of generations");
  });
}

void write_body(const Bodies::Body& body, const Bodies::Changes& record, std::uint32_t shape,
                ByteWriter& to) {
  to.number(shape);
  write_pose(body.pose, to);
  write_settings(settings_of(body), to);
  to.byte(body.is_awake ? 1 : 0);
  to.real(record.path);
}

/// Fills in a body that is there.
RecordedBody read_body(ByteReader& from, std::span<const std::shared_ptr<const BodyShape>> shapes,
                       Bodies::Body& body, Bodies::Changes& record) {
  RecordedBody read;
  read.shape = from.number_up_to(0xffffffff, "shape");
  if (read.shape >= shapes.size()) from.fail("a body of a shape that is none");
  read.pose = read_pose(from);
  read.settings = read_settings(from);
  read.is_awake = from.flags(1, "sleep") != 0;
  record.path = from.real();
  if (!(record.path >= 0)) from.fail("a body's path is none");
  const std::shared_ptr<const BodyShape>& shape = shapes[read.shape];
  check_body(*shape, read.pose, read.settings);
  const Shape* known = shape->shape();
  body.shape = shape;
  body.mesh = known == nullptr ? nullptr : known->as<Mesh>();
  body.has_parts = known == nullptr;
  body.pose = read.pose;
  body.filter = read.settings.filter;
  body.user_data = read.settings.user_data;
  body.margin = read.settings.margin;
  body.sides = read.settings.sides;
  body.kind = read.settings.kind;
  body.role = read.settings.role;
  body.detection = read.settings.detection;
  body.is_awake = read.is_awake;
  record.is_mesh = body.mesh != nullptr;
  return read;
}

/// Writes each pair once, the smaller index first, ascending.
void write_exclusions(const std::set<std::uint64_t>& excluded, ByteWriter& to) {
  to.number(excluded.size() / 2);
  for (const std::uint64_t pair : excluded) {
    const auto a = static_cast<std::uint32_t>(pair >> 32), b = static_cast<std::uint32_t>(pair);
    if (a < b) to.number(a), to.number(b);
  }
}

BoxPair read_index_pair(ByteReader& from, const Bodies& all) {
  const std::uint32_t a = from.number_up_to(kMostIndex, "body");
  const std::uint32_t b = from.number_up_to(kMostIndex, "body");
  if (a >= b || !all.ids.is_live(a) || !all.ids.is_live(b)) from.fail("a pair of bodies is none");
  return {a, b};
}

void read_exclusions(ByteReader& from, Bodies& all) {
  for (std::size_t left = from.count(2, "exclusions"); left > 0; --left) {
    const BoxPair pair = read_index_pair(from, all);
    if (!all.excluded.insert(std::uint64_t{pair.a} << 32 | pair.b).second)
      from.fail("an exclusion stands twice");
    all.excluded.insert(std::uint64_t{pair.b} << 32 | pair.a);
    ++all.bodies[pair.a].exclusions, ++all.bodies[pair.b].exclusions;
  }
}

void read_candidates(ByteReader& from, WorldSnapshotAccess::State& state, RecordedState& read) {
  const auto touches = static_cast<std::uint8_t>(PairState::Touching);
  std::set<std::uint64_t> known;
  for (std::size_t left = from.count(3, "pairs"); left > 0; --left) {
    const BoxPair pair = read_index_pair(from, state.all);
    if (!known.insert(std::uint64_t{pair.a} << 32 | pair.b).second)
      from.fail("a pair stands twice");
    state.candidates.push_back(pair);
    state.states.push_back(from.flags(static_cast<std::uint8_t>(PairState::Either), "a pair"));
    if ((state.states.back() & touches) != 0) read.touching.push_back(state.all.id_pair(pair));
  }
  std::sort(read.touching.begin(), read.touching.end());
}

}  // namespace

BodySettings settings_of(const Bodies::Body& body) {
  return {.kind = body.kind,
          .filter = body.filter,
          .user_data = body.user_data,
          .role = body.role,
          .margin = body.margin,
          .sides = body.sides,
          .detection = body.detection};
}

void write_state(const WorldContents& contents, const NumberOfBodyShape& number_of,
                 ByteWriter& to) {
  const Bodies& all = contents.all;
  write_ids(all.ids, to);
  to.number(all.number_bits);
  to.number(all.bodies.size());
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    if (!all.ids.is_live(index)) continue;
    const Bodies::Body& body = all.bodies[index];
    write_body(body, all.changes[index], number_of(body.shape), to);
  }
  write_exclusions(all.excluded, to);
  to.byte(all.pair_filter ? 1 : 0);
  to.number(contents.candidates.size());
  for (std::size_t i = 0; i < contents.candidates.size(); ++i) {
    to.number(contents.candidates[i].a), to.number(contents.candidates[i].b);
    to.byte(contents.states[i]);
  }
}

RecordedState read_state(ByteReader& from, std::span<const std::shared_ptr<const BodyShape>> shapes,
                         const std::function<bool(BodyId, BodyId)>& filter) {
  auto state = std::make_shared<WorldSnapshotAccess::State>();
  RecordedState read{.snapshot = WorldSnapshotAccess::make(state)};
  Bodies& all = state->all;
  read_ids(from, all.ids);
  all.number_bits = from.number_up_to(0xffffffff, "number of the world");
  std::size_t generations = 0;
  IdTableAccess::visit(all.ids,
                       [&](const auto& list, const auto&...) { generations = list.size(); });
  const std::uint64_t bodies = from.number();
  // Bodies are made before their indices are taken, so that one that failed may have left room for
  // one.
  if (bodies < generations || bodies > generations + 1) from.fail("more bodies than ids");
  all.bodies.resize(static_cast<std::size_t>(bodies));
  all.changes.resize(all.bodies.size());
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    if (!all.ids.is_live(index)) continue;
    read.bodies.push_back(read_body(from, shapes, all.bodies[index], all.changes[index]));
    read.bodies.back().id = all.id(index);
  }
  read_exclusions(from, all);
  if (from.flags(1, "filter") != 0) all.pair_filter = filter;
  read_candidates(from, *state, read);
  read.is_fresh = state->candidates.empty();
  return read;
}

void check_body(const BodyShape& shape, const Pose& pose, const BodySettings& settings) {
  bvh::check_rigid(pose, "a body");
  check_margin(settings.margin, "a body");
  check_sides(shape.shape(), settings.sides, "a body");
  bounds_of(shape, false, pose, settings.margin + settings.sides.thickness(), "a body");
}

}  // namespace graze::record
