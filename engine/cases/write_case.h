#pragma once

#include <filesystem>
#include <string>

#include <graze/engine/cases/case.h>

namespace graze {

/// Returns the case as read_case() reads it, ending in a line break: the same text for the same
/// case on every machine. Every number is a hex float. Takes linear time.
std::string to_json(const Case& query);

/// Writes the case to a file, which appears whole or stays as it was (see write_voxels()). Throws
/// CaseError if that cannot be done.
void write_case(const std::filesystem::path& path, const Case& query);

/// Returns the parts of an answer as one JSON object.
std::string to_json(const CaseAnswer& answer);

/// Returns the answer with plain JSON numbers, which lose nothing either, for tools that know no
/// hex floats.
std::string to_plain_json(const CaseAnswer& answer);

}  // namespace graze
