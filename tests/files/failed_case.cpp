#include "tests/files/failed_case.h"

#include <graze/engine/cases/write_case.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <iostream>
#include <string>
#include <utility>

namespace graze::tests {
namespace {

std::size_t failures_of_running_test() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) return 0;
  std::size_t count = 0;
  for (int i = 0; i < test->result()->total_part_count(); ++i)
    count += test->result()->GetTestPartResult(i).failed();
  return count;
}

std::string name_of_running_test() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) return "case";
  std::string name = std::string(test->test_suite_name()) + "-" + test->name();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '-'; },
      '_');
  return name;
}

/// The first name with a number that is free; none if there are as many files as there may be.
std::filesystem::path free_file(const FailedCaseSettings& settings) {
  for (std::size_t i = 0; i < settings.limit; ++i) {
    std::filesystem::path file =
        settings.folder / (name_of_running_test() + "-" + std::to_string(i) + ".json");
    if (!std::filesystem::exists(file)) return file;
  }
  return {};
}

}  // namespace

CaseOnFailure::CaseOnFailure(std::function<Case()> make, FailedCaseSettings settings)
    : make_(std::move(make)), settings_(std::move(settings)) {
  if (!settings_.count_failures) settings_.count_failures = failures_of_running_test;
  if (settings_.folder.empty()) settings_.folder = GRAZE_FAILED_CASES_DIR;
  before_ = settings_.count_failures();
}

CaseOnFailure::~CaseOnFailure() {
  try {
    if (settings_.count_failures() == before_) return;
    std::filesystem::create_directories(settings_.folder);
    const std::filesystem::path file = free_file(settings_);
    if (file.empty()) return;
    Case query = make_();
    if (query.note.empty()) query.note = "failed in " + name_of_running_test();
    write_case(file, query);
    std::cout << "kept as a case: graze replay " << file.string() << std::endl;
  } catch (const std::exception& error) {
    std::cout << "no case could be kept: " << error.what() << std::endl;
  }
}

Case by_brute_force(Case query) {
  query.answered_by = {"brute force", ""};
  return query;
}

}  // namespace graze::tests
