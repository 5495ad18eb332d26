// Records when the samples are built with the component `record`.

#include <graze/engine/record/world_recorder.h>

#include "samples/simulation/pile_recorder.h"

namespace graze::samples {

struct PileRecorder::Recorder {
  WorldRecorder of;
};

PileRecorder::PileRecorder(World& world, const std::filesystem::path& path,
                           double seconds_per_update) {
  if (path.empty()) return;
  recorder_ = std::make_unique<Recorder>(
      Recorder{WorldRecorder(world, path, {.seconds_per_update = seconds_per_update})});
}

PileRecorder::~PileRecorder() = default;

void PileRecorder::name(BodyId id, const std::string& name) {
  if (recorder_) recorder_->of.name(id, name);
}

void PileRecorder::finish() {
  if (recorder_) recorder_->of.finish();
}

}  // namespace graze::samples
