#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tests/benchmark/triangles/contest.h>

namespace graze::benchmark {

/// Answers element by element with a function that the compiler sees through.
template <typename Element, typename Answer>
class OneByOne final : public Contestant<Element> {
 public:
  OneByOne(std::string name, Answer answer) : name_(std::move(name)), answer_(answer) {}

  std::string name() const override { return name_; }
  void prepare(const std::vector<Element>& elements) override { elements_ = &elements; }
  void answer(std::vector<std::uint8_t>& hits) override {
    for (std::size_t n = 0; n < elements_->size(); ++n)
      hits[n] = answer_((*elements_)[n]);
  }

 private:
  std::string name_;
  Answer answer_;
  const std::vector<Element>* elements_ = nullptr;
};

}  // namespace graze::benchmark
