#pragma once

#include <graze/engine/python/binding/arguments/batch.h>
#include <graze/engine/python/binding/arguments/placed.h>

#include <functional>
#include <initializer_list>
#include <vector>

namespace graze::python {

/// Returns what `ask(index, work)` answers for each element, as run_batch() has it; a single one is
/// asked at once, on this thread. Answers may not be bools, of which threads could not write single
/// ones.
template <typename Answer, typename Ask>
std::vector<Answer> ask_all(bool is_many, std::size_t count, const Batch& batch, Work* work,
                            const Ask& ask, const std::function<void()>& blame = {},
                            std::size_t most_in_a_part = kMostInAPart) {
  std::vector<Answer> answers(count);
  if (is_many) {
    run_batch(
        count, batch, work, [&](std::size_t i, Work& own) { answers[i] = ask(i, &own); }, blame,
        most_in_a_part);
  } else {
    const py::gil_scoped_release released;
    ask_and_blame([&] { answers[0] = ask(0, work); }, blame);
  }
  return answers;
}

/// Asks about a pair of placed elements.
template <typename Answer, typename Ask>
std::vector<Answer> ask_all(const PlacedPair& pair, const Batch& batch, Work* work,
                            const Ask& ask) {
  return ask_all<Answer>(pair.is_many(), pair.size(), batch, work, ask,
                         [&] { pair.check_poses(); });
}

/// Makes an array of a member of each answer.
template <typename T, typename Answer, typename Member>
py::array_t<T> numbers_of(const std::vector<Answer>& answers, const Member& member) {
  auto array = new_array<T>({static_cast<py::ssize_t>(answers.size())});
  T* at = array.mutable_data();
  for (const auto& answer : answers)
    *at++ = static_cast<T>(member(answer));
  return array;
}
template <typename Answer, typename Member>
py::array_t<double> points_of(const std::vector<Answer>& answers, const Member& member) {
  auto array = new_array<double>({static_cast<py::ssize_t>(answers.size()), 3});
  double* row = array.mutable_data();
  for (const Answer& answer : answers) {
    write(member(answer), row);
    row += 3;
  }
  return array;
}
template <typename Answer, typename Member>
py::array_t<std::uint32_t> index_pairs_of(const std::vector<Answer>& answers,
                                          const Member& member) {
  auto array = new_array<std::uint32_t>({static_cast<py::ssize_t>(answers.size()), 2});
  std::uint32_t* row = array.mutable_data();
  for (const Answer& answer : answers) {
    row[0] = member(answer).a, row[1] = member(answer).b;
    row += 2;
  }
  return array;
}

/// Returns members of each part, one beside the other.
template <typename Part, typename Member>
py::object columns_of(const std::vector<Part>& parts, std::initializer_list<Member> members) {
  auto array = new_array<std::uint32_t>(
      {static_cast<py::ssize_t>(parts.size()), static_cast<py::ssize_t>(members.size())});
  std::uint32_t* at = array.mutable_data();
  for (const Part& part : parts) {
    for (const Member& member : members)
      *at++ = static_cast<std::uint32_t>(part.*member);
  }
  return array;
}

}  // namespace graze::python
