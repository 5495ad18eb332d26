#pragma once

#include <graze/engine/compare/peers/engine.h>

#include <functional>
#include <memory>
#include <string>

namespace graze::compare {

/// An engine with a planted bug: it moves B the wrong way along x. It answers any, pairs and
/// distance, and about shapes, as graze does for the pose that it thinks it was given.
std::unique_ptr<Engine> make_wrong_sign_engine(const std::string& name);

/// graze with a planted bug: it tests only pairs of triangles whose bounds overlap by more than a
/// margin, as if volumes had been rounded inwards.
std::unique_ptr<Engine> make_inward_rounding_engine(const std::string& name, double margin);

/// graze, whose distances are so many metres more.
std::unique_ptr<Engine> make_off_engine(const std::string& name, double error);

/// What an engine may return that is no answer.
enum class NoAnswer {
  StrangeTriangle,  ///< a pair with a triangle that is not there
  Disorder,         ///< a pair twice
  NotANumber,       ///< of a distance, a point, a contact
  AnotherPart,      ///< the answer to another question
  Throw,            ///< an exception that is none of the library's
};

/// graze, but for such answers about any, pairs, distance and contacts.
std::unique_ptr<Engine> make_senseless_engine(const std::string& name, NoAnswer kind);

/// graze with a planted bug: it sees no motions, so that what meets only on its way is free to it.
std::unique_ptr<Engine> make_motionless_engine(const std::string& name);

/// graze, who calls `on_question` before each answer.
std::unique_ptr<Engine> make_watched_engine(const std::string& name,
                                            std::function<void()> on_question);

}  // namespace graze::compare
