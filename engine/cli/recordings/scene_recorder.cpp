#include <graze/engine/cli/recordings/scene_recorder.h>

#include <cstdint>
#include <vector>

namespace graze::cli {

SceneRecorder::SceneRecorder(const std::optional<std::string>& file, const Scene& scene,
                             Simulation& simulation, RecordedContacts contacts) {
  if (!file) return;
  recorder_.emplace(
      simulation.world(), *file,
      WorldRecorderSettings{.contacts = contacts,
                            .seconds_per_update = simulation.time_of(1),
                            .note = scene.note,
                            .writing = RecordedWriting::AtOnce});  // so that whoever stops it has
                                                                   // all steps
  const std::vector<BodyId> ids = simulation.world().bodies();  // the ids in the order of the scene
  for (std::size_t i = 0; i < ids.size(); ++i)
    recorder_->name(ids[i], scene.bodies[i].name);
}

void SceneRecorder::check() {
  if (recorder_ && recorder_->has_failed()) recorder_->finish();
}

void SceneRecorder::finish() {
  if (recorder_) recorder_->finish();
}

}  // namespace graze::cli
