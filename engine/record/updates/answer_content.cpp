#include <graze/engine/record/coding/doubles.h>
#include <graze/engine/record/coding/work_counters.h>
#include <graze/engine/record/updates/answer_content.h>

#include <algorithm>

namespace graze::record {
namespace {

using Vector = Eigen::Vector3d;
constexpr std::size_t kNumbersOfContact = 13;
using ContactNumbers = std::array<double, kNumbersOfContact>;

// Of a contact: point on A, normal, depth, point on B, the point between.
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

/// What follows from the numbers before: by what a contact is, but for rounding.
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

void write_manifold(const Manifold& manifold, ByteWriter& to) {
  to.number(manifold.part_a()), to.number(manifold.part_b()), to.number(manifold.size());
  ContactNumbers before{};
  for (const ShapeContact& contact : manifold)
    write_contact(contact, before, to);
}

Manifold read_manifold(ByteReader& from) {
  Manifold manifold;
  const std::uint32_t part_a = from.number_up_to(0xffffffff, "part");
  manifold.set_parts(part_a, from.number_up_to(0xffffffff, "part"));
  ContactNumbers before{};
  // Seven bytes of lengths, and five numbers.
  for (std::size_t left = from.count(12, "contacts"); left > 0; --left) {
    const ShapeContact contact = read_contact(before, from);
    const std::uint32_t last = manifold.empty() ? 0 : manifold[manifold.size() - 1].region;
    if (contact.region < last || contact.region > (manifold.empty() ? 0 : last + 1))
      from.fail("contacts that are not region by region");
    manifold.add(contact);
  }
  return manifold;
}

/// Pairs in an order of theirs, each by how far its index is from that of the one before.
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

void write_contacts(std::span<const BodyContact> list, ByteWriter& to) {
  to.number(list.size());
  PairWriter pairs(to);
  for (const BodyContact& contact : list) {
    pairs.write(contact.pair);
    write_manifold(contact.manifold, to);
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
                                      (met.touches_at_start ? 8U : 0U)));
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
    met.touches_at_start = (bits & 8) != 0;
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
                  RecordedAnswers& to) {
  to.begun.assign(update.begun.begin(), update.begun.end());
  to.ended.assign(update.ended.begin(), update.ended.end());
  to.begun_near.assign(update.begun_near.begin(), update.begun_near.end());
  to.ended_near.assign(update.ended_near.begin(), update.ended_near.end());
  to.moved = update.moved.size(), to.all_contacts = update.contacts.size();
  to.contacts.clear();
  if (contacts != RecordedContacts::None) {
    // All three lists ascend.
    auto begun = update.begun.begin();
    auto near = update.begun_near.begin();
    for (const BodyContact& contact : update.contacts) {
      const BodyPair& pair = contact.pair;
      while (begun != update.begun.end() && *begun < pair)
        ++begun;
      while (near != update.begun_near.end() && *near < pair)
        ++near;
      if (contacts == RecordedContacts::All || (begun != update.begun.end() && *begun == pair) ||
          (near != update.begun_near.end() && *near == pair))
        to.contacts.push_back(contact);
    }
  }
  to.first_contacts.assign(update.first_contacts.begin(), update.first_contacts.end());
  to.work.reset();
  if (has_work) to.work = update.work;
}

void write_answers(const RecordedAnswers& answers, ByteWriter& to) {
  for (const auto* list :
       {&answers.begun, &answers.ended, &answers.begun_near, &answers.ended_near})
    write_pairs(*list, to);
  to.number(answers.moved), to.number(answers.all_contacts);
  write_contacts(answers.contacts, to);
  write_first_contacts(answers.first_contacts, to);
  if (!answers.work) return;
  for_each_counter(*answers.work, [&](const char*, std::uint64_t counter) { to.number(counter); });
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
  record::keep_answers(update, contacts, has_work, answers);
  return answers;
}

}  // namespace graze
