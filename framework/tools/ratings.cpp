// SPDX-License-Identifier: Apache-2.0
#include "tools/ratings.hpp"

#include "host/rating_scales.hpp"
#include "tools/places.hpp"
#include "tools/print.hpp"

namespace swage::tools {
namespace {

std::vector<judge::RatingScale> scales(judge::Outcome outcome) {
  if (outcome != judge::Outcome::kPassed && outcome != judge::Outcome::kFailed) return {};
  std::vector<std::string> searched, errors;
  const std::string folder = data_folder("scales", searched);
  std::vector<judge::RatingScale> out;
  if (!folder.empty()) out = host::rating_scales(folder, errors);
  host::add_own_scales(out, errors);
  for (const std::string& error : errors) tell(base::Severity::kWarning, "", error);
  return out;
}

}  // namespace

nlohmann::ordered_json ratings_json(judge::Outcome outcome, judge::Metrics metrics) {
  using Json = nlohmann::ordered_json;
  Json out = Json::array();
  for (const judge::RatingScale& scale : scales(outcome)) {
    const judge::Rating rating = judge::rate(scale, metrics, outcome == judge::Outcome::kPassed);
    Json items = Json::array();
    for (size_t i = 0; i < scale.items.size(); ++i)
      items.push_back({{"id", scale.items[i].id},
                       {"title", judge::said_in(scale.items[i].title, "en")},
                       {"points", rating.item[i] ? Json(*rating.item[i]) : Json(nullptr)}});
    out.push_back({{"id", scale.id},
                   {"title", judge::said_in(scale.title, "en")},
                   {"source", judge::said_in(scale.source, "en")},
                   {"lowest", scale.lowest},
                   {"highest", scale.highest},
                   {"mean", rating.decided > 0 ? Json(rating.mean) : Json(nullptr)},
                   {"items", std::move(items)}});
  }
  return out;
}

std::string ratings_text(judge::Outcome outcome, judge::Metrics metrics) {
  std::string out;
  for (const judge::RatingScale& scale : scales(outcome)) {
    const judge::Rating rating = judge::rate(scale, metrics, outcome == judge::Outcome::kPassed);
    if (rating.decided == 0) continue;
    out += format("  %s: %.1f of %.0f over %zu of %zu items%s\n", judge::said_in(scale.title, "en").c_str(), rating.mean, scale.highest,
                  rating.decided, scale.items.size(), outcome == judge::Outcome::kPassed ? "" : ", of a failed attempt: no mark of the whole");
  }
  return out;
}

}  // namespace swage::tools
