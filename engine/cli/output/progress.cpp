#include <graze/engine/cli/output/progress.h>

#include <fmt/format.h>
#include <unistd.h>
#include <cstdio>
#include <utility>

namespace graze::cli {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kSilentStart{2000};
constexpr milliseconds kRewriteInterval{200};
constexpr milliseconds kLineInterval{3000};

}  // namespace

Progress::Progress(std::string what, std::size_t total, const ProgressSettings& settings)
    : what_(std::move(what)), total_(total), next_report_(Clock::now() + kSilentStart) {
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  const bool shows_results = isatty(STDOUT_FILENO) != 0;
  if (is_terminal && !(shows_results && settings.has_rows)) {
    style_ = Style::Rewritten;
  } else {
    style_ = settings.is_forced ? Style::Lines : Style::Silent;
  }
}

Progress::~Progress() {
  erase();
}

void Progress::update(std::size_t done, const std::string& note) {
  if (!is_due()) return;
  erase();
  if (done >= total_) return;
  const std::string text =
      fmt::format("{} {} of {} done{}", what_, done, total_, note.empty() ? "" : " (" + note + ")");
  const bool is_rewritten = style_ == Style::Rewritten;
  std::fprintf(stderr, is_rewritten ? "%s" : "%s\n", text.c_str());
  std::fflush(stderr);
  is_shown_ = is_rewritten;
  next_report_ = Clock::now() + (is_rewritten ? kRewriteInterval : kLineInterval);
}

void Progress::erase() {
  if (is_shown_) std::fputs("\r\033[K", stderr);
  is_shown_ = false;
}

}  // namespace graze::cli
