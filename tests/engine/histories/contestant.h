#pragma once

#include <graze/engine/world/world.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/histories/oracle.h"
#include "tests/engine/histories/player.h"
#include "tests/engine/histories/questions.h"
#include "tests/engine/histories/swept_contacts.h"
#include "tests/engine/histories/whole.h"

namespace graze::tests {

/// A manifold of a named pair, A being the one with the smaller name, and of two of their parts.
struct NamedContacts {
  NamePair pair;
  PartContacts contacts;
};

/// A world under test, and the names of its bodies.
struct Contestant {
  Contestant(std::string called, Setting setting, const WorldSettings& settings)
      : title(std::move(called)),
        world(settings),
        palette(palette_of(setting)),
        plans(plans_of(setting)) {}

  std::string title;
  World world;
  std::vector<Shape> palette;
  std::vector<PartsPlan> plans;
  std::map<std::uint32_t, BodyId> ids;
  std::map<std::uint32_t, Whole> wholes;  // of bodies that have parts
  std::map<BodyId, std::uint32_t> names;  // of all there ever were
  std::optional<WorldSnapshot> saved;
  std::map<std::uint32_t, BodyId> saved_ids;
  std::map<std::uint32_t, Whole> saved_wholes;
  std::vector<Operation> waiting;  // where bodies come in another order
  bool is_shuffled = false;
  bool is_restored_often = false;
  bool finds_contacts = true;
  Fault fault = Fault::None;

  std::vector<NamePair> named(std::span<const BodyPair> pairs) const {
    expect(std::is_sorted(pairs.begin(), pairs.end()), title + ": a list is out of order");
    std::vector<NamePair> all;
    for (const BodyPair& pair : pairs) {
      expect(pair.a < pair.b, title + ": a pair is out of order");
      all.push_back(ordered(names.at(pair.a), names.at(pair.b)));
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<NamedContacts> named(std::span<const BodyContact> contacts,
                                   const Oracle& oracle) const;
  std::vector<NamedFirstContact> named(std::span<const BodyFirstContact> contacts) const;

  void tell(const Operation& operation);
  void move(std::span<const Operation> moves);
  void flush();

 private:
  std::shared_ptr<const BodyShape> shape_for(std::uint32_t name, std::uint32_t number);
};

}  // namespace graze::tests
