#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/record/updates/answer_content.h>
#include <graze/engine/record/updates/changes.h>
#include <graze/engine/record/write/step_writer.h>

namespace graze::record {

void StepWriter::hand_over(std::string_view blocks) {
  sink_(blocks);
  bytes_ += blocks.size();
}

void StepWriter::write(const StepNotes& notes) {
  step_.clear();
  const std::string_view changes = notes.changes.view();
  std::size_t done = 0, first = 0;
  for (const StepNotes::Run& run : notes.runs()) {
    step_.raw(changes.substr(done, run.at - done));
    done = run.at;
    const auto bodies = notes.bodies().subspan(first, run.count);
    const auto poses = notes.poses().subspan(first, run.count);
    first += run.count;
    if (run.is_begin)
      track_of(bodies.front()).begin(poses.front());
    else
      write_moves(bodies, poses, run.before);
  }
  step_.raw(changes.substr(done));
  write_answers(notes.answers, step_);
  blocks_ = notes.blocks;
  append_block(BlockKind::Step, step_.view(), blocks_);
  hand_over(blocks_);
  ++updates_;
}

void StepWriter::write_moves(std::span<const std::uint32_t> bodies, std::span<const Pose> poses,
                             std::uint32_t before) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i] == before + 1) {
      step_.byte(static_cast<std::uint8_t>(ChangeKind::Moved));
    } else {
      step_.byte(static_cast<std::uint8_t>(ChangeKind::MovedElse));
      step_.difference(std::int64_t{bodies[i]} - std::int64_t{before});
    }
    before = bodies[i];
    track_of(bodies[i]).write(poses[i], step_);
  }
}

PoseTrack& StepWriter::track_of(std::uint32_t body) {
  if (body >= tracks_.size()) tracks_.resize(std::size_t{body} + 1);
  return tracks_[body];
}

}  // namespace graze::record
