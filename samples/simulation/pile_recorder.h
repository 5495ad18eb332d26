#pragma once

#include <graze/engine/world/world.h>

#include <filesystem>
#include <memory>
#include <string>

namespace graze::samples {

/// Records a world, if the samples are built with the component `record`.
class PileRecorder {
 public:
  /// Records nothing for an empty path. Throws as WorldRecorder does, and an InputError where there
  /// is no such component.
  PileRecorder(World& world, const std::filesystem::path& path, double seconds_per_update);
  ~PileRecorder();
  PileRecorder(const PileRecorder&) = delete;
  PileRecorder& operator=(const PileRecorder&) = delete;

  void name(BodyId id, const std::string& name);
  /// Throws what went wrong on the way.
  void finish();

 private:
  struct Recorder;
  std::unique_ptr<Recorder> recorder_;
};

}  // namespace graze::samples
