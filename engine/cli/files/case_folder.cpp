#include <graze/bvh/error.h>
#include <graze/engine/cases/write_case.h>
#include <graze/engine/cli/files/case_folder.h>
#include <graze/engine/files/sha256.h>
#include <graze/engine/files/source.h>

#include <algorithm>
#include <system_error>

namespace graze::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCharacters = 40;  // the longest part; a name has at most 255
constexpr std::size_t kDigestCharacters = 12;

bool may_stand_in_a_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '+' || c == '.';
}

}  // namespace

std::string name_part(std::string_view text) {
  std::string part(text.substr(0, kMostCharacters));
  std::replace_if(
      part.begin(), part.end(), [](char c) { return !may_stand_in_a_name(c); }, '_');
  return part;
}

std::string case_file_name(const std::string& name, const std::string& error_class,
                           const Case& question) {
  Case bare = question;
  bare.note.clear();
  bare.answer.reset();
  const CaseWitness& witness = question.answered_by;
  const std::string sum = files::sha256_of(to_json(bare) + witness.engine + "\n" + witness.version);
  return name + "-" + name_part(error_class) + "-" + sum.substr(0, kDigestCharacters) + ".json";
}

bool CaseFolder::write(const std::string& file, const Case& query) {
  std::string why;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error && !fs::is_directory(folder_)) {
    why = mesh_io::printable(folder_.string()) + ": " + error.message();
  } else {
    try {
      write_case(path(file), query);
      written_.insert(file);
      return true;
    } catch (const CaseError& refused) {
      why = refused.what();
    }
  }
  if (failure_.empty()) failure_ = why;
  return false;
}

std::size_t CaseFolder::count_others() const {
  std::error_code error;
  std::size_t count = 0;
  for (fs::directory_iterator at(folder_, error), end; !error && at != end; at.increment(error)) {
    const fs::path& file = at->path();
    count += file.extension() == ".json" && !written_.contains(file.filename().string());
  }
  return count;
}

}  // namespace graze::cli
