#include <graze/engine/cli/recordings/recording_file.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace graze::cli {

bool is_recording(const std::string& file) {
  constexpr std::string_view kBegin = "GRAZEREC";
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return false;
  std::ifstream bytes(file, std::ios::binary);
  std::array<char, kBegin.size()> begin{};
  bytes.read(begin.data(), begin.size());
  return bytes && std::string_view(begin.data(), begin.size()) == kBegin;
}

void RecordedNames::note(const std::vector<RecordedChange>& changes) {
  for (const RecordedChange& change : changes)
    if (const auto* named = std::get_if<BodyNamed>(&change)) names_[named->id] = named->name;
}

std::string RecordedNames::of(BodyId id) const {
  const auto known = names_.find(id);
  return known != names_.end() ? known->second : "body " + std::to_string(id.index);
}

}  // namespace graze::cli
