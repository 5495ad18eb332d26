#pragma once

#include <cstddef>

#include <graze/engine/cli/output/output.h>
#include <graze/engine/cli/reports/table.h>
#include <graze/engine/scenes/scene.h>
#include <graze/engine/world/world.h>

namespace graze::cli {

struct SimulateReportSettings {
  bool is_json = false;
  bool has_contacts = false;
};

/// Prints each step of a simulation as it is done: rows for people, or one JSON object a step.
/// Bodies go by their names; their ids' indices are those of the scene, which must outlive this.
class SimulateReport {
 public:
  SimulateReport(Output& output, const Scene& scene, const SimulateReportSettings& settings);

  void begin();
  void add(std::size_t step, double time, const WorldUpdate& update);

 private:
  std::string text_of(std::size_t step, double time, const WorldUpdate& update) const;
  std::string json_of(std::size_t step, double time, const WorldUpdate& update) const;
  std::string text_of(const BodyFirstContact& met, double time) const;
  std::string json_of(const BodyFirstContact& met, double time) const;
  /// Returns when they met, seconds: times of a first contact go from the last step to this one.
  double time_of(const BodyFirstContact& met, double time) const {
    return last_time_ + met.contact.low * (time - last_time_);
  }

  Output& output_;
  const Scene& scene_;
  SimulateReportSettings settings_;
  Table table_;
  bool has_swept_bodies_;
  std::size_t touching_ = 0;
  double last_time_ = 0;  ///< seconds at the step before
};

}  // namespace graze::cli
