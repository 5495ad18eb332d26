#pragma once

#include <graze/engine/record/coding/blocks.h>
#include <graze/engine/record/coding/pose_track.h>
#include <graze/engine/record/read_recording.h>
#include <graze/engine/record/updates/answer_content.h>

#include <istream>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace graze {

/// Holds what a user's own filter said in the update that was read last: it meets all pairs but
/// these.
struct RecordedFilter {
  std::set<std::pair<std::uint32_t, std::uint32_t>> refused;  ///< pairs of indices, the smaller one
                                                              ///< first
};

struct RecordingReader::Data {
  Data(std::unique_ptr<std::istream> from, std::string file)
      : name(std::move(file)), stream(std::move(from)), blocks(*stream, name) {}

  void read_head();
  void read_shape(const record::Block& block);
  void read_step(const record::Block& block);
  void read_end(const record::Block& block);
  std::vector<RecordedChange> read_changes(record::ByteReader& from);
  RecordedChange read_change(int kind, record::ByteReader& from);
  RecordedChange read_added(record::ByteReader& from);
  RecordedChange read_set(int kind, BodyId id, record::ByteReader& from);
  std::shared_ptr<const RecordedState> read_contents(record::ByteReader& from);
  void read_refused(record::ByteReader& from);
  std::uint32_t next_index(record::ByteReader& from);
  /// Returns the id of a body that is there.
  BodyId live(std::uint64_t index, const record::ByteReader& from) const;
  std::uint32_t known_shape(record::ByteReader& from) const;
  std::function<bool(BodyId, BodyId)> filter() const;

  std::string name;
  std::unique_ptr<std::istream> stream;
  record::BlockReader blocks;
  record::Block block;
  RecordingHead head;
  std::shared_ptr<const RecordedState> start;
  RecordedStep step;
  std::size_t steps = 0;
  RecordingEnd end = RecordingEnd::NotReached;
  bool has_failed = false;
  std::vector<std::shared_ptr<const BodyShape>> shapes;
  record::LastIds ids;        ///< the last users of each index
  std::vector<bool> is_live;  ///< whether the body of each index is there
  std::vector<record::PoseTrack> tracks;
  std::int64_t last_body = 0;
  std::shared_ptr<RecordedFilter> said = std::make_shared<RecordedFilter>();
};

}  // namespace graze
