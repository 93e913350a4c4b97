// SPDX-License-Identifier: Apache-2.0
#include "contact.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "toolkit/math.hpp"

namespace swage::coupling_contact {

using toolkit::vec;

void Contact::build(const ContactParams& params, CouplingBuilder& builder) {
  law_ = params;
  force_ = builder.signal("contact.force", "N", "Sum of the normal forces between the two objects.");
  overlap_ =
      builder.signal("contact.overlap", "m", "Deepest overlap of the two surfaces, 0 when they are apart.");
}

void Contact::activate(double dt_s) {
  const double most = kMostPerStep / (dt_s * dt_s);
  if (law_.stiffness <= most) return;
  char text[32];
  const int rate = static_cast<int>(std::lround(1 / dt_s));
  const auto end = std::to_chars(text, text + sizeof text, most, std::chars_format::general, 3).ptr;
  refuse("at " + std::to_string(rate) + " steps a second a contact is at most " + std::string(text, end) +
         " N/m stiff; take a lower \"stiffness\" or a higher \"rate_hz\"");
}

void Contact::resolve(const CouplingStep& step) {
  for (swage_contact& contact : step.contacts()) {
    contact.friction = law_.friction;
    contact.stiffness = law_.stiffness;
    contact.restitution = law_.restitution;
  }
}

void Contact::finish(const CouplingStep& step) {
  double force = 0, overlap = 0;
  for (const swage_contact& contact : step.contacts()) {
    force += std::max(0.0, vec(contact.f_a_W).dot(vec(contact.n_W)));
    overlap = std::max(overlap, -contact.gap);
  }
  step.signal(force_, force);
  step.signal(overlap_, overlap);
}

}  // namespace swage::coupling_contact

SWAGE_EXPORT(swage::coupling_contact::Contact)
