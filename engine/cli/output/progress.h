#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace graze::cli {

struct ProgressSettings {
  /// True to report even if stderr is no terminal.
  bool is_forced = false;
  /// True if results are written row by row meanwhile: on a terminal they are the progress.
  bool has_rows = true;
};

/// Says on stderr how far long work has come, once it takes more than two seconds: one line that is
/// rewritten if stderr is a terminal, a line every few seconds if it is not and reports are forced,
/// and otherwise nothing. On a terminal that shows the rows of results too, these are the progress,
/// where there are any.
class Progress {
 public:
  Progress(std::string what, std::size_t total, const ProgressSettings& settings);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says how many parts are done; it is to be called whenever one more is. `note` stands behind,
  /// in brackets, if it is not empty.
  void update(std::size_t done, const std::string& note = "");

  /// True if update() would say anything: else the work for a note can be left out.
  bool is_due() const { return style_ != Style::Silent && Clock::now() >= next_report_; }

 private:
  using Clock = std::chrono::steady_clock;
  enum class Style { Silent, Rewritten, Lines };

  void erase();

  std::string what_;
  std::size_t total_;
  Style style_;
  Clock::time_point next_report_;
  bool is_shown_ = false;
};

}  // namespace graze::cli
