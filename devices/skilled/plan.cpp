// SPDX-License-Identifier: Apache-2.0
#include "plan.hpp"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>

#include "hand/hand.hpp"
#include "hand/reader.hpp"
#include "sentences.hpp"

namespace swage::skilled {
namespace {

using hand::Json;
using hand::Measure;
using hand::Reader;

struct Form {
  Verb verb;
  std::set<std::string> keys;  // allowed keys besides act, time, doc
  std::set<std::string> needed;
};

const std::map<std::string, Form>& forms() {
  static const std::map<std::string, Form> all = {
      {"wait", {Verb::kWait, {}, {}}},
      {"await", {Verb::kAwait, {"of", "signal", "more", "less", "mark", "s", "near"}, {}}},
      {"reach", {Verb::kReach, {"s", "past", "back", "from", "tilt", "keep"}, {"s"}}},
      {"close", {Verb::kClose, {"force", "closure"}, {}}},
      {"open", {Verb::kOpen, {"closure"}, {"closure"}}},
      {"back", {Verb::kBack, {"by"}, {"by"}}},
      {"move", {Verb::kMove, {"by", "at", "roll", "axis", "closing"}, {}}},
      {"draw", {Verb::kDraw, {"by", "of", "signal", "less"}, {"by", "of", "signal", "less"}}},
      {"bring", {Verb::kBring, {"mark", "s"}, {"mark", "s"}}},
      {"aim",
       {Verb::kAim, {"mark", "into", "across", "hover", "above", "inside"}, {"mark", "into", "across"}}},
      {"drive", {Verb::kDrive, {"angle"}, {"angle"}}},
      {"show", {Verb::kShow, {"mark", "at", "with", "across"}, {"mark", "at", "with", "across"}}},
      {"answer", {Verb::kAnswer, {"mark", "other", "of"}, {"mark", "other", "of"}}},
      {"choose", {Verb::kChoose, {"mark", "of", "signal", "among"}, {"mark", "of", "signal", "among"}}},
      {"wind", {Verb::kWind, {"about", "turns", "along", "in", "rolls", "roll", "follows", "of", "signal", "more", "less", "by"}, {"about", "turns"}}},
      {"again", {Verb::kAgain, {"from", "of", "signal", "more", "less"}, {"from"}}},
  };
  return all;
}

Vec3 direction(const Reader& reader, const Json& value, const std::string& where) {
  const Vec3 v = reader.vec3(value, Measure::kNumber, where);
  if (!(v.norm() > 0)) reader.fail(where, say::kNoDirection());
  return v.normalized();
}

std::string word(const Reader& reader, const Json& value, const std::string& where) {
  if (!value.is_string() || value.get<std::string>().empty()) reader.fail(where, say::kNameNeeded());
  return value.get<std::string>();
}

void check_keys(const Reader& reader, const Json& value, const Form& form, const std::string& where) {
  for (const auto& item : value.items()) {
    const std::string& key = item.key();
    if (key == "act" || key == "time" || key == "doc" || form.keys.contains(key)) continue;
    std::string all = "time";
    for (const std::string& known : form.keys) all += ", " + known;
    reader.fail(where + "/" + key, say::kUnknownKey(all));
  }
  for (const std::string& key : form.needed)
    if (!value.contains(key)) reader.fail(where, say::kMissing(key));
}

void read_numbers(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  const auto number = [&](const char* key, Measure measure, double& out) {
    if (value.contains(key)) out = reader.number(value[key], measure, where + "/" + key);
  };
  number("time", Measure::kTime, act.time);
  number("s", Measure::kNumber, act.s);
  number("past", Measure::kLength, act.past);
  number("back", Measure::kLength, act.back);
  number("tilt", Measure::kAngle, act.tilt);
  number("force", Measure::kForce, act.force);
  number("closure", Measure::kNumber, act.closure);
  number("hover", Measure::kLength, act.hover);
  number("above", Measure::kLength, act.above);
  number("inside", Measure::kLength, act.inside);
  number("angle", Measure::kAngle, act.angle);
  number("roll", Measure::kAngle, act.roll);
  number("more", Measure::kNumber, act.more);
  number("less", Measure::kNumber, act.less);
  number("near", Measure::kLength, act.near);
  number("turns", Measure::kNumber, act.turns);
  number("along", Measure::kLength, act.along);
  number("in", Measure::kLength, act.in);
  if (act.verb == Verb::kBack || act.verb == Verb::kWind) number("by", Measure::kLength, act.by);

  if (!(act.time > 0)) reader.fail(where + "/time", say::kTakesTime());
  if (act.closure < 0 || act.closure > 1) reader.fail(where + "/closure", hand::say::kClosure());
  if (act.s < 0 || act.s > 1) reader.fail(where + "/s", say::kPlaceOnNeedle());
}

// awaits either a signal or the needle at a mark, never both
void check_await(const Reader& reader, const Json& value, const std::string& where) {
  const auto all = [&](std::initializer_list<const char*> keys) {
    return std::all_of(keys.begin(), keys.end(), [&](const char* key) { return value.contains(key); });
  };
  const bool signal = all({"of", "signal"}) && (value.contains("more") || value.contains("less"));
  const bool mark = all({"mark", "s", "near"});
  const bool mixed = value.contains("signal") && value.contains("mark");
  if (signal == mark || mixed)
    reader.fail(where, say::kAwaited());
}

bool flag(const Reader& reader, const Json& value, const char* key, const std::string& where) {
  if (!value.contains(key)) return false;
  if (!value[key].is_boolean()) reader.fail(where + "/" + key, say::kFlagNeeded());
  return value[key].get<bool>();
}

// the keys of the felt signal are given all together, or none of them
void read_wind(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  int given = 0;
  for (const char* key : {"of", "signal", "more", "less", "by"}) given += value.contains(key);
  if (given != 0 && given != 5)
    reader.fail(where, say::kDrawn());
  act.rolls = flag(reader, value, "rolls", where);
  act.follows = flag(reader, value, "follows", where);
}

// unconditional, or while a signal is within limits
void check_again(const Reader& reader, const Json& value, const std::string& where) {
  const bool asks = value.contains("of") && value.contains("signal") && (value.contains("more") || value.contains("less"));
  const bool any = value.contains("of") || value.contains("signal") || value.contains("more") || value.contains("less");
  if (any && !asks) reader.fail(where, say::kGoesOn());
}

// marks to choose from
void read_among(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  if (!value.is_array() || value.empty()) reader.fail(where, say::kMarksNeeded());
  for (const Json& one : value) act.among.push_back(word(reader, one, where));
}

// by a displacement, or to a place
void read_way(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  act.to_place = value.contains("at");
  if (act.to_place == value.contains("by")) reader.fail(where, say::kWayOrPlace());
  if (!act.to_place) act.way = reader.vec3(value["by"], Measure::kLength, where + "/by");
}

// a move ends with a given attitude, or with the former one and a roll
void read_turn(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  act.turns_to = value.contains("axis") || value.contains("closing");
  if (!act.turns_to) return;
  if (value.contains("roll")) reader.fail(where, say::kRollOrTurn());
  act.attitude = hand::read_attitude(reader, value, where);
}

// from a side, or with the present attitude of the jaws
void read_reach(const Reader& reader, const Json& value, const std::string& where, Act& act) {
  act.keep = flag(reader, value, "keep", where);
  if (act.keep == value.contains("from")) reader.fail(where, say::kFromOrKeep());
}

Act read_act(const Reader& reader, const Json& value, const std::string& where) {
  if (!value.is_object() || !value.contains("act"))
    reader.fail(where, say::kAct());
  const std::string name = word(reader, value["act"], where + "/act");
  const auto found = forms().find(name);
  if (found == forms().end()) {
    std::string all;
    for (const auto& [known, form] : forms()) all += (all.empty() ? "" : ", ") + known;
    reader.fail(where + "/act", say::kNoAct(name, all));
  }
  check_keys(reader, value, found->second, where);

  Act act;
  act.verb = found->second.verb;
  read_numbers(reader, value, where, act);
  if (act.verb == Verb::kAwait) check_await(reader, value, where);
  if (act.verb == Verb::kAgain) check_again(reader, value, where);
  if (act.verb == Verb::kWind) read_wind(reader, value, where, act);
  if (act.verb == Verb::kMove || act.verb == Verb::kDraw) read_way(reader, value, where, act);
  if (act.verb == Verb::kMove) read_turn(reader, value, where, act);
  if (act.verb == Verb::kReach) read_reach(reader, value, where, act);
  if (act.verb == Verb::kAgain) {
    if (!value["from"].is_number_unsigned())
      reader.fail(where + "/from", say::kEarlierAct());
    act.from_act = value["from"];
  } else if (value.contains("from")) {
    act.from = direction(reader, value["from"], where + "/from");
  }
  if (value.contains("at")) act.at = reader.vec3(value["at"], Measure::kLength, where + "/at");
  if (value.contains("with")) {
    const std::string with = word(reader, value["with"], where + "/with");
    if (with != "needle" && with != "jaws")
      reader.fail(where + "/with", say::kWithWhat());
    act.jaws = with == "jaws";
  }
  if (value.contains("among")) read_among(reader, value["among"], where + "/among", act);
  if (value.contains("other")) act.other = word(reader, value["other"], where + "/other");
  if (value.contains("about")) act.about = word(reader, value["about"], where + "/about");
  if (value.contains("of")) act.of = word(reader, value["of"], where + "/of");
  if (value.contains("signal")) act.signal = word(reader, value["signal"], where + "/signal");
  if (value.contains("across")) act.across = direction(reader, value["across"], where + "/across");
  if (value.contains("mark")) act.mark = word(reader, value["mark"], where + "/mark");
  if (value.contains("into") && value["into"].is_string())
    act.tissue = word(reader, value["into"], where + "/into");
  if (value.contains("into") && !value["into"].is_string())
    act.into = direction(reader, value["into"], where + "/into");
  return act;
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& name) {
  const Reader reader(name);
  const Json file = hand::object_of(reader, text, "swage-plan/1", {"format", "title", "doc", "start", "acts"}, say::kPlanHas());
  if (!file.contains("start") || !file.contains("acts") || !file["acts"].is_array() || file["acts"].empty())
    reader.fail("", say::kPlanNeeds());

  Plan plan;
  plan.title = reader.text(file, "title");
  const Json& start = file["start"];
  if (!start.is_object() || !start.contains("p")) reader.fail("/start", say::kStart());
  plan.start.p = reader.vec3(start["p"], Measure::kLength, "/start/p");
  plan.start.q = hand::read_attitude(reader, start, "/start");
  if (start.contains("closure"))
    plan.closure = reader.number(start["closure"], Measure::kNumber, "/start/closure");
  for (size_t i = 0; i < file["acts"].size(); ++i)
    plan.acts.push_back(read_act(reader, file["acts"][i], "/acts/" + std::to_string(i)));
  // what asks nothing goes back, and what asks may leave out acts as well
  for (size_t i = 0; i < plan.acts.size(); ++i)
    if (const Act& act = plan.acts[i]; act.verb == Verb::kAgain && (act.is_loop() ? act.from_act >= i : act.from_act == i || act.from_act >= plan.acts.size()))
      reader.fail("/acts/" + std::to_string(i) + "/from", say::kEarlierAct());
  return plan;
}

Plan load_plan(const std::string& path) { return parse_plan(hand::text_of(path), path); }

}  // namespace swage::skilled
