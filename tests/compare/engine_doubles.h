#pragma once

#include <graze/engine/compare/peers/engine.h>

#include <memory>

namespace graze::compare {

/// An engine with a planted bug: it moves B the wrong way along x. It answers any, pairs and
/// distance, and about shapes, as graze does for the pose that it thinks it was given.
std::unique_ptr<Engine> make_wrong_sign_engine(const std::string& name);

/// graze with a planted bug: it tests only pairs of triangles whose bounds overlap by more than a
/// margin, as if volumes had been rounded inwards.
std::unique_ptr<Engine> make_inward_rounding_engine(const std::string& name, double margin);

}  // namespace graze::compare
