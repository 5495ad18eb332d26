#include <graze/engine/record/coding/doubles.h>
#include <graze/engine/record/coding/work_counters.h>
#include <graze/engine/record/updates/answer_content.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace graze::record {
namespace {

using Vector = Eigen::Vector3d;
constexpr std::size_t kNumbersOfContact = 13;
using ContactNumbers = std::array<double, kNumbersOfContact>;

// The numbers of a contact are: point on A, normal, depth, point on B, the point between.
constexpr std::size_t kPointA = 0, kNormal = 3, kDepth = 6, kPointB = 7, kPoint = 10;

ContactNumbers numbers_of(const ShapeContact& contact) {
  ContactNumbers numbers;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    numbers[kPointA + i] = contact.point_a[axis];
    numbers[kNormal + i] = contact.normal[axis];
    numbers[kPointB + i] = contact.point_b[axis];
    numbers[kPoint + i] = contact.point[axis];
  }
  numbers[kDepth] = contact.depth;
  return numbers;
}

/// Guesses a number from those before it: by what a contact is it follows from them, but for
/// rounding.
double guess_of(const ContactNumbers& numbers, std::size_t which, const ContactNumbers& before) {
  if (which < kPointB) return before[which];
  if (which < kPoint) {
    const std::size_t axis = which - kPointB;
    return numbers[kPointA + axis] - numbers[kDepth] * numbers[kNormal + axis];
  }
  const std::size_t axis = which - kPoint;
  return 0.5 * (numbers[kPointA + axis] + numbers[kPointB + axis]);
}

void write_contact(const ShapeContact& contact, ContactNumbers& before, ByteWriter& to) {
  const ContactNumbers numbers = numbers_of(contact);
  ContactNumbers guess;
  for (std::size_t i = 0; i < kNumbersOfContact; ++i)
    guess[i] = guess_of(numbers, i, before);
  write_doubles(to, numbers, guess);
  before = numbers;
  to.number(contact.feature.a), to.number(contact.feature.b), to.number(contact.region);
  to.number(contact.material_a), to.number(contact.material_b);
}

ShapeContact read_contact(ContactNumbers& before, ByteReader& from) {
  DoubleReader<kNumbersOfContact> doubles(from);
  ContactNumbers numbers;
  for (std::size_t i = 0; i < kNumbersOfContact; ++i)
    numbers[i] = doubles.next(guess_of(numbers, i, before));
  before = numbers;
  ShapeContact contact{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    contact.point_a[axis] = numbers[kPointA + i];
    contact.normal[axis] = numbers[kNormal + i];
    contact.point_b[axis] = numbers[kPointB + i];
    contact.point[axis] = numbers[kPoint + i];
  }
  contact.depth = numbers[kDepth];
  contact.feature.a = from.number(), contact.feature.b = from.number();
  contact.region = from.number_up_to(0xffffffff, "region");
  contact.material_a = static_cast<std::uint16_t>(from.number_up_to(0xffff, "material"));
  contact.material_b = static_cast<std::uint16_t>(from.number_up_to(0xffff, "material"));
  return contact;
}

Manifold read_manifold(ByteReader& from) {
  Manifold manifold;
  const std::uint32_t part_a = from.number_up_to(0xffffffff, "part");
  manifold.set_parts(part_a, from.number_up_to(0xffffffff, "part"));
  ContactNumbers before{};
  // A contact has seven bytes of lengths, and five numbers.
  for (std::size_t left = from.count(12, "contacts"); left > 0; --left) {
    const ShapeContact contact = read_contact(before, from);
    const std::uint32_t last = manifold.empty() ? 0 : manifold[manifold.size() - 1].region;
    if (contact.region < last || contact.region > (manifold.empty() ? 0 : last + 1))
      from.fail("contacts that are not region by region");
    manifold.add(contact);
  }
  return manifold;
}

/// Writes pairs in an order of theirs, each by how far its index is from that of the one before.
class PairWriter {
 public:
  explicit PairWriter(ByteWriter& to) : to_(to) {}
  void write(const BodyPair& pair) {
    to_.difference(std::int64_t{pair.a.index} - last_);
    last_ = pair.a.index;
    to_.difference(std::int64_t{pair.b.index} - last_);
  }

 private:
  ByteWriter& to_;
  std::int64_t last_ = 0;
};

class PairReader {
 public:
  PairReader(ByteReader& from, const LastIds& ids) : from_(from), ids_(ids) {}
  BodyPair read() {
    last_ += static_cast<std::uint64_t>(from_.difference());
    const BodyId a = id_of(last_, ids_, from_);
    return {a, id_of(last_ + static_cast<std::uint64_t>(from_.difference()), ids_, from_)};
  }

 private:
  ByteReader& from_;
  const LastIds& ids_;
  std::uint64_t last_ = 0;
};

