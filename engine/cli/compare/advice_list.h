#pragma once

#include <span>
#include <string>
#include <vector>

#include <graze/engine/cli/compare/compare_output.h>
#include <graze/engine/compare/run/advice/advice.h>

namespace graze::cli {

/// Returns what to do about the wrong answers of a run: for each engine and each class of its
/// errors.
std::vector<compare::Advice> advice_of(const CompareOptions& options,
                                       const CompareFindings& findings,
                                       std::span<const WrittenCase> cases,
                                       std::span<const compare::EngineEntry> field);

/// Returns a paragraph for each; empty if there is nothing to say.
std::string advice_text(std::span<const compare::Advice> advice);

/// Returns one JSON object on one line, {"advice":[...]}; empty if there is nothing to say.
std::string advice_json(std::span<const compare::Advice> advice);

/// Return a section of a page, with the texts of issues folded away.
std::string advice_html(std::span<const compare::Advice> advice);
std::string advice_markdown(std::span<const compare::Advice> advice);

}  // namespace graze::cli
