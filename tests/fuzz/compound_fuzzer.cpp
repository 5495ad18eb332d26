#include <graze/bvh/error.h>
#include <graze/engine/world/compound.h>
#include <graze/engine/world/world.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "tests/fuzz/byte_bodies.h"

// Compounds whose parts come, change and go, as a list that a test keeps has it; and each question
// about one beside the same about its parts as bodies of their own.

using namespace graze;
using fuzz::fail_if;

namespace {

struct Part {
  PlacedShape placed;
  PartSettings settings;
};

/// What a compound should hold: numbers that are free are used again, that which was freed last
/// first.
class Model {
 public:
  std::uint32_t next() const { return free_.empty() ? count_ : free_.back(); }
  void add(const Part& part) {
    const std::uint32_t number = next();
    free_.empty() ? void(++count_) : free_.pop_back();
    parts_.insert({number, part});
  }
  void remove(std::uint32_t number) {
    parts_.erase(number);
    free_.push_back(number);
  }
  std::map<std::uint32_t, Part>& parts() { return parts_; }

 private:
  std::map<std::uint32_t, Part> parts_;
  std::vector<std::uint32_t> free_;
  std::uint32_t count_ = 0;
};

/// Whether `change()` was taken; it may throw StaleIdError exactly if there is no such part.
template <typename Change>
bool is_taken(bool is_there, const Change& change) {
  try {
    change();
    fail_if(!is_there, "a part that is not there was changed");
    return true;
  } catch (const StaleIdError&) {
    fail_if(is_there, "a part that is there is called stale");
  } catch (const Error&) {
    fail_if(!is_there, "the part that is not there is not what is named");
  }
  return false;
}

Part part_of(fuzz::ByteShapes& bytes) {
  const Shape shape = fuzz::shape(bytes);
  Part part{{shape, bytes.pose()}, {}};
  if (bytes.byte() % 4 == 0)
    part.settings.filter = Filter{.category = bytes.byte() % 4u, .mask = bytes.byte() % 4u};
  return part;
}

void change(Compound& compound, Model& model, fuzz::ByteShapes& bytes) {
  const int kind = bytes.byte();
  const std::uint32_t number = bytes.byte() % 6;
  const bool is_there = model.parts().contains(number);
  fail_if(compound.contains(number) != is_there, "another answer to whether a part is there");
  if (kind % 6 == 5) {
    if (is_taken(is_there, [&] { compound.remove(number); })) model.remove(number);
    return;
  }
  try {
    const Part part = part_of(bytes);
    if (kind % 6 == 4) {
      if (is_taken(is_there, [&] { compound.replace(number, part.placed); }))
        model.parts().at(number).placed = part.placed;
    } else if (kind % 6 == 3) {
      if (is_taken(is_there, [&] { compound.set_settings(number, part.settings); }))
        model.parts().at(number).settings = part.settings;
    } else {
      const std::uint32_t given = compound.add(part.placed, part.settings);
      fail_if(given != model.next(), "another number than the one that was freed last");
      model.add(part);
    }
  } catch (const Error&) {
    // A shape or a pose that is none, a half-space.
  }
}

/// The same scene twice: as a compound, and as its parts.
struct Scenes {
  World whole, alone;
  std::vector<std::uint32_t> numbers;  ///< of the parts, by the index of the body alone
  bool are_ordinary = true;            ///< the parts
};

bool fill(Scenes& scenes, const Compound& compound, Model& model, const Pose& pose) {
  bool is_refused = false;
  for (const auto& [number, part] : model.parts()) {
    try {
      BodySettings settings;
      if (part.settings.filter) settings.filter = *part.settings.filter;
      scenes.alone.add({part.placed.shape, placed_part(pose, part.placed.pose)}, settings);
      scenes.numbers.push_back(number);
      scenes.are_ordinary &=
          fuzz::is_ordinary({part.placed.shape, placed_part(pose, part.placed.pose)});
    } catch (const Error&) {
      is_refused = true;
    }
  }
  try {
    scenes.whole.add({share(compound), pose});
  } catch (const Error&) {
    return false;
  }
  fail_if(is_refused, "a compound stands where one of its parts must not");
  return true;
}

void ask(const Scenes& scenes, const PlacedShapeView& shape, const Ray& ray) {
  const BodyQuerySettings query{.filter = Filter{.category = 1, .mask = 3}};
  const auto same = [&](const BodyQuerySettings& settings) {
    const bool is_hit = !scenes.alone.find_touching(shape, settings).empty();
    fail_if(scenes.whole.find_touching(shape, settings).empty() == is_hit, "another yes or no");
    const auto nearest = scenes.alone.find_closest(shape, settings);
    const auto found = scenes.whole.find_closest(shape, settings);
    fail_if(found.has_value() != nearest.has_value(), "one of both is near");
    if (found && scenes.are_ordinary && fuzz::is_ordinary(shape)) {
      const bool is_same =
          found->distance == nearest->distance && found->part == scenes.numbers[nearest->id.index];
      // A search that did not end proves nothing.
      fail_if(!is_same && nearest->distance.status == PairStatus::Converged,
              "another nearest part");
    }
    const auto hit = scenes.alone.cast_ray(ray, settings);
    const auto of_whole = scenes.whole.cast_ray(ray, settings);
    fail_if(of_whole.has_value() != hit.has_value(), "one of both is met by the ray");
    if (hit)
      fail_if(!(hit->hit == of_whole->hit) || of_whole->part != scenes.numbers[hit->id.index],
              "another hit of a ray");
  };
  same({});
  same(query);
}

std::vector<std::pair<std::uint32_t, Manifold>> contacts(
    World& world, BodyId other, const std::vector<std::uint32_t>* numbers) {
  std::vector<std::pair<std::uint32_t, Manifold>> list;
  for (const BodyContact& contact : world.update().contacts) {
    if (contact.pair.a != other && contact.pair.b != other) continue;
    Manifold manifold = contact.manifold;
    const std::uint32_t part =
        numbers != nullptr ? (*numbers)[contact.pair.a.index] : manifold.part_a();
    manifold.set_parts(0, 0);
    list.push_back({part, manifold});
  }
  return list;
}

/// What moves among them, with a filter that all meet.
void meet(Scenes& scenes, const PlacedShapeView& shape) {
  for (World* world : {&scenes.whole, &scenes.alone})
    for (const BodyId id : world->bodies())
      world->set_kind(id, BodyKind::Static);
  const BodyId in_whole = scenes.whole.add({shape.shape, shape.pose});
  const BodyId alone = scenes.alone.add({shape.shape, shape.pose});
  fail_if(!(contacts(scenes.whole, in_whole, nullptr) ==
            contacts(scenes.alone, alone, &scenes.numbers)),
          "other contacts");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteShapes bytes(data, size);
  Compound compound;
  Model model;
  for (int changes = bytes.byte() % 24; changes > 0 && !bytes.is_empty(); --changes)
    change(compound, model, bytes);
  std::vector<std::uint32_t> numbers;
  for (const auto& [number, part] : model.parts()) {
    numbers.push_back(number);
    const auto &found = compound.settings(number).filter, &wanted = part.settings.filter;
    fail_if(found != wanted, "other settings");
  }
  fail_if(compound.parts() != numbers || compound.size() != numbers.size(), "other parts");
  try {
    const Pose pose = bytes.pose();
    Scenes scenes;
    if (!fill(scenes, compound, model, pose)) return 0;
    const Shape shape = fuzz::shape(bytes);
    const Pose at = bytes.pose();
    const Triangle t = bytes.triangle();
    ask(scenes, {shape, at}, {t.a, t.b - t.a});
    meet(scenes, {shape, at});
  } catch (const Error&) {
    // No parts, a pose, a shape or a ray that is none.
  }
  return 0;
}
