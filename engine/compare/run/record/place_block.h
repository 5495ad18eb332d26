#pragma once

#include <span>
#include <string>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/compare/run/record/journal.h>

namespace graze::compare {

/// A line of a record has so many poses, if nothing makes it shorter.
inline constexpr std::size_t kPlacesOfBlock = 1024;

/// Returns places that follow each other as one line of JSON, without its sum. Where all engines
/// that answer agree on yes, no, or a number of pairs, a place takes a few bytes; any other stands
/// there as its to_json(). README.md has the bytes. Read again they are what they were, bit for
/// bit.
std::string to_json(std::span<const PlaceRecord> block, std::span<const JournalEngine> engines);

/// Reads the same from JSON. `first` is the number of the first place, `end` the one behind the
/// last that there may be. Throws CaseError.
std::vector<PlaceRecord> read_place_block(const cases::JsonCursor& at,
                                          std::span<const JournalEngine> engines, std::size_t first,
                                          std::size_t end);

}  // namespace graze::compare
