#include <graze/engine/record/coding/doubles.h>
#include <graze/engine/record/coding/pose_track.h>

#include <algorithm>
#include <cmath>

namespace graze::record {
namespace {

std::array<double, 12> numbers_of(const Pose& pose) {
  std::array<double, 12> numbers;
  for (std::size_t column = 0; column < 4; ++column)
    std::copy_n(pose.data() + 4 * column, 3, numbers.data() + 3 * column);
  return numbers;
}

Pose pose_of(const std::array<double, 12>& numbers) {
  Pose pose = Pose::Identity();
  for (std::size_t column = 0; column < 4; ++column)
    std::copy_n(numbers.data() + 3 * column, 3, pose.data() + 4 * column);
  return pose;
}

double size_of(double x, double y, double z) {
  return std::abs(x) + std::abs(y) + std::abs(z);
}

}  // namespace

void PoseTrack::begin(const Pose& pose) {
  *this = {};
  learn(numbers_of(pose));
}

/// Guesses R_1 (R_0^T R_1): the turn of before once more.
PoseTrack::Columns PoseTrack::guessed_turn() const {
  Columns guess;
  if (known_ < 2 || is_still_) {
    std::copy_n(turn_.begin(), guess.size(), guess.begin());
    return guess;
  }
  for (std::size_t column = 0; column < 2; ++column) {
    const double* now = turn_.data() + 3 * column;
    std::array<double, 3> step;  // the step of this column in the axes of before
    for (std::size_t k = 0; k < 3; ++k) {
      const double* axis = turn_before_.data() + 3 * k;
      step[k] = (axis[0] * now[0] + axis[1] * now[1]) + axis[2] * now[2];
    }
    for (std::size_t i = 0; i < 3; ++i)
      guess[3 * column + i] =
          (turn_[i] * step[0] + turn_[3 + i] * step[1]) + turn_[6 + i] * step[2];
  }
  return guess;
}

std::array<double, 3> PoseTrack::guessed_column(const Columns& turn) const {
  if (is_still_ && std::equal(turn.begin(), turn.end(), turn_.begin()))
    return {turn_[6], turn_[7], turn_[8]};
  return {turn[1] * turn[5] - turn[2] * turn[4], turn[2] * turn[3] - turn[0] * turn[5],
          turn[0] * turn[4] - turn[1] * turn[3]};
}

std::array<double, 3> PoseTrack::guessed_place() const {
  if (known_ < 2) return place_;
  std::array<double, 3> guess;
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = place_[i] - place_before_[i];
    const double step_before = place_before_[i] - place_long_before_[i];
    guess[i] = is_curved_ ? place_[i] + (step + (step - step_before)) : place_[i] + step;
  }
  return guess;
}

void PoseTrack::learn(const std::array<double, 12>& numbers) {
  std::array<double, 9> turn;
  std::copy_n(numbers.begin(), turn.size(), turn.begin());
  const std::array<double, 3> place = {numbers[9], numbers[10], numbers[11]};
  if (known_ == 3) {
    std::array<double, 3> straight, curved;
    for (std::size_t i = 0; i < 3; ++i) {
      const double step = place_[i] - place_before_[i];
      const double step_before = place_before_[i] - place_long_before_[i];
      straight[i] = place[i] - (place_[i] + step);
      curved[i] = straight[i] - (step - step_before);
    }
    is_curved_ =
        size_of(curved[0], curved[1], curved[2]) < size_of(straight[0], straight[1], straight[2]);
  }
  is_still_ = known_ != 0 && turn == turn_;
  place_long_before_ = place_before_;
  place_before_ = place_;
  place_ = place;
  turn_before_ = turn_;
  turn_ = turn;
  known_ = static_cast<std::uint8_t>(std::min(known_ + 1, 3));
}

void PoseTrack::write(const Pose& pose, ByteWriter& to) {
  const std::array<double, 12> actual = numbers_of(pose);
  Columns turn;
  std::copy_n(actual.begin(), turn.size(), turn.begin());
  const Columns guessed = guessed_turn();
  const std::array<double, 3> column = guessed_column(turn), place = guessed_place();
  std::array<double, 12> guess;
  std::copy_n(guessed.begin(), 6, guess.begin());
  std::copy_n(column.begin(), 3, guess.begin() + 6);
  std::copy_n(place.begin(), 3, guess.begin() + 9);
  write_doubles(to, actual, guess);
  learn(actual);
}

Pose PoseTrack::read(ByteReader& from) {
  DoubleReader<12> doubles(from);
  std::array<double, 12> actual;
  const Columns guessed = guessed_turn();
  Columns turn;
  for (std::size_t i = 0; i < 6; ++i)
    actual[i] = turn[i] = doubles.next(guessed[i]);
  const std::array<double, 3> column = guessed_column(turn), place = guessed_place();
  for (std::size_t i = 0; i < 3; ++i)
    actual[6 + i] = doubles.next(column[i]);
  for (std::size_t i = 0; i < 3; ++i)
    actual[9 + i] = doubles.next(place[i]);
  learn(actual);
  return pose_of(actual);
}

void write_pose(const Pose& pose, ByteWriter& to) {
  for (const double number : numbers_of(pose))
    to.real(number);
}

Pose read_pose(ByteReader& from) {
  std::array<double, 12> numbers;
  for (double& number : numbers)
    number = from.real();
  return pose_of(numbers);
}

}  // namespace graze::record
