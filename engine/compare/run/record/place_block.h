#pragma once

#include <span>
#include <string>
#include <vector>

#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/run/record/answer_record.h>
#include <graze/engine/compare/run/record/journal.h>

namespace graze::compare {

/// So many poses are one line of a record, if nothing makes it shorter.
inline constexpr std::size_t kPlacesOfBlock = 1024;

/// Places that follow each other as one line of JSON, without its sum. Where all engines that
/// answer agree on yes, no, or a number of pairs, a place takes a few bytes; what else there is
/// stands as to_json() of it. README.md has the bytes. Read again they are what they were, bit for
/// bit.
std::string to_json(std::span<const PlaceRecord> block, std::span<const JournalEngine> engines);

/// The same from JSON. `first` is the number of the first place, `end` the one behind the last that
/// there may be. Throws CaseError.
std::vector<PlaceRecord> read_place_block(const cases::JsonCursor& at,
                                          std::span<const JournalEngine> engines, std::size_t first,
                                          std::size_t end);

}  // namespace graze::compare
