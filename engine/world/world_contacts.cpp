// Where bodies that touch meet: found when asked for, from the poses alone.

#include <graze/engine/world/world_state.h>

#include <string>

namespace graze {

void World::State::check_is_settled(const char* what) const {
  if (changed.empty() && removed == 0) return;
  throw InputError(std::string(what) + ": changes wait for an update");
}

BodyContact World::State::contact_of(const BodyPair& pair) const {
  const Bodies::Body& a = all.bodies[pair.a.index];
  const Bodies::Body& b = all.bodies[pair.b.index];
  return {pair, a.shape->contacts(a.pose, *b.shape, b.pose)};
}

void World::State::find_contacts() {
  contacts.clear();
  if (!settings.contacts) {
    work.contacts_skipped = moved.size();
    return;
  }
  for (const BodyPair& pair : moved) {
    if (all.are_solid(pair.a.index, pair.b.index)) contacts.push_back(contact_of(pair));
  }
  work.contacts_found = contacts.size();
  work.contacts_skipped = moved.size() - contacts.size();
}

std::vector<BodyContact> World::contacts() const {
  state_->check_is_settled("contacts");
  std::vector<BodyContact> contacts;
  for (const BodyPair& pair : pairs()) {
    if (state_->all.are_solid(pair.a.index, pair.b.index))
      contacts.push_back(state_->contact_of(pair));
  }
  return contacts;
}

}  // namespace graze
