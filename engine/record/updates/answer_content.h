#pragma once

#include <graze/engine/record/coding/byte_reader.h>
#include <graze/engine/record/coding/byte_writer.h>
#include <graze/engine/record/recording.h>

#include <span>
#include <vector>

namespace graze::record {

/// Of the users of each index the last one: what names of bodies by index alone mean.
using LastIds = std::vector<BodyId>;

/// The id that the index has or had last. Throws RecordingError for one that nobody had.
BodyId id_of(std::uint64_t index, const LastIds& ids, const ByteReader& from);

void write_pairs(std::span<const BodyPair> ascending, ByteWriter& to);
std::vector<BodyPair> read_pairs(ByteReader& from, const LastIds& ids);

/// As answers_of(), in memory that is there.
void keep_answers(const WorldUpdate& update, RecordedContacts contacts, bool has_work,
                  RecordedAnswers& to);

/// Work, too, if it is kept.
void write_answers(const RecordedAnswers& answers, ByteWriter& to);
RecordedAnswers read_answers(ByteReader& from, const LastIds& ids, bool has_work);

}  // namespace graze::record
