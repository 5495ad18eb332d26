#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <graze/bvh/error.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/cases/case_meshes.h>

namespace graze {

/// What reading needs to know beside the file.
struct ReadCaseSettings {
  /// Where the meshes lie that a case names by file. Empty: in the folder of the case.
  std::filesystem::path mesh_folder = {};

  /// Where meshes of files are taken from, and kept for the next case. Null: each is read anew.
  CaseMeshes* meshes = nullptr;
};

/// Reads a case, format version 1 (data/README.md, data/case.schema.json). Throws CaseError
/// `file:line: /place: why` for what is no case: unknown and repeated keys, numbers that are not
/// finite, indices out of range, poses that are not rigid, meshes that refer to each other in a
/// circle, files outside of the folder or with another hash, shapes that the library refuses.
/// Linear time and memory, but for hulls, which may have kMaxHullPoints points each.
Case read_case(const std::filesystem::path& path, const ReadCaseSettings& settings = {});

/// Reads a case from memory as read_case() does from a file; errors begin with `name`.
Case parse_case(std::string_view bytes, const std::string& name,
                const ReadCaseSettings& settings = {});

/// How many points a hull of a file may have at most.
inline constexpr std::size_t kMaxHullPoints = 4096;

}  // namespace graze