void write_contacts(const KeptAnswers& answers, ByteWriter& to) {
  to.number(answers.manifolds.size());
  PairWriter pairs(to);
  auto contact = answers.contacts.begin();
  for (const KeptManifold& manifold : answers.manifolds) {
    pairs.write(manifold.pair);
    to.number(manifold.part_a), to.number(manifold.part_b), to.number(manifold.contacts);
    ContactNumbers before{};
    for (const auto end = contact + manifold.contacts; contact != end; ++contact)
      write_contact(*contact, before, to);
  }
}

std::vector<BodyContact> read_contacts(ByteReader& from, const LastIds& ids) {
  std::vector<BodyContact> contacts;
  PairReader pairs(from, ids);
  for (std::size_t left = from.count(5, "contacts"); left > 0; --left) {
    const BodyPair pair = pairs.read();
    contacts.push_back({pair, read_manifold(from)});
  }
  return contacts;
}

void write_first_contacts(std::span<const BodyFirstContact> list, ByteWriter& to) {
  to.number(list.size());
  PairWriter pairs(to);
  for (const BodyFirstContact& met : list) {
    pairs.write(met.pair);
    to.byte(static_cast<std::uint8_t>(static_cast<unsigned>(met.contact.status) |
                                      (met.contact.is_out_of_budget ? 4U : 0U) |
                                      (met.is_at_start ? 8U : 0U)));
    to.real(met.contact.low), to.real(met.contact.high);
    for (const Vector* v : {&met.normal, &met.point})
      for (int i = 0; i < 3; ++i)
        to.real((*v)[i]);
    to.number(met.part_a), to.number(met.part_b);
  }
}

std::vector<BodyFirstContact> read_first_contacts(ByteReader& from, const LastIds& ids) {
  std::vector<BodyFirstContact> list;
  PairReader pairs(from, ids);
  for (std::size_t left = from.count(69, "first contacts"); left > 0; --left) {
    BodyFirstContact met{};
    met.pair = pairs.read();
    const unsigned bits = from.flags(15, "a first contact");
    if ((bits & 3) == 3) from.fail("a first contact's status is none");
    met.contact.status = static_cast<RigidStatus>(bits & 3);
    met.contact.is_out_of_budget = (bits & 4) != 0;
    met.is_at_start = (bits & 8) != 0;
    met.contact.low = from.real(), met.contact.high = from.real();
    for (Vector* v : {&met.normal, &met.point})
      for (int i = 0; i < 3; ++i)
        (*v)[i] = from.real();
    met.part_a = from.number_up_to(0xffffffff, "part");
    met.part_b = from.number_up_to(0xffffffff, "part");
    list.push_back(met);
  }
  return list;
}

/// Returns a number that ascends as pairs of bodies that are there do: each index has one body.
std::uint64_t place_of(const BodyPair& pair) {
  return std::uint64_t{pair.a.index} << 32 | pair.b.index;
}

/// So many manifolds come from memory while others are copied, with the bytes of each that has one
/// contact, as most have.
constexpr std::size_t kContactsAhead = 12, kBytesAhead = 192, kLine = 64;

/// Finds manifolds of an update, which take more than a cache holds, from the first to the last.
class ContactSearch {
 public:
  explicit ContactSearch(std::span<const BodyContact> all) : all_(all) {}

  /// Returns the manifolds of a pair, which are several if it has parts. No pair may be lower than
  /// the one asked before. Takes O(log of how far away they are).
  std::span<const BodyContact> of(const BodyPair& pair) {
    const std::uint64_t place = place_of(pair);
    prefetch();
    std::size_t step = 1;
    for (; at_ < all_.size() && place_at(at_) < place; step *= 2)
      at_ += step;
    // The last step may have led too far.
    if (step > 2) {
      const std::size_t low = at_ - step / 2 + 1;
      const auto first = all_.begin() + static_cast<std::ptrdiff_t>(low);
      const auto last = all_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, all_.size()));
      at_ = low +
            static_cast<std::size_t>(std::partition_point(first, last,
                                                          [place](const BodyContact& contact) {
                                                            return place_of(contact.pair) < place;
                                                          }) -
                                     first);
    }
    const std::size_t first = at_;
    while (at_ < all_.size() && place_at(at_) == place)
      ++at_;
    return all_.subspan(first, at_ - first);
  }

 private:
  std::uint64_t place_at(std::size_t index) const { return place_of(all_[index].pair); }

  void prefetch() {
    static_assert(kBytesAhead <= sizeof(BodyContact));
    const std::size_t end = std::min(all_.size(), at_ + kContactsAhead);
    for (fetched_ = std::max(fetched_, at_); fetched_ < end; ++fetched_) {
      const auto* bytes = reinterpret_cast<const char*>(&all_[fetched_]);
      for (std::size_t byte = 0; byte < kBytesAhead; byte += kLine)
        __builtin_prefetch(bytes + byte);
    }
  }

  std::span<const BodyContact> all_;
  std::size_t at_ = 0;       ///< the place behind what was found last
  std::size_t fetched_ = 0;  ///< the place up to which they are in a cache, or on their way
};

