// Takes the place of recordings when the samples are built without the component `record`.

#include <graze/bvh/error.h>

#include "samples/simulation/pile_recorder.h"

namespace graze::samples {

struct PileRecorder::Recorder {};

PileRecorder::PileRecorder(World&, const std::filesystem::path& path, double) {
  if (!path.empty()) throw InputError("--record: this build has no component record");
}

PileRecorder::~PileRecorder() = default;

void PileRecorder::name(BodyId, const std::string&) {}

void PileRecorder::finish() {}

}  // namespace graze::samples
