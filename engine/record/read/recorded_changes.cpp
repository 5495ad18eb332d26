// Reads what was done to the world between two updates.

#include <graze/engine/record/read/recording_data.h>
#include <graze/engine/record/shapes/settings_content.h>
#include <graze/engine/record/updates/changes.h>
#include <graze/engine/record/updates/state_content.h>

namespace graze {

using record::ByteReader;
using record::ChangeKind;

namespace {

// Indices beyond this are no one's: a world takes hundreds of bytes for each.
constexpr std::uint64_t kMostIndex = 0xfffffffe;

/// Reads a motion. An axis of length 1 stays as it is, so that the motion is the same to the bit.
RigidMotion read_motion(ByteReader& from) {
  const Pose start = record::read_pose(from);
  std::array<Eigen::Vector3d, 3> vectors;
  for (Eigen::Vector3d& v : vectors)
    for (int i = 0; i < 3; ++i)
      v[i] = from.real();
  return {start, {vectors[0], vectors[1], vectors[2], from.real()}};
}

/// Reads one of `count` choices.
std::uint8_t choice(ByteReader& from, std::uint8_t count) {
  const std::uint8_t value = from.byte();
  if (value >= count) from.fail("a setting that is none");
  return value;
}

}  // namespace

BodyId RecordingReader::Data::live(std::uint64_t index, const ByteReader& from) const {
  const BodyId id = record::id_of(index, ids, from);
  if (!is_live[id.index]) from.fail("a body that is gone");
  return id;
}

std::uint32_t RecordingReader::Data::next_index(ByteReader& from) {
  const std::int64_t difference = from.difference();
  if (difference < -last_body || difference > static_cast<std::int64_t>(kMostIndex) - last_body)
    from.fail("a body's index is none");
  last_body += difference;
  return static_cast<std::uint32_t>(last_body);
}

std::uint32_t RecordingReader::Data::known_shape(ByteReader& from) const {
  const std::uint32_t shape = from.number_up_to(0xffffffff, "shape");
  if (shape >= shapes.size()) from.fail("a body of a shape that is none");
  return shape;
}

RecordedChange RecordingReader::Data::read_added(ByteReader& from) {
  const std::uint32_t index = next_index(from);
  if (index > ids.size() || (index < ids.size() && is_live[index]))
    from.fail("a body comes in the place of another");
  BodyAdded added;
  added.id = {index, from.number_up_to(0xffffffff, "generation")};
  added.shape = known_shape(from);
  added.pose = record::read_pose(from);
  added.settings = record::read_settings(from);
  record::check_body(*shapes[added.shape], added.pose, added.settings);
  if (index == ids.size()) ids.emplace_back(), is_live.push_back(false), tracks.emplace_back();
  ids[index] = added.id, is_live[index] = true;
  tracks[index].begin(added.pose);
  return added;
}

RecordedChange RecordingReader::Data::read_set(int kind, BodyId id, ByteReader& from) {
  BodySet set{.id = id};
  switch (static_cast<ChangeKind>(kind)) {
    case ChangeKind::Filter:
      set.settings.filter = record::read_filter(from);
      break;
    case ChangeKind::Kind:
      set.what = BodySet::What::Kind;
      set.settings.kind = static_cast<BodyKind>(choice(from, 3));
      break;
    case ChangeKind::Role:
      set.what = BodySet::What::Role;
      set.settings.role = static_cast<Role>(choice(from, 2));
      break;
    case ChangeKind::Margin:
      set.what = BodySet::What::Margin;
      set.settings.margin = from.real();
      break;
    case ChangeKind::Detection:
      set.what = BodySet::What::Detection;
      set.settings.detection = static_cast<Detection>(choice(from, 2));
      break;
    default:
      set.what = BodySet::What::UserData;
      set.settings.user_data = from.number();
  }
  return set;
}

RecordedChange RecordingReader::Data::read_change(int kind, ByteReader& from) {
  const auto which = static_cast<ChangeKind>(kind);
  if (which == ChangeKind::Added) return read_added(from);
  if (which == ChangeKind::FilterSet) return PairFilterSet{true};
  if (which == ChangeKind::FilterGone) return PairFilterSet{false};
  if (which == ChangeKind::Restored) {
    last_body = 0;
    return WorldRestored{read_contents(from)};
  }
  if (which == ChangeKind::Moved) ++last_body;
  const BodyId id = live(
      which == ChangeKind::Moved ? static_cast<std::uint64_t>(last_body) : next_index(from), from);
  switch (which) {
    case ChangeKind::Moved:
    case ChangeKind::MovedElse:
      return BodyMoved{id, tracks[id.index].read(from)};
    case ChangeKind::Taken: {
      BodyTaken taken{id, read_motion(from)};
      tracks[id.index].begin(taken.motion.at(1));
      return taken;
    }
    case ChangeKind::Removed:
      is_live[id.index] = false;
      return BodyRemoved{id};
    case ChangeKind::Reshaped:
      return BodyReshaped{id, known_shape(from)};
    case ChangeKind::Slept:
    case ChangeKind::Woken:
      return BodySlept{id, which == ChangeKind::Woken};
    case ChangeKind::Excluded:
    case ChangeKind::Included:
      return PairExcluded{id, live(from.number(), from), which == ChangeKind::Excluded};
    case ChangeKind::Named:
      return BodyNamed{id, std::string(from.text())};
    default:
      return read_set(kind, id, from);
  }
}

std::vector<RecordedChange> RecordingReader::Data::read_changes(ByteReader& from) {
  std::vector<RecordedChange> changes;
  last_body = 0;
  while (true) {
    const int kind = from.byte();
    if (kind == static_cast<int>(ChangeKind::End)) return changes;
    if (kind > static_cast<int>(ChangeKind::Restored)) from.fail("a change of an unknown kind");
    changes.push_back(read_change(kind, from));
  }
}

void RecordingReader::Data::read_refused(ByteReader& from) {
  said->refused.clear();
  for (std::size_t left = from.count(2, "pairs"); left > 0; --left) {
    const BodyId a = record::id_of(from.number(), ids, from);
    const BodyId b = record::id_of(from.number(), ids, from);
    if (!said->refused.emplace(a.index, b.index).second) from.fail("a pair stands twice");
    step.refused.push_back({a, b});
  }
}

std::function<bool(BodyId, BodyId)> RecordingReader::Data::filter() const {
  return [said = said](BodyId a, BodyId b) {
    return !said->refused.contains(std::minmax(a.index, b.index));
  };
}

std::shared_ptr<const RecordedState> RecordingReader::Data::read_contents(ByteReader& from) {
  auto state = std::make_shared<const RecordedState>(record::read_state(from, shapes, filter()));
  const Bodies& all = WorldSnapshotAccess::state(state->snapshot).all;
  std::size_t known = 0;
  IdTableAccess::visit(all.ids, [&](const auto& list, const auto&...) { known = list.size(); });
  ids.assign(known, BodyId{});
  is_live.assign(known, false);
  tracks.assign(known, record::PoseTrack{});
  for (std::uint32_t index = 0; index < known; ++index) {
    is_live[index] = all.ids.is_live(index);
    ids[index] = all.id(index);
    if (is_live[index]) tracks[index].begin(all.bodies[index].pose);
  }
  return state;
}

}  // namespace graze