/// Visits those of the update's contacts that are kept. Takes O(those, and the log of the others).
template <typename Take>
void for_each_kept(const WorldUpdate& update, RecordedContacts which, const Take& take) {
  if (which == RecordedContacts::All)
    std::for_each(update.contacts.begin(), update.contacts.end(), take);
  if (which != RecordedContacts::Begun) return;
  ContactSearch search(update.contacts);
  // Both lists ascend, as the contacts do.
  auto begun = update.begun.begin(), near = update.begun_near.begin();
  while (begun != update.begun.end() || near != update.begun_near.end()) {
    const bool is_near =
        begun == update.begun.end() || (near != update.begun_near.end() && *near < *begun);
    for (const BodyContact& contact : search.of(is_near ? *near++ : *begun++))
      take(contact);
  }
}

void keep_all_but_contacts(const WorldUpdate& update, bool has_work, RecordedAnswers& to) {
  to.begun.assign(update.begun.begin(), update.begun.end());
  to.ended.assign(update.ended.begin(), update.ended.end());
  to.begun_near.assign(update.begun_near.begin(), update.begun_near.end());
  to.ended_near.assign(update.ended_near.begin(), update.ended_near.end());
  to.moved = update.moved.size(), to.all_contacts = update.contacts.size();
  to.first_contacts.assign(update.first_contacts.begin(), update.first_contacts.end());
  to.work.reset();
  if (has_work) to.work = update.work;
}

}  // namespace

BodyId id_of(std::uint64_t index, const LastIds& ids, const ByteReader& from) {
  if (index >= ids.size() || ids[index].index != index)
    from.fail("a body with index " + std::to_string(index) + ", which no body has had");
  return ids[index];
}

void write_pairs(std::span<const BodyPair> ascending, ByteWriter& to) {
  to.number(ascending.size());
  PairWriter pairs(to);
  for (const BodyPair& pair : ascending)
    pairs.write(pair);
}

std::vector<BodyPair> read_pairs(ByteReader& from, const LastIds& ids) {
  std::vector<BodyPair> pairs(from.count(2, "pairs"));
  PairReader reader(from, ids);
  for (BodyPair& pair : pairs)
    pair = reader.read();
  return pairs;
}

void keep_answers(const WorldUpdate& update, RecordedContacts contacts, bool has_work,
                  KeptAnswers& to) {
  keep_all_but_contacts(update, has_work, to.others);
  to.manifolds.clear(), to.contacts.clear();
  for_each_kept(update, contacts, [&](const BodyContact& contact) {
    const Manifold& manifold = contact.manifold;
    to.manifolds.push_back({.pair = contact.pair,
                            .part_a = manifold.part_a(),
                            .part_b = manifold.part_b(),
                            .contacts = static_cast<std::uint32_t>(manifold.size())});
    for (const ShapeContact& each : manifold)
      to.contacts.push_back(each);
  });
}

void write_answers(const KeptAnswers& answers, ByteWriter& to) {
  const RecordedAnswers& others = answers.others;
  for (const auto* list : {&others.begun, &others.ended, &others.begun_near, &others.ended_near})
    write_pairs(*list, to);
  to.number(others.moved), to.number(others.all_contacts);
  write_contacts(answers, to);
  write_first_contacts(others.first_contacts, to);
  if (!others.work) return;
  for_each_counter(*others.work, [&](const char*, std::uint64_t counter) { to.number(counter); });
}

RecordedAnswers read_answers(ByteReader& from, const LastIds& ids, bool has_work) {
  RecordedAnswers answers;
  for (std::vector<BodyPair>* list :
       {&answers.begun, &answers.ended, &answers.begun_near, &answers.ended_near})
    *list = read_pairs(from, ids);
  answers.moved = from.number(), answers.all_contacts = from.number();
  answers.contacts = read_contacts(from, ids);
  answers.first_contacts = read_first_contacts(from, ids);
  if (!has_work) return answers;
  answers.work.emplace();
  for_each_counter(*answers.work,
                   [&](const char*, std::uint64_t& counter) { counter = from.number(); });
  return answers;
}

}  // namespace graze::record

namespace graze {

RecordedAnswers answers_of(const WorldUpdate& update, RecordedContacts contacts, bool has_work) {
  RecordedAnswers answers;
  record::keep_all_but_contacts(update, has_work, answers);
  record::for_each_kept(update, contacts,
                        [&](const BodyContact& contact) { answers.contacts.push_back(contact); });
  return answers;
}

}  // namespace graze
