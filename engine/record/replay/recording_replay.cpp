#include <graze/bvh/floating_point/standard_arithmetic.h>
#include <graze/engine/files/source.h>
#include <graze/engine/record/read/recording_data.h>
#include <graze/engine/record/replay_recording.h>

#include <utility>

namespace graze {
namespace {

WorldSettings settings_of(const RecordingHead& head, const RecordingReplaySettings& chosen) {
  WorldSettings settings = head.world;
  settings.threads = chosen.threads;
  if (!chosen.skips)
    settings.skip_apart = settings.skip_at_rest = settings.skip_unused_trees = false;
  return settings;
}

/// Does to a world what was done to another one.
class Repetition {
 public:
  Repetition(World& world, const RecordingReader& reader,
             std::function<bool(BodyId, BodyId)> filter)
      : world_(world), reader_(reader), filter_(std::move(filter)) {}

  void operator()(const BodyAdded& change) const {
    const BodyId id = world_.add({reader_.shape(change.shape), change.pose}, change.settings);
    if (id == change.id) return;
    throw RecordingError("a body that had index " + std::to_string(change.id.index) +
                         " and generation " + std::to_string(change.id.generation) +
                         " gets index " + std::to_string(id.index) + " and generation " +
                         std::to_string(id.generation) + ": pairs cannot be told apart");
  }
  void operator()(const BodyRemoved& change) const { world_.remove(change.id); }
  void operator()(const BodyMoved& change) const { world_.move(change.id, change.pose); }
  void operator()(const BodyTaken& change) const { world_.move(change.id, change.motion); }
  void operator()(const BodyReshaped& change) const {
    world_.set_shape(change.id, reader_.shape(change.shape));
  }
  void operator()(const BodySet& change) const {
    switch (change.what) {
      case BodySet::What::Filter:
        return world_.set_filter(change.id, change.settings.filter);
      case BodySet::What::Kind:
        return world_.set_kind(change.id, change.settings.kind);
      case BodySet::What::Role:
        return world_.set_role(change.id, change.settings.role);
      case BodySet::What::Margin:
        return world_.set_margin(change.id, change.settings.margin);
      case BodySet::What::Detection:
        return world_.set_detection(change.id, change.settings.detection);
      case BodySet::What::UserData:
        return world_.set_user_data(change.id, change.settings.user_data);
    }
  }
  void operator()(const BodySlept& change) const {
    change.is_awake ? world_.wake(change.id) : world_.sleep(change.id);
  }
  void operator()(const PairExcluded& change) const {
    change.is_excluded ? world_.exclude(change.a, change.b) : world_.include(change.a, change.b);
  }
  void operator()(const PairFilterSet& change) const {
    world_.set_pair_filter(change.is_set ? filter_ : nullptr);
  }
  void operator()(const BodyNamed&) const {}
  void operator()(const WorldRestored& change) const { world_.restore(change.state->snapshot); }

 private:
  World& world_;
  const RecordingReader& reader_;
  std::function<bool(BodyId, BodyId)> filter_;
};

}  // namespace

struct RecordingReplay::Data {
  Data(RecordingReader from, const RecordingReplaySettings& chosen)
      : reader(std::move(from)), settings(chosen), world(settings_of(reader.head(), chosen)) {
    world.restore(reader.start().snapshot);
    knows_work = settings.has_work && reader.head().has_work && reader.start().is_fresh;
  }

  RecordingReader reader;
  RecordingReplaySettings settings;
  World world;
  bool knows_work;  ///< true if this world knows of pairs what the recorded one knew
  RecordedStep none;
  const RecordedStep* step = &none;
  WorldUpdate update{};
  std::optional<RecordingDifference> difference;
};

RecordingReplay::RecordingReplay(RecordingReader reader, const RecordingReplaySettings& settings)
    : data_(std::make_unique<Data>(std::move(reader), settings)) {}
RecordingReplay::~RecordingReplay() = default;
RecordingReplay::RecordingReplay(RecordingReplay&& other) noexcept = default;
RecordingReplay& RecordingReplay::operator=(RecordingReplay&& other) noexcept = default;

bool RecordingReplay::advance() {
  return bvh::in_standard_arithmetic([&] {
    Data& data = *data_;
    data.difference.reset();
    const RecordedStep* next = data.reader.next();
    if (next == nullptr) return false;
    data.step = next;
    const Repetition repetition(data.world, data.reader, data.reader.data_->filter());
    for (const RecordedChange& change : next->changes) {
      std::visit(repetition, change);
      if (std::holds_alternative<WorldRestored>(change)) data.knows_work = false;
    }
    if (next->follows_failure) data.knows_work = false;
    const RecordingHead& head = data.reader.head();
    data.update = data.world.update();
    RecordedAnswers now = answers_of(data.update, head.contacts, data.knows_work);
    if (next->follows_failure) {
      RecordedAnswers recorded;
      recorded.begun = next->answers.begun, recorded.ended = next->answers.ended;
      recorded.begun_near = next->answers.begun_near,
      recorded.ended_near = next->answers.ended_near;
      now.moved = now.all_contacts = 0;
      now.contacts.clear(), now.first_contacts.clear();
      data.difference = first_difference(next->number, recorded, now);
    } else {
      data.difference = first_difference(next->number, next->answers, now);
    }
    return true;
  });
}

const RecordedStep& RecordingReplay::step() const {
  return *data_->step;
}

const std::optional<RecordingDifference>& RecordingReplay::difference() const {
  return data_->difference;
}

const WorldUpdate& RecordingReplay::update() const {
  return data_->update;
}

const World& RecordingReplay::world() const {
  return data_->world;
}

const RecordingReader& RecordingReplay::reader() const {
  return data_->reader;
}

}  // namespace graze
