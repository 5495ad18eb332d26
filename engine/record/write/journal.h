#pragma once

#include <graze/engine/record/updates/changes.h>
#include <graze/engine/record/world_recorder.h>
#include <graze/engine/record/write/shape_table.h>
#include <graze/engine/record/write/step_queue.h>
#include <graze/engine/world/bodies/world_state.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace graze {

/// Takes note of what a world is told, and has a block written at the end of each update.
class WorldRecorder::Journal final : public WorldJournal {
 public:
  using Sink = std::function<void(std::string_view)>;

  Journal(Sink sink, const WorldRecorderSettings& settings);

  /// Writes the head and what the world is. Throws what goes wrong.
  void begin(const WorldContents& contents);
  void name(BodyId id, std::string_view name);
  /// Throws what went wrong, once.
  void finish();
  /// Takes no further notes.
  void close() noexcept;

  std::size_t updates() const { return queue_.updates(); }
  std::uint64_t bytes() const { return queue_.bytes(); }
  bool has_failed() const noexcept { return failure_ != nullptr || queue_.has_failed(); }

  bool is_open() const noexcept override { return is_open_; }
  void note(BodyChange change, const Bodies& all, std::uint32_t body) noexcept override;
  void note(PairChange change, std::uint32_t a, std::uint32_t b) noexcept override;
  void note_moves(std::span<const BodyId> ids, std::span<const Pose> poses) noexcept override;
  void note_motion(BodyId id, const RigidMotion& motion) noexcept override;
  void note_pair_filter(bool is_set) noexcept override;
  void note_update(const WorldUpdate& update, bool follows_failure) noexcept override;
  void note_restored(const WorldContents& contents) noexcept override;

 private:
  template <typename Note>
  void keep(const Note& note) noexcept;
  void begin_change(record::ChangeKind kind, std::uint32_t body);
  void note_added(const Bodies& all, std::uint32_t body);
  void note_set(record::ChangeKind kind, const Bodies& all, std::uint32_t body);
  void note_all(const Bodies& all);
  void write_contents(const WorldContents& contents, record::ByteWriter& to);
  std::uint32_t number_of(const std::shared_ptr<const BodyShape>& shape);
  /// Returns the changes since the last update.
  record::ByteWriter& changes() { return queue_.notes().changes; }
  void note_id(BodyId id);

  record::StepQueue queue_;
  WorldRecorderSettings settings_;
  record::ShapeTable shapes_;
  std::vector<BodyId> ids_;       ///< the ids of bodies that are there, by index
  std::vector<BoxPair> refused_;  ///< pairs that were refused since the last update
  std::string blocks_;            ///< blocks that wait for the end of the update
  std::uint32_t last_body_ = 0;   ///< the body that the last change was about
  bool is_open_ = true;
  std::exception_ptr failure_;
};

}  // namespace graze
