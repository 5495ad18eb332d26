#include <graze/engine/cli/commands/commands.h>
#include <graze/engine/pose_text.h>

#include <cctype>
#include <cstddef>
#include <string_view>

namespace graze::cli {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool begins_like_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text == "nan" || text == "inf")
    return true;  // these are numbers enough to be refused as
                  // poses
  if (text.starts_with('.')) text.remove_prefix(1);
  return !text.empty() && is_digit(text.front());
}

/// Returns how many numbers an option takes; 0 for all that take none, or one.
std::size_t numbers_of(std::string_view option) {
  constexpr std::size_t kScrewNumbers = 8;
  for (const std::string_view pose : {"--pose-a", "--pose-b", "--from", "--to"})
    if (option == pose) return kPoseNumbers;
  return option == "--screw" ? kScrewNumbers : 0;
}

/// Returns how many arguments from `first` on belong to an option that takes so many numbers.
std::size_t count_numbers(const std::vector<std::string>& arguments, std::size_t first,
                          std::size_t most) {
  if (first == arguments.size()) return 0;
  const std::string& text = arguments[first];
  if (!begins_like_number(text)) return text.starts_with('-') ? 0 : 1;
  if (text.find_first_of(" \t\n,") != text.npos) return 1;
  std::size_t count = 1;
  while (count < most && first + count < arguments.size() &&
         begins_like_number(arguments[first + count])) {
    ++count;
  }
  return count;
}

}  // namespace

std::vector<std::string> join_pose_arguments(const std::vector<std::string>& arguments) {
  std::vector<std::string> joined;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--") {
      joined.insert(joined.end(), arguments.begin() + static_cast<std::ptrdiff_t>(i),
                    arguments.end());
      break;
    }
    joined.push_back(arguments[i]);
    const std::size_t numbers = numbers_of(arguments[i]);
    if (numbers == 0) continue;
    const std::size_t count = count_numbers(arguments, i + 1, numbers);
    for (std::size_t k = 1; k <= count; ++k)
      joined.back() += (k == 1 ? "=" : " ") + arguments[i + k];
    i += count;
  }
  return joined;
}

}  // namespace graze::cli
