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

namespace graze::tests {

/// A manifold of a named pair, A being the one with the smaller name.
struct NamedContacts {
  NamePair pair;
  Manifold manifold;
};

/// A world under test, and the names of its bodies.
struct Contestant {
  Contestant(std::string called, Setting setting, const WorldSettings& settings)
      : title(std::move(called)), world(settings), palette(palette_of(setting)) {}

  std::string title;
  World world;
  std::vector<Shape> palette;
  std::map<std::uint32_t, BodyId> ids;
  std::map<BodyId, std::uint32_t> names;  // of all there ever were
  std::optional<WorldSnapshot> saved;
  std::map<std::uint32_t, BodyId> saved_ids;
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

  /// Two of one shape in one place are the same two either way: there is nothing to mirror.
  std::vector<NamedContacts> named(std::span<const BodyContact> contacts,
                                   const Oracle& oracle) const {
    std::vector<NamedContacts> all;
    for (const BodyContact& contact : contacts) {
      const std::uint32_t a = names.at(contact.pair.a), b = names.at(contact.pair.b);
      all.push_back({ordered(a, b), contact.manifold});
      if (a < b || oracle.are_alike(a, b)) continue;
      Manifold& manifold = all.back().manifold;
      for (std::size_t i = 0; i < manifold.size(); ++i) {
        std::swap(manifold[i].point_a, manifold[i].point_b);
        manifold[i].normal *= -1;
        std::swap(manifold[i].feature.a, manifold[i].feature.b);
      }
    }
    std::sort(all.begin(), all.end(), [](const auto& s, const auto& t) { return s.pair < t.pair; });
    return all;
  }

  void tell(const Operation& operation);
  void move(std::span<const Operation> moves);
  void flush();
};

}  // namespace graze::tests
