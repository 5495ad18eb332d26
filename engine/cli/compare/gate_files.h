#pragma once

#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/cli/replay/fail_on.h>
#include <graze/engine/compare/run/advice/advice.h>

namespace graze::cli {

/// Says whether a comparison passes, and why not: every wrong answer of graze closes the gate, and
/// so do those of other engines where --fail-on names them, and what differs from --against.
struct Gate {
  bool is_closed = false;
  std::string regression = {};  ///< what --against has found; empty for nothing
};

/// Returns a suite of tests as JUnit writes it, which code hosts and their runners read: a test for
/// each engine, which fails where its wrong answers close the gate, and one for --against.
std::string junit_text(const CompareFindings& findings, const Gate& gate);

/// Returns a summary in GitHub's Markdown: passed or not, the table of engines, the first wrong
/// answers, and what to do about them.
std::string markdown_text(const CompareFindings& findings, const Gate& gate,
                          std::span<const compare::Advice> advice);

}  // namespace graze::cli
