#pragma once

#include <filesystem>
#include <string>

#include <graze/engine/cases/case.h>

namespace graze {

/// Loads the mesh that a case refers to by file. The file must lie in `folder`, at whatever depth:
/// a path that is absolute or goes upwards is refused, and so is a link that leads out of it.
/// Throws CaseError without a place, or MeshError.
Mesh load_case_mesh(const CaseMeshFile& file, const std::filesystem::path& folder);

/// Loads a mesh of a file, so that a case about it is written with the file's name and hash: `path`
/// is relative to `folder`. Throws as load_case_mesh() does.
CaseMesh case_mesh_of_file(const std::filesystem::path& folder, const std::string& path,
                           const Pose& pose);

}  // namespace graze
