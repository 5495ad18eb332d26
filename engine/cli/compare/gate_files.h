#pragma once

#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/replay/fail_on.h>

namespace graze::cli {

/// Whether a comparison passes, and why not: every wrong answer of graze closes the gate, those of
/// other engines where --fail-on names them, and what differs from --against.
class Gate {
 public:
  /// `regression` is what --against has found; empty: nothing. The findings must outlive this.
  Gate(const CompareFindings& findings, const FailOn& fail_on, std::string regression);

  bool is_closed() const { return !wrong_.empty() || !regression_.empty(); }
  std::size_t named_by_fail_on() const { return named_; }
  const std::string& regression() const { return regression_; }

  /// The wrong answers of an engine that close it, in the order of places.
  std::vector<const compare::WrongAnswer*> wrong_of(const std::string& engine) const;

 private:
  std::vector<const compare::WrongAnswer*> wrong_;
  std::size_t named_ = 0;
  std::string regression_;
};

/// A suite of tests as JUnit writes it, which code hosts and their runners read: a test for each
/// engine, which fails where its wrong answers close the gate, and one for --against.
std::string junit_text(const CompareFindings& findings, const Gate& gate);

/// A summary in GitHub's Markdown: passed or not, the table of engines, and the first wrong
/// answers.
std::string markdown_text(const CompareFindings& findings, const Gate& gate);

}  // namespace graze::cli
