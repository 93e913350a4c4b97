// SPDX-License-Identifier: Apache-2.0
#include "record/roster.hpp"

#include <algorithm>

namespace swage::record {

std::string select_people(bool school) {
  const std::string own = "SELECT p.person_id, p.pseudonym, p.created_utc, COALESCE(c.attempts, 0)";
  // counted for all people at once
  const std::string from =
      " FROM person p LEFT JOIN (SELECT s.person_id, COUNT(*) AS attempts FROM session s JOIN attempt a"
      " ON a.session_id = s.session_id GROUP BY s.person_id) c ON c.person_id = p.person_id";
  if (!school) return own + from + " ORDER BY p.pseudonym";
  return own + ", n.display_name, n.handedness, n.group_id, n.archived_utc" + from +
         " LEFT JOIN roster n ON n.person_id = p.person_id";
}

Person person_from(const Row& r) {
  Person p;
  p.id = text(r[0]);
  p.code = p.name = text(r[1]);
  p.created_utc = text(r[2]);
  p.attempts = static_cast<uint32_t>(integer(r[3]));
  if (r.size() < 8) return p;
  if (!text(r[4]).empty()) p.name = text(r[4]);
  p.handedness = text(r[5]);
  p.group_id = text(r[6]);
  p.archived_utc = text(r[7]);
  return p;
}

void sort_by_name(std::vector<Person>& people) {
  std::sort(people.begin(), people.end(),
            [](const Person& a, const Person& b) { return a.name != b.name ? a.name < b.name : a.id < b.id; });
}

}  // namespace swage::record
