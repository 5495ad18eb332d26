#include "tests/engine/histories/player.h"

#include <graze/engine/world/world.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

#include "tests/engine/histories/contestant.h"
#include "tests/engine/histories/oracle.h"
#include "tests/engine/histories/questions.h"

namespace graze::tests {
namespace {

std::string listed(const std::vector<NamePair>& pairs) {
  std::string text;
  for (const auto& [a, b] : pairs)
    text += " " + std::to_string(a) + "/" + std::to_string(b);
  return text.empty() ? " none" : text;
}

void expect_equal(const std::vector<NamePair>& found, const std::vector<NamePair>& wanted,
                  const std::string& what) {
  expect(found == wanted, what + " is" + listed(found) + ", should be" + listed(wanted));
}

std::vector<NamePair> difference(const std::vector<NamePair>& s, const std::vector<NamePair>& t) {
  std::vector<NamePair> rest;
  std::set_difference(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(rest));
  return rest;
}

std::vector<NamePair> together(const std::vector<NamePair>& s, const std::vector<NamePair>& t) {
  std::vector<NamePair> all;
  std::set_union(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(all));
  return all;
}

bool has(const std::vector<NamePair>& list, const NamePair& pair) {
  return std::binary_search(list.begin(), list.end(), pair);
}

std::vector<NamePair> pairs_with(const std::vector<NamePair>& list, std::uint32_t name) {
  std::vector<NamePair> some;
  std::copy_if(list.begin(), list.end(), std::back_inserter(some),
               [&](const NamePair& pair) { return pair.first == name || pair.second == name; });
  return some;
}

/// Each once.
std::vector<NamePair> pairs_of(const std::vector<NamedContacts>& contacts) {
  std::vector<NamePair> pairs;
  for (const NamedContacts& each : contacts) {
    if (pairs.empty() || pairs.back() != each.pair) pairs.push_back(each.pair);
  }
  return pairs;
}

bool are_equal(const NamedContacts& s, const NamedContacts& t) {
  return s.pair == t.pair && s.contacts.part_a == t.contacts.part_a &&
         s.contacts.part_b == t.contacts.part_b && s.contacts.manifold == t.contacts.manifold;
}

std::string told(const NamedContacts& contact) {
  return std::to_string(contact.pair.first) + "/" + std::to_string(contact.pair.second) +
         ", parts " + std::to_string(contact.contacts.part_a) + "/" +
         std::to_string(contact.contacts.part_b);
}

/// How all worlds sweep: coarsely, for they do it five times.
const WorldSettings kSettings{.sweeps = {.tolerance = 0x1p-12}};

class Player {
 public:
  Player(const History& history, Fault fault) : oracle_(history.setting) {
    const Setting setting = history.setting;
    all_.reserve(5);
    all_.emplace_back("world", setting, kSettings);
    all_.back().fault = fault;
    all_.emplace_back("world without skips", setting,
                      WorldSettings{.threads = 3,
                                    .sweeps = kSettings.sweeps,
                                    .skip_apart = false,
                                    .skip_at_rest = false,
                                    .skip_unused_trees = false});
    all_.emplace_back("world without contacts", setting,
                      WorldSettings{.threads = 4, .contacts = false, .sweeps = kSettings.sweeps});
    all_.back().finds_contacts = false;
    all_.emplace_back("restored world", setting,
                      WorldSettings{.islands = true, .sweeps = kSettings.sweeps});
    all_.back().is_restored_often = true;
    all_.emplace_back("world in another order", setting, kSettings);
    all_.back().is_shuffled = true;
  }

  std::optional<Failure> play(const std::vector<Operation>& operations) {
    std::size_t at = 0;
    try {
      for (at = 0; at < operations.size(); ++at)
        at = perform(operations, at);
    } catch (const std::exception& error) {
      return Failure{std::min(at, operations.size() - 1), error.what()};
    }
    return std::nullopt;
  }

  const Sights& sights() const { return sights_; }

