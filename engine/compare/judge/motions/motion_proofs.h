#pragma once

#include <graze/engine/cases/case.h>
#include <graze/engine/compare/judge/judgement.h>
#include <graze/engine/mesh/rigid_contact.h>

#include <map>
#include <mutex>
#include <optional>

namespace graze::compare {

/// Proves what it can about two meshes or bodies in motion, when it is first needed. The library
/// proposes; whatever is said here was shown by the checker of certificates, or by the judge of
/// poses. Many threads may ask it.
class MotionProofs {
 public:
  /// Keeps the case, which must outlive it. Throws what the library throws for such motions.
  explicit MotionProofs(const Case& query);

  /// Returns what the library answers, which says where to look for proofs.
  const RigidContact& proposed() const { return proposed_; }

  /// True if it is proved that they stay further apart than the clearance at all times: meshes by a
  /// certificate, other shapes by gaps that are proved, each of which lasts until the next.
  bool is_free() { return is_free_until(1); }

  /// True if that is proved from 0 to `time`, with room for what cutting off the rest of the
  /// motions rounds.
  bool is_free_until(double time);

  /// Returns a time at which a contact is proved, the earliest that is known.
  std::optional<double> contact();

  /// True if a contact at this time is proved, in the poses of law 14.
  bool is_contact(double time) const;

  /// True if it is proved that they are apart at this time.
  bool is_apart(double time) const;

  /// True if it is proved that they are no further apart than clearance and tolerance at this time.
  bool is_near(double time) const;

  /// Returns the judgement on an engine that calls them apart, or a hit, at this time.
  Judgement judge_at(double time, bool says) const;

  /// Returns the judgement on calling them apart from one time to another, where that is worst of
  /// some times in between; nothing where no contact is found there.
  std::optional<Judgement> judge_missed(double from, double to) const;

  /// Returns the time, of some, at which they come nearest.
  double nearest_time() const;

  /// Returns the question about the two as they stand at a time: whether they touch, or are within
  /// a clearance above 0.
  Case at(double time, double clearance) const;

 private:
  bool proves_free_until(double time) const;
  bool advances_to(double end) const;
  double proved_gap(double time) const;
  double depth_at(double time) const;

  const Case& query_;
  RigidContact proposed_;
  std::mutex mutex_;
  std::map<double, bool> known_free_;
  std::optional<bool> is_contact_known_;
};

}  // namespace graze::compare
