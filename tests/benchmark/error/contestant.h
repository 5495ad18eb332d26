#pragma once

#include <graze/narrowphase/predicates/verdict.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace graze::benchmark {

/// What a contestant says of one element. Failed: it threw.
enum class Answer : std::uint8_t { Apart, Touching, Unsure, Failed };

inline Answer to_answer(bool is_hit) {
  return is_hit ? Answer::Touching : Answer::Apart;
}
inline Answer to_answer(narrowphase::Verdict verdict) {
  switch (verdict) {
    case narrowphase::Verdict::No:
      return Answer::Apart;
    case narrowphase::Verdict::Yes:
      return Answer::Touching;
    case narrowphase::Verdict::Unsure:
      break;
  }
  return Answer::Unsure;
}

enum class Origin { Graze, Baseline, Peer };

struct Label {
  std::string name;
  Origin origin;
  std::string precision;          ///< "double", "float" or "exact"
  std::optional<double> epsilon;  ///< what is snapped to zero; of a family of the same name
};

/// What a reply looks like: an Answer where the question is yes or no, a number where it is how
/// far.
template <typename Reply>
struct Replies {
  template <typename Value>
  static Reply of(const Value& value) {
    return to_answer(value);
  }
  static Reply failed() { return Reply::Failed; }
};
template <>
struct Replies<double> {
  static double of(double value) { return value; }
  static double failed() { return std::numeric_limits<double>::quiet_NaN(); }
};

/// A way to answer one question. What it wants of the elements it prepares untimed.
template <typename Element, typename Reply = Answer>
class Contestant {
 public:
  explicit Contestant(Label label) : label_(std::move(label)) {}
  virtual ~Contestant() = default;

  const Label& label() const { return label_; }

  virtual void prepare(std::span<const Element> elements) = 0;
  virtual void release() = 0;

  /// Reads what answer() will read, so that it is in the cache; learns no branch.
  virtual void warm(std::size_t first, std::size_t count) const = 0;

  /// answers[i] becomes the answer for element first + i.
  virtual void answer(std::size_t first, std::span<Reply> answers) = 0;

 private:
  Label label_;
};

template <typename Element, typename Reply = Answer>
using Contestants = std::vector<std::unique_ptr<Contestant<Element, Reply>>>;

/// Reads one byte of each cache line.
template <typename Input>
void touch(std::span<const Input> inputs) {
  const auto bytes = std::as_bytes(inputs);
  unsigned sum = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 64)
    sum += std::to_integer<unsigned>(bytes[i]);
  [[maybe_unused]] volatile unsigned sink = sum;
}

/// Converts each element by `convert` and answers it by `test`.
template <typename Element, typename Reply, typename Convert, typename Test>
class OneByOne final : public Contestant<Element, Reply> {
 public:
  using Input = std::remove_cvref_t<std::invoke_result_t<const Convert&, const Element&>>;

  OneByOne(Label label, Convert convert, Test test)
      : Contestant<Element, Reply>(std::move(label)), convert_(convert), test_(std::move(test)) {}

  void prepare(std::span<const Element> elements) override {
    inputs_.clear();
    inputs_.reserve(elements.size());
    for (const Element& element : elements)
      inputs_.push_back(convert_(element));
  }
  void release() override { inputs_ = std::vector<Input>(); }
  void warm(std::size_t first, std::size_t count) const override {
    touch(std::span<const Input>(inputs_).subspan(first, count));
  }
  void answer(std::size_t first, std::span<Reply> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      try {
        answers[i] = Replies<Reply>::of(test_(inputs_[first + i]));
      } catch (const std::exception&) {
        answers[i] = Replies<Reply>::failed();
      }
    }
  }

 private:
  Convert convert_;
  Test test_;
  std::vector<Input> inputs_;
};

template <typename Element, typename Reply, typename Convert, typename Test>
void add(Contestants<Element, Reply>& contestants, Label label, Convert convert, Test test) {
  contestants.push_back(std::make_unique<OneByOne<Element, Reply, Convert, Test>>(
      std::move(label), std::move(convert), std::move(test)));
}

}  // namespace graze::benchmark
