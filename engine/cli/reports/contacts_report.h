#pragma once

#include <optional>
#include <string>

#include <graze/engine/mesh/mesh_contacts.h>
#include <graze/engine/mesh/separating_translation.h>
#include <graze/engine/work.h>

namespace graze::cli {

/// Holds what `graze contacts` found.
struct ContactsAnswer {
  MeshContacts contacts;
  std::optional<SeparatingTranslation> separation;  ///< the separation, if it was asked for
  bool is_listing = false;                          ///< true to print the corners of each contact
  Work work;
};

/// Returns one JSON object on one line.
std::string to_json(const ContactsAnswer& answer);

/// Returns a table for people.
std::string to_text(const ContactsAnswer& answer);

/// Returns a point or a vector as a JSON list of three numbers.
std::string vector_json(const Eigen::Vector3d& v);

}  // namespace graze::cli
