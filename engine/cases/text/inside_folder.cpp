#include <graze/bvh/error.h>
#include <graze/engine/cases/text/inside_folder.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <system_error>

namespace graze::cases {

namespace fs = std::filesystem;

fs::path find_inside(const fs::path& folder, const std::string& path, const char* owner) {
  const std::string quoted = mesh_io::quoted(path);
  const std::string of_owner = std::string("the folder of the ") + owner;
  const fs::path relative(path);
  if (path.empty() || path.find('\0') != path.npos) {
    throw CaseError("the path " + quoted + " names no file");
  }
  if (!relative.is_relative() || relative.has_root_name()) {
    throw CaseError("the path " + quoted + " is absolute; files lie in " + of_owner);
  }
  if (std::find(relative.begin(), relative.end(), "..") != relative.end() ||
      path.find('\\') != path.npos) {
    throw CaseError("the path " + quoted + " leads out of " + of_owner);
  }
  std::error_code error;
  const fs::path root = fs::canonical(folder.empty() ? "." : folder, error);
  if (error) throw CaseError(folder.string() + ": " + error.message());
  fs::path real = fs::weakly_canonical(root / relative, error);
  if (error) throw CaseError(quoted + ": " + error.message());
  const auto [end_of_root, ignored] =
      std::mismatch(root.begin(), root.end(), real.begin(), real.end());
  if (end_of_root != root.end()) {
    throw CaseError("the path " + quoted + " is a link out of " + of_owner);
  }
  return real;
}

}  // namespace graze::cases
