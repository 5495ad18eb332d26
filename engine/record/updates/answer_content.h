#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/record/recording.h>

#include <cstdint>
#include <span>
#include <vector>

namespace graze::record {

/// Holds the last user of each index, which names of bodies by index alone mean.
using LastIds = std::vector<BodyId>;

/// Returns the id that the index has or had last. Throws RecordingError for an index that nobody
/// had.
BodyId id_of(std::uint64_t index, const LastIds& ids, const ByteReader& from);

void write_pairs(std::span<const BodyPair> ascending, ByteWriter& to);
std::vector<BodyPair> read_pairs(ByteReader& from, const LastIds& ids);

/// Holds a manifold of an update, without its contacts.
struct KeptManifold {
  BodyPair pair;
  std::uint32_t part_a;
  std::uint32_t part_b;
  std::uint32_t contacts;  ///< the number of its contacts
};

/// Holds what an update said, as it waits to be written: contacts one behind the other, for a
/// manifold has room for four and mostly one or two.
struct KeptAnswers {
  RecordedAnswers others = {};  ///< all answers but contacts
  std::vector<KeptManifold> manifolds = {};
  std::vector<ShapeContact> contacts = {};  ///< the contacts of all manifolds, in order
};

/// Keeps what answers_of() keeps, in memory that is there.
void keep_answers(const WorldUpdate& update, RecordedContacts contacts, bool has_work,
                  KeptAnswers& to);

/// Write and read answers, with work if it is kept.
void write_answers(const KeptAnswers& answers, ByteWriter& to);
RecordedAnswers read_answers(ByteReader& from, const LastIds& ids, bool has_work);

}  // namespace graze::record
