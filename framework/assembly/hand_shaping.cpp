// SPDX-License-Identifier: Apache-2.0
#include "assembly/hand_shaping.hpp"

#include "assembly/sentences.hpp"
#include "host/units.hpp"

namespace swage::assembly {
namespace {

using host::Law;

// order of host::Law
constexpr const char* kLaws[] = {"proportional", "null zone", "threshold", "quadratic", "table"};
constexpr double kMostForce = 1e3;  // N
constexpr std::size_t kMostPoints = 32;

bool force(const Json& json, double& out) {
  if (json.is_number()) {
    out = json.get<double>();
    return out >= 0 && out <= kMostForce;
  }
  if (!json.is_string()) return false;
  std::string error;
  return host::parse_quantity(json.get<std::string>(), "N", "a force", out, error) && out >= 0 && out <= kMostForce;
}

// begins at (0, 0); the first column rises strictly, the second one never falls
void read_table(ObjectReader& reader, const Teller& teller, host::Reaction& out) {
  reader.each("table", kMostPoints, [&](const Json& json, const std::string& pointer) {
    host::Reaction::Point p{};
    if (!json.is_array() || json.size() != 2 || !force(json[0], p.scene) || !force(json[1], p.hand))
      return teller.error(pointer, say::kNoPoint(short_dump(json)));
    const bool rises = out.table.empty() ? p.scene == 0 && p.hand == 0 : p.scene > out.table.back().scene && p.hand >= out.table.back().hand;
    if (!rises) return teller.error(pointer, say::kFallingTable());
    out.table.push_back(p);
  });
  if (out.table.size() < 2) teller.error(reader.at("table"), say::kShortTable());
}

}  // namespace

void read_filters(const Json& json, const std::string& pointer, const Teller& teller, LessonDevice& device) {
  host::HandFilters& out = device.filters;
  ObjectReader reader(json, pointer, "\"filters\"", teller);
  out.rate = reader.quantity("rate", "Hz", 0, 0, 1e3);
  out.low_pass = reader.quantity("low_pass", "Hz", 0, 0, 500);
  out.dead_band = reader.quantity("dead_band", "m", 0, 0, 0.1);
  out.dead_turn = reader.quantity("dead_turn", "rad", 0, 0, 1);
  reader.each("clutch", 32, [&](const Json& bit, const std::string& at) {
    if (!bit.is_number_unsigned() || bit.get<uint64_t>() > 31)
      return teller.error(at, say::kNoClutch(short_dump(bit)));
    out.clutch |= 1u << bit.get<uint32_t>();
  });
  device.clutch_of = reader.name("clutch_of", false);
  if (!device.clutch_of.empty() && out.clutch == 0) teller.error(reader.at("clutch_of"), say::kNoButtons());
  reader.finish();
}

void read_reaction(const Json& json, const std::string& pointer, const Teller& teller, host::Reaction& out) {
  ObjectReader reader(json, pointer, "\"reaction\"", teller);
  const std::string law = reader.choice("law", kLaws);
  for (std::size_t i = 0; i < std::size(kLaws); ++i)
    if (law == kLaws[i]) out.law = static_cast<Law>(i);
  out.from = reader.quantity("from", "N", 0, 0, kMostForce);
  if (out.law == Law::kTable)
    read_table(reader, teller, out);
  else if (reader.find("table") != nullptr)
    teller.error(reader.at("table"), say::kTableOfNoLaw());
  const bool needs = out.law != Law::kProportional && out.law != Law::kTable;
  if (needs && !(out.from > 0)) teller.error(reader.at("from"), say::kNoForce(law));
  reader.finish();
}

// The force guard limits both again (session/force_guard.hpp).
void read_hand_coupling(const Json& json, const std::string& pointer, const Teller& teller, host::HandCoupling& out) {
  ObjectReader reader(json, pointer, "\"coupling\"", teller);
  out.stiffness = reader.quantity("stiffness", "N/m", 0, 0, 1000);
  out.damping = reader.quantity("damping", "N*s/m", 0, 0, 5);
  reader.finish();
}

}  // namespace swage::assembly
