#pragma once

// Writes and reads what goes over the pipe between graze and an engine: README.md has the lines one
// by one.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <graze/engine/cases/case.h>
#include <graze/engine/cases/text/json_cursor.h>
#include <graze/engine/compare/peers/engine.h>

namespace graze::compare {

/// The version of the protocol, which the first line of an engine names.
inline constexpr std::uint32_t kPeerProtocol = 1;

using BodyPairs = std::span<const std::pair<std::size_t, std::size_t>>;

/// Holds what an engine says of itself first.
struct PeerHello {
  CaseWitness witness;
  bool can_fork = false;  ///< knows "alone": answers as if nothing had been asked since it loaded
  /// The questions about two meshes that it knows; without a list any question may be asked, and is
  /// refused.
  std::optional<std::vector<std::string>> questions = {};
  bool answers_scenes = false;           ///< as Engine::answers_scenes()
  std::optional<double> tolerance = {};  ///< as Engine::tolerance()

  bool may_know(Ask ask) const;
};

// Requests are a line each, with its break. Their numbers read back bit for bit.

/// Return `"load": {...}` of two meshes, or of shapes, without the number of the request around it:
/// the same for every process that loads them.
std::string load_text(const Mesh& mesh_a, const Mesh& mesh_b);
std::string load_text(std::span<const std::string> shape_texts);

/// Returns the whole line of a request that has such a member.
std::string request_line(std::uint64_t id, std::string_view member);

/// Return `"question": ...` about the meshes that are loaded, or about pairs of the shapes that
/// are.
std::string question_text(const Question& question, const Pose& pose_a, const Pose& pose_b);
std::string question_text(std::span<const PlacedShape> bodies, BodyPairs pairs);

/// Returns the same about two of the shapes that are loaded, in motion.
std::string question_text(const Question& question, const PlacedShape& a, const PlacedShape& b);

/// Returns the text that is read as this very shape, bit for bit. Hulls and half-spaces round when
/// they are built, so that for a few there is none.
std::optional<std::string> shape_text(const Shape& shape);

// These functions read. All throw CaseError for anything else than what they read.

PeerHello read_hello(const cases::JsonCursor& at);

/// Reads an object with one member, named as in the body of a case.
Shape read_shape(const cases::JsonCursor& at);

}  // namespace graze::compare
