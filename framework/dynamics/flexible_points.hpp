// SPDX-License-Identifier: Apache-2.0
//
// Contacts of flexible bodies. The cost of such a body grows with the square of its points, and most contacts found do not touch: a
// needle has some within 20 um all along the jaws. So the body is asked about contacts that overlap or nearly do, and, where its
// answer moves farther than expected, again about all of them. Where there is no room for a point its contact shares the nearest
// one, and is counted: first contacts that bore force in the last step have room, then the deepest.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/contact_problem.hpp"

namespace swage::dynamics {

class TieConstraints;

class FlexiblePoints {
 public:
  explicit FlexiblePoints(ContactProblem& problem);

  /// Adds the points of contacts that overlap or nearly do; of all contacts where `all`.
  void add(const contact::ContactSet& contacts, std::span<const Tie> ties, bool all) noexcept;
  /// Corrects the gaps of contacts of a body whose surface is apart from its shapes.
  void meet_surfaces(contact::ContactSet& contacts) noexcept;
  /// Starts the solve where flexible bodies expect their points.
  void start_at_predictions(contact::ContactSet& contacts, TieConstraints& ties) noexcept;
  /// Whether a contact that no flexible body was asked about may touch. `moved`: the solve has moved something.
  bool missed_contact(contact::ContactSet& contacts, bool moved) noexcept;
  /// Restores the contacts as they were before the solve.
  void restore(contact::ContactSet& contacts) noexcept;

 private:
  /// A bound on the distance of a flexible body's points from their expected places [m]: most (1 + grows |p - middle|).
  struct PredictionError {
    double most = 0, grows = 0;  // m, 1/m
    Vec3 middle = Vec3::Zero();  // m, centre of the points that were asked about
  };

  void add(const contact::Contact& c, ContactWorkspace& k) noexcept;
  bool may_skip(const contact::Contact& c, const ContactWorkspace& k) const noexcept;
  PredictionError prediction_error(const contact::ContactSet& contacts, uint32_t block) const noexcept;
  void find_who_shares(const contact::ContactSet& contacts, std::span<const Tie> ties) noexcept;
  void share_points(const contact::ContactSet& contacts) noexcept;

  ContactProblem& p_;
  bool ask_all_ = false;
  uint32_t n_skipped_ = 0;        // contacts that flexible bodies have not been asked about
  std::vector<uint8_t> touched_;  // per block
  std::vector<uint32_t> points_;  // per block: number of points that contacts ask for
};

}  // namespace swage::dynamics
