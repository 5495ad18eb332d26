#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/record/shapes/settings_content.h>
#include <graze/engine/record/updates/answer_content.h>
#include <graze/engine/record/updates/state_content.h>
#include <graze/engine/record/write/journal.h>
#include <graze/engine/version.h>

#include <algorithm>

namespace graze {

using record::BlockKind;
using record::ByteWriter;
using record::ChangeKind;

namespace {

void write_world_settings(const WorldSettings& settings, ByteWriter& to) {
  to.number(static_cast<std::uint64_t>(settings.threads));
  to.byte(static_cast<std::uint8_t>((settings.contacts ? 1U : 0U) | (settings.islands ? 2U : 0U) |
                                    (settings.skip_apart ? 4U : 0U) |
                                    (settings.skip_at_rest ? 8U : 0U) |
                                    (settings.skip_unused_trees ? 16U : 0U)));
  to.number(settings.number);
  to.real(settings.sweeps.clearance), to.real(settings.sweeps.tolerance);
  to.number(settings.sweeps.budget);
  to.real(settings.sliding_depth);
}

void write_vector(const Eigen::Vector3d& v, ByteWriter& to) {
  for (int i = 0; i < 3; ++i)
    to.real(v[i]);
}

ChangeKind kind_of(BodyChange change) {
  switch (change) {
    case BodyChange::Added:
      return ChangeKind::Added;
    case BodyChange::Removed:
      return ChangeKind::Removed;
    case BodyChange::Shape:
      return ChangeKind::Reshaped;
    case BodyChange::Filter:
      return ChangeKind::Filter;
    case BodyChange::Kind:
      return ChangeKind::Kind;
    case BodyChange::Role:
      return ChangeKind::Role;
    case BodyChange::Margin:
      return ChangeKind::Margin;
    case BodyChange::Detection:
      return ChangeKind::Detection;
    case BodyChange::UserData:
      return ChangeKind::UserData;
    case BodyChange::Sleep:
      return ChangeKind::Slept;
    case BodyChange::Wake:
      break;
  }
  return ChangeKind::Woken;
}

}  // namespace

WorldRecorder::Journal::Journal(Sink sink, const WorldRecorderSettings& settings)
    : queue_(std::move(sink), settings.writing),
      settings_(settings),
      shapes_([this](std::string_view content) {
        record::append_block(BlockKind::Shape, record::packed(content), blocks_);
      }) {}

/// Keeps a note. The rest of a recording is not written once something is missing.
template <typename Note>
void WorldRecorder::Journal::keep(const Note& note) noexcept {
  if (!is_open_ || failure_ != nullptr) return;
  try {
    note();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

std::uint32_t WorldRecorder::Journal::number_of(const std::shared_ptr<const BodyShape>& shape) {
  return shapes_.number_of(shape);
}

void WorldRecorder::Journal::write_contents(const WorldContents& contents, ByteWriter& to) {
  record::write_state(
      contents, [this](const auto& shape) { return number_of(shape); }, to);
  ids_.clear();
  for (std::uint32_t index = 0; index < contents.all.bodies.size(); ++index) {
    if (!contents.all.ids.is_live(index)) continue;
    queue_.notes().note_begin(index, contents.all.bodies[index].pose);
    note_id(contents.all.id(index));
  }
}

void WorldRecorder::Journal::note_id(BodyId id) {
  if (id.index >= ids_.size()) ids_.resize(std::size_t{id.index} + 1);
  ids_[id.index] = id;
}

void WorldRecorder::Journal::begin(const WorldContents& contents) {
  ByteWriter head;
  head.text(library_version());
  head.text(settings_.note);
  head.real(settings_.seconds_per_update);
  head.byte(static_cast<std::uint8_t>(settings_.contacts));
  head.byte(settings_.has_work ? 1 : 0);
  write_world_settings(contents.settings, head);
  blocks_ = record::kMagic;
  for (int shift = 0; shift < 32; shift += 8)
    blocks_ += static_cast<char>(record::kFormat >> shift & 0xff);
  record::append_block(BlockKind::Head, head.view(), blocks_);
  const bool begins_empty = !contents.is_updated;  // what came waits for the first update
  ByteWriter state;
  // The blocks of its shapes are written first.
  if (begins_empty) {
    Bodies none;
    none.number_bits = contents.all.number_bits;
    if (none.number_bits != 0) none.ids.set_limit(std::uint32_t{1} << Bodies::kNumberShift);
    write_contents({contents.settings, none, {}, {}}, state);
  } else {
    write_contents(contents, state);
  }
  record::append_block(BlockKind::State, state.view(), blocks_);
  queue_.hand_over(blocks_);
  blocks_.clear();
  if (begins_empty) note_all(contents.all);
}

/// Notes that all bodies came, in the order of their indices.
void WorldRecorder::Journal::note_all(const Bodies& all) {
  for (std::uint32_t index = 0; index < all.bodies.size(); ++index) {
    if (!all.ids.is_live(index)) continue;
    note_added(all, index);
    if (!all.bodies[index].is_awake) note_set(ChangeKind::Slept, all, index);
  }
  for (const std::uint64_t pair : all.excluded) {
    const auto a = static_cast<std::uint32_t>(pair >> 32), b = static_cast<std::uint32_t>(pair);
    if (a < b) note(PairChange::Excluded, a, b);
  }
  if (all.pair_filter) note_pair_filter(true);
}

void WorldRecorder::Journal::begin_change(ChangeKind kind, std::uint32_t body) {
  changes().byte(static_cast<std::uint8_t>(kind));
  changes().difference(std::int64_t{body} - std::int64_t{last_body_});
  last_body_ = body;
}

void WorldRecorder::Journal::note_added(const Bodies& all, std::uint32_t index) {
  const Bodies::Body& body = all.bodies[index];
  const std::uint32_t shape = number_of(body.shape);
  begin_change(ChangeKind::Added, index);
  changes().number(all.id(index).generation);
  changes().number(shape);
  record::write_pose(body.pose, changes());
  record::write_settings(record::settings_of(body), changes());
  queue_.notes().note_begin(index, body.pose);
  note_id(all.id(index));
}

void WorldRecorder::Journal::note_set(ChangeKind kind, const Bodies& all, std::uint32_t index) {
  const Bodies::Body& body = all.bodies[index];
  begin_change(kind, index);
  switch (kind) {
    case ChangeKind::Filter:
      return record::write_filter(body.filter, changes());
    case ChangeKind::Kind:
      return changes().byte(static_cast<std::uint8_t>(body.kind));
    case ChangeKind::Role:
      return changes().byte(static_cast<std::uint8_t>(body.role));
    case ChangeKind::Margin:
      return changes().real(body.margin);
    case ChangeKind::Detection:
      return changes().byte(static_cast<std::uint8_t>(body.detection));
    case ChangeKind::UserData:
      return changes().number(body.user_data);
    case ChangeKind::Removed:
      ids_[index] = {};
      return;
    default:  // for a body put to sleep or woken that says it all
      return;
  }
}

void WorldRecorder::Journal::note(BodyChange change, const Bodies& all,
                                  std::uint32_t body) noexcept {
  keep([&] {
    const ChangeKind kind = kind_of(change);
    if (kind == ChangeKind::Added) return note_added(all, body);
    if (kind != ChangeKind::Reshaped) return note_set(kind, all, body);
    const std::uint32_t shape = number_of(all.bodies[body].shape);
    begin_change(kind, body);
    changes().number(shape);
  });
}

void WorldRecorder::Journal::note(PairChange change, std::uint32_t a, std::uint32_t b) noexcept {
  keep([&] {
    if (change == PairChange::Refused) return refused_.push_back(ordered_pair(a, b));
    begin_change(change == PairChange::Excluded ? ChangeKind::Excluded : ChangeKind::Included, a);
    changes().number(b);
  });
}

void WorldRecorder::Journal::note_moves(std::span<const BodyId> ids,
                                        std::span<const Pose> poses) noexcept {
  keep([&] {
    if (ids.empty()) return;
    queue_.notes().note_moves(ids, poses, last_body_);
    last_body_ = ids.back().index;
  });
}

void WorldRecorder::Journal::note_motion(BodyId id, const RigidMotion& motion) noexcept {
  keep([&] {
    begin_change(ChangeKind::Taken, id.index);
    record::write_pose(motion.start(), changes());
    for (const Eigen::Vector3d* v : {&motion.centre(), &motion.shift(), &motion.axis()})
      write_vector(*v, changes());
    changes().real(motion.angle());
    queue_.notes().note_begin(id.index, motion.at(1));
  });
}

void WorldRecorder::Journal::note_pair_filter(bool is_set) noexcept {
  keep([&] {
    changes().byte(
        static_cast<std::uint8_t>(is_set ? ChangeKind::FilterSet : ChangeKind::FilterGone));
  });
}

void WorldRecorder::Journal::note_restored(const WorldContents& contents) noexcept {
  keep([&] {
    changes().byte(static_cast<std::uint8_t>(ChangeKind::Restored));
    write_contents(contents, changes());
    last_body_ = 0;
  });
}

void WorldRecorder::Journal::name(BodyId id, std::string_view name) {
  if (!is_open_ || failure_ != nullptr) return;
  if (id.index >= ids_.size() || ids_[id.index] != id || id == BodyId{})
    throw StaleIdError("name: there is no body with index " + std::to_string(id.index) +
                       " and generation " + std::to_string(id.generation));
  keep([&] {
    begin_change(ChangeKind::Named, id.index);
    changes().text(name);
  });
}

void WorldRecorder::Journal::note_update(const WorldUpdate& update, bool follows_failure) noexcept {
  keep([&] {
    changes().byte(static_cast<std::uint8_t>(ChangeKind::End));
    changes().byte(follows_failure ? 1 : 0);
    std::sort(refused_.begin(), refused_.end());
    refused_.erase(std::unique(refused_.begin(), refused_.end()), refused_.end());
    changes().number(refused_.size());
    for (const BoxPair& pair : refused_)
      changes().number(pair.a), changes().number(pair.b);
    record::keep_answers(update, settings_.contacts, settings_.has_work, queue_.notes().answers);
    queue_.notes().blocks.swap(blocks_);
    refused_.clear();
    last_body_ = 0;
    queue_.submit();
  });
}

void WorldRecorder::Journal::finish() {
  keep([&] {
    ByteWriter end;
    end.number(queue_.updates());
    blocks_.clear();  // it may hold shapes of changes that no update followed
    record::append_block(BlockKind::End, end.view(), blocks_);
    queue_.hand_over(blocks_);
  });
  close();
  if (failure_ != nullptr) std::rethrow_exception(failure_);
}

void WorldRecorder::Journal::close() noexcept {
  is_open_ = false;
  queue_.close();
}

}  // namespace graze
