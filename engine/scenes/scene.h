#pragma once

#include <compare>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <graze/engine/scenes/body_path.h>
#include <graze/engine/world/body.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/shape.h>

namespace graze {

/// Holds a shape that bodies share.
struct SceneShape {
  std::string name;  ///< the name by which bodies of the file refer to it
  Shape shape;       ///< the shape in its own frame
};

/// Holds a part of a body that has several.
struct ScenePart {
  std::size_t shape = 0;         ///< index into Scene::shapes
  Pose pose = Pose::Identity();  ///< the part's pose in the body's frame
  PartSettings settings = {};    ///< settings as a Compound takes them
};

/// Holds a body of a scene, and how it moves.
struct SceneBody {
  std::string name;                           ///< a name of its own in the scene
  std::size_t shape = 0;                      ///< index into Scene::shapes, if it has no parts
  Pose pose;                                  ///< its pose at time 0
  BodyKind kind = BodyKind::Dynamic;          ///< its kind as a world takes it
  Filter filter = {};                         ///< says which bodies it meets
  BodyPath path = {};                         ///< says how it moves by itself
  Detection detection = Detection::Discrete;  ///< says whether it is swept from step to step
  std::vector<ScenePart> parts = {};  ///< the parts of a Compound, in its order; empty for any
                                      ///< other shape
};

/// Holds two bodies by their indices, the smaller first.
struct ScenePair {
  std::size_t a = 0;  ///< index into Scene::bodies
  std::size_t b = 0;  ///< index into Scene::bodies, above `a`
  friend auto operator<=>(const ScenePair&, const ScenePair&) = default;
};

/// Holds bodies and how they move by themselves, as a file describes them. Metres and seconds.
struct Scene {
  std::string note;                   ///< a note on what the scene shows; may be empty
  double step = 1.0 / 60;             ///< seconds from one update to the next
  std::size_t steps = 100;            ///< the number of steps, unless the user says otherwise
  std::vector<SceneShape> shapes;     ///< the shapes, each with a name of its own
  std::vector<SceneBody> bodies;      ///< the bodies, each with a name of its own
  std::vector<ScenePair> exclusions;  ///< the pairs that never meet
};

/// Returns where a body of the scene is at a time, seconds.
inline Pose pose_at(const SceneBody& body, double time) {
  return pose_at(body.path, body.pose, time);
}

/// Returns what a world takes as the body's shape. Throws what share() throws.
std::shared_ptr<const BodyShape> body_shape(const Scene& scene, const SceneBody& body);

/// Returns the pairs that a world looks at, ascending: one of the two is dynamic, filters let them
/// pass and nothing excludes them. Takes quadratic time in the bodies.
std::vector<ScenePair> meeting_pairs(const Scene& scene);

}  // namespace graze
