// The second opinion when the samples are built without FCL: there is none.

#include "samples/second_opinion.h"

namespace graze::samples {

struct SecondOpinion::Models {};

SecondOpinion::SecondOpinion(const Mesh&, const Mesh&) {}

SecondOpinion::~SecondOpinion() = default;

std::optional<Opinion> SecondOpinion::on(const Pose&) const {
  return std::nullopt;
}

}  // namespace graze::samples