 private:
  std::size_t perform(const std::vector<Operation>& operations, std::size_t at);
  void move(std::span<const Operation> moves);
  void change(const Operation& operation);
  void save(const Operation& operation);
  void restore(const Operation& operation);
  void update();
  void check_update(const WorldUpdate& update, const Oracle::Lists& now);
  void check_first_contacts(const Contestant& each, const WorldUpdate& update,
                            const std::vector<NamedFirstContact>& truth);
  void check_contacts(const std::vector<NamedContacts>& found, const std::vector<NamePair>& of,
                      const char* what);
  void check_body(std::uint32_t name);
  void check_neighbours(const Contestant& each, const Oracle::Lists& now);

  Oracle oracle_;
  std::vector<Contestant> all_;  // never moved: filters of pairs refer to them
  Oracle::Lists before_;
  std::optional<Oracle> saved_;
  Oracle::Lists saved_before_;
  Sights sights_;
};

/// Returns the last operation that it has dealt with.
std::size_t Player::perform(const std::vector<Operation>& operations, std::size_t at) {
  const Operation& operation = operations[at];
  switch (operation.verb) {
    case Verb::Move:
    case Verb::MoveToo: {
      std::vector<Operation> moves;
      std::size_t end = at;
      do {
        if (oracle_.has(operations[end].body)) moves.push_back(operations[end]);
        ++end;
      } while (end < operations.size() && operations[end].verb == Verb::MoveToo);
      if (!moves.empty()) move(moves);
      return end - 1;
    }
    case Verb::Update:
      update();
      break;
    case Verb::Save:
      save(operation);
      break;
    case Verb::Restore:
      restore(operation);
      break;
    case Verb::AskTouching:
    case Verb::AskWithin:
    case Verb::AskClosest:
    case Verb::AskRay:
    case Verb::AskBox:
    case Verb::AskClosestPair:
    case Verb::AskCast: {
      const std::size_t found = check_answer(operation, all_[0].world, oracle_, all_[0].names);
      sights_.answers += found;
      sights_.casts += operation.verb == Verb::AskCast ? found : 0;
      break;
    }
    default:
      change(operation);
  }
  return at;
}

void Player::move(std::span<const Operation> moves) {
  for (const Operation& operation : moves)
    oracle_.change(operation);
  for (Contestant& each : all_) {
    if (each.is_shuffled) {
      each.waiting.insert(each.waiting.end(), moves.begin(), moves.end());
    } else {
      each.move(moves);
    }
  }
  check_body(moves[0].body);
}

void Player::change(const Operation& operation) {
  if (oracle_.concerns_nobody(operation)) return;
  oracle_.change(operation);
  for (Contestant& each : all_) {
    if (each.is_shuffled) {
      each.waiting.push_back(operation);
    } else {
      each.tell(operation);
    }
  }
  if (oracle_.has(operation.body)) check_body(operation.body);
}

void Player::check_body(std::uint32_t name) {
  if (all_[0].fault != Fault::None) return;
  const World& world = all_[0].world;
  const BodyId id = all_[0].ids.at(name);
  const Oracle::Being& being = oracle_.beings().at(name);
  const bool is_as_told =
      world.pose(id).matrix() == being.pose.matrix() && world.kind(id) == being.kind &&
      world.role(id) == being.role && world.user_data(id) == name &&
      world.filter(id) == being.filter && world.is_awake(id) == oracle_.is_awake(name) &&
      world.margin(id) == being.margin && world.detection(id) == being.detection;
  expect(is_as_told, "body " + std::to_string(name) + " is not as it was told to be");
  if (being.parts) being.parts->check(world.shape(id));
}

void Player::save(const Operation& operation) {
  if (oracle_.is_unsettled()) {
    bool is_refused = false;
    try {
      all_[0].world.snapshot();
    } catch (const InputError&) {
      is_refused = true;
    }
    expect(is_refused, "a snapshot was taken while changes wait");
    return;
  }
  for (Contestant& each : all_) {
    each.flush();
    each.tell(operation);
  }
  saved_ = oracle_;
  saved_before_ = before_;
}

void Player::restore(const Operation& operation) {
  if (!saved_) return;
  for (Contestant& each : all_) {
    each.waiting.clear();
    each.tell(operation);
  }
  oracle_ = *saved_;
  before_ = saved_before_;
  ++sights_.restored;
}

void Player::update() {
  const Oracle::Lists now = oracle_.lists(before_);
  const std::vector<NamedFirstContact> met = all_first_contacts(oracle_, kSettings);
  const bool is_time = ++sights_.updates % 16 == 0;
  std::vector<NamePair> moved;
  std::vector<NamedContacts> contacts;
  for (Contestant& each : all_) {
    each.flush();
    const WorldUpdate update = each.world.update();
    const auto is = [&](const char* list) { return each.title + ": " + list; };
    expect_equal(each.named(update.begun), difference(now.touching, before_.touching), is("begun"));
    expect_equal(each.named(update.ended), difference(before_.touching, now.touching), is("ended"));
    expect_equal(each.named(each.world.pairs()), now.touching, is("pairs()"));
    expect_equal(each.named(update.begun_near), difference(now.near, before_.near),
                 is("begun_near"));
    expect_equal(each.named(update.ended_near), difference(before_.near, now.near),
                 is("ended_near"));
    expect_equal(each.named(each.world.near_pairs()), now.near, is("near_pairs()"));
    check_first_contacts(each, update, met);
    expect(each.world.size() == oracle_.beings().size(), is("size()"));
    const std::vector<NamedContacts> found = each.named(update.contacts, oracle_);
    if (&each == &all_[0]) {
      moved = each.named(update.moved);
      contacts = found;
      check_update(update, now);
      check_contacts(contacts, pairs_of(contacts), "contacts");
      if (is_time) check_neighbours(each, now);
    } else {
      expect_equal(each.named(update.moved), moved, is("moved"));
      const bool is_same =
          std::equal(found.begin(), found.end(), contacts.begin(), contacts.end(), are_equal);
      expect(is_same || !each.finds_contacts, is("contacts differ from those of the first"));
    }
    if (each.is_restored_often) check_islands(each.world);
    if (is_time && !each.finds_contacts)
      check_contacts(each.named(each.world.contacts(), oracle_), together(now.touching, now.near),
                     "contacts()");
    if (each.is_restored_often && sights_.updates % 5 == 0)
      each.world.restore(each.world.snapshot());
  }
  before_ = now;
  oracle_.settle();
}

void Player::check_update(const WorldUpdate& update, const Oracle::Lists& now) {
  const std::vector<NamePair> moved = all_[0].named(update.moved);
  const std::vector<NamePair> all = together(now.touching, now.near);
  const std::vector<NamedContacts> contacts = all_[0].named(update.contacts, oracle_);
  const std::vector<NamePair> with_contacts = pairs_of(contacts);
  expect_equal(difference(moved, now.touching), {}, "moved, but not touching,");
  expect_equal(difference(with_contacts, all), {}, "in contact, but not near,");
  for (const NamePair& pair : together(moved, with_contacts))
    expect(oracle_.may_be_listed(pair),
           "listed is" + listed({pair}) + ", in which nothing changed");
  for (const NamePair& pair : all) {
    const bool must_be = oracle_.must_be_listed(pair), is_solid = oracle_.are_solid(pair);
    const bool touches = has(now.touching, pair), has_moved = has(moved, pair);
    expect(!must_be || !touches || has_moved, "moved lacks" + listed({pair}));
    const bool has_contacts = has(with_contacts, pair);
    const bool is_right = touches        ? has_contacts == (is_solid && has_moved)
                          : has_contacts ? is_solid
                                         : !(must_be && is_solid);
    expect(is_right, "the list of contacts is wrong about" + listed({pair}));
    sights_.contacts_apart += has_contacts && !touches ? 1 : 0;
  }
  for (const NamedContacts& contact : contacts) {
    const NamePair& pair = contact.pair;
    const bool has_parts =
        oracle_.beings().at(pair.first).parts || oracle_.beings().at(pair.second).parts;
    sights_.part_contacts += has_parts ? 1 : 0;
  }
  sights_.begun += update.begun.size(), sights_.ended += update.ended.size();
  sights_.begun_near += update.begun_near.size();
  sights_.contacts += update.contacts.size();
  sights_.pairs_apart += update.work.pairs_apart;
  sights_.pairs_at_rest += update.work.pairs_at_rest;
}

/// Of motions that bodies made since the last update.
void Player::check_first_contacts(const Contestant& each, const WorldUpdate& update,
                                  const std::vector<NamedFirstContact>& truth) {
  const std::vector<NamedFirstContact> found = each.named(update.first_contacts);
  for (std::size_t i = 0; i < std::max(found.size(), truth.size()); ++i) {
    const auto told = [&](const std::vector<NamedFirstContact>& list) {
      return i < list.size() ? tests::told(list[i]) : "none";
    };
    const bool is_same = i < found.size() && i < truth.size() && are_equal(found[i], truth[i]);
    expect(is_same,
           each.title + ": a first contact is" + told(found) + ", should be" + told(truth));
  }
  if (&each != &all_[0]) return;
  for (const NamedFirstContact& next : found) {
    const bool has_parts =
        oracle_.beings().at(next.pair.first).parts || oracle_.beings().at(next.pair.second).parts;
    ++sights_.first_contacts;
    sights_.later_first_contacts += next.contact.contact.low > 0;
    sights_.part_first_contacts += has_parts ? 1 : 0;
  }
}

/// What the world says of one body after the other.
void Player::check_neighbours(const Contestant& each, const Oracle::Lists& now) {
  for (const auto& [name, being] : oracle_.beings()) {
    const BodyId id = each.ids.at(name);
    const std::vector<NamePair> own = pairs_with(now.touching, name);
    const std::vector<NamePair> own_near = pairs_with(now.near, name);
    std::set<std::uint32_t> beside, found;
    for (const auto& [a, b] : own)
      beside.insert(a == name ? b : a);
    expect_equal(each.named(each.world.pairs(id)), own, "pairs() of one body");
    expect_equal(each.named(each.world.near_pairs(id)), own_near, "near_pairs() of one body");
    const std::vector<BodyId> touching = each.world.touching(id);
    expect(std::is_sorted(touching.begin(), touching.end()), "touching() is out of order");
    for (const BodyId other : touching)
      found.insert(each.names.at(other));
    expect(found == beside && touching.size() == beside.size(), "touching() differs");
    check_contacts(each.named(each.world.contacts(id), oracle_), together(own, own_near),
                   "contacts() of one body");
  }
}

/// All of the solid ones among these pairs, and no others.
void Player::check_contacts(const std::vector<NamedContacts>& found,
                            const std::vector<NamePair>& of, const char* what) {
  std::vector<NamedContacts> wanted;
  for (const NamePair& pair : of) {
    if (!oracle_.are_solid(pair)) continue;
    for (const PartContacts& contacts : oracle_.contacts(pair))
      wanted.push_back({pair, contacts});
  }
  for (std::size_t i = 0; i < std::max(found.size(), wanted.size()); ++i) {
    const bool is_same = i < found.size() && i < wanted.size() && are_equal(found[i], wanted[i]);
    expect(is_same, std::string(what) + " differ from the narrow phase's: " +
                        (i < found.size() ? told(found[i]) : "none") + ", should be " +
                        (i < wanted.size() ? told(wanted[i]) : "none"));
  }
}

}  // namespace

std::optional<Failure> play(const History& history, Sights* sights, Fault fault) {
  Player player(history, fault);
  const std::optional<Failure> failure = player.play(history.operations);
  if (sights != nullptr) *sights = player.sights();
  return failure;
}

}  // namespace graze::tests
