#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include <graze/bvh/error.h>
#include <graze/engine/cases/case.h>
#include <graze/engine/cases/case_meshes.h>

namespace graze {

/// Holds what reading needs to know beside the file.
struct ReadCaseSettings {
  /// The folder of the meshes that a case names by file; if it is empty, that is the folder of the
  /// case.
  std::filesystem::path mesh_folder = {};

  /// The meshes of files that were read before, kept for the next case. If it is null each is read
  /// anew.
  CaseMeshes* meshes = nullptr;
};

/// Reads a case, format version 1 (data/README.md, data/case.schema.json). Throws CaseError
/// `file:line: /place: why` for what is no case: unknown and repeated keys, numbers that are not
/// finite, indices out of range, poses that are not rigid, meshes that refer to each other in a
/// circle, files outside of the folder or with another hash, shapes that the library refuses. Takes
/// linear time and memory, but for hulls, which may have kMaxHullPoints points each.
Case read_case(const std::filesystem::path& path, const ReadCaseSettings& settings = {});

/// Reads a case from memory as read_case() does from a file; errors begin with `name`.
Case parse_case(std::string_view bytes, const std::string& name,
                const ReadCaseSettings& settings = {});

/// The most points that a hull of a file may have.
inline constexpr std::size_t kMaxHullPoints = 4096;

}  // namespace graze
