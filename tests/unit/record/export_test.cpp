// SPDX-License-Identifier: Apache-2.0
//
// What leaves the store: tables that read back, statements that keep the published rules, files of people who are erased.
#include "record/export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "attempt.hpp"
#include "record/backup.hpp"
#include "record/erase.hpp"
#include "record/identity.hpp"
#include "record/school.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kHome = "https://school.example.org";

// RFC 4180, as any spreadsheet reads it
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> out(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      out.back().back() += text[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && c == ',')
      out.back().emplace_back();
    else if (!quoted && c == '\r' && text[i + 1] == '\n')
      ++i, out.emplace_back(1);
    else
      out.back().back() += c;
  }
  out.pop_back();
  return out;
}

// The rules of xAPI-Data.md 1.0.3 that concern what we write; "" when they are kept.
std::string broken_rule(const json& s) {
  static const std::regex kUuid("[0-9a-f]{8}-[0-9a-f]{4}-[1-5][0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}"), kIri("[a-z][a-z0-9+.-]*:[^ <>\"{}|\\\\^`]+"),
      kDuration("P(?=.)([0-9]+D)?(T(?=.)([0-9]+H)?([0-9]+M)?([0-9]+([.][0-9]+)?S)?)?"),
      kTime("[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}([.][0-9]+)?(Z|[+-][0-9]{2}:[0-9]{2})"), kLanguage("[a-z]{2,3}(-[A-Za-z0-9]+)*");
  const auto only = [](const json& o, const std::vector<std::string>& keys) {
    for (const auto& [key, value] : o.items())
      if (std::find(keys.begin(), keys.end(), key) == keys.end() || value.is_null()) return false;
    return o.is_object();
  };
  const auto is = [](const json& v, const std::regex& form) { return v.is_string() && std::regex_match(v.get<std::string>(), form); };
  const auto language_map = [&](const json& m) {
    for (const auto& [key, value] : m.items())
      if (!std::regex_match(key, kLanguage) || !value.is_string()) return false;
    return m.is_object();
  };
  const auto extensions = [&](const json& m) {
    for (const auto& [key, value] : m.items())
      if (!std::regex_match(key, kIri)) return false;
    return m.is_object();
  };
  if (!only(s, {"id", "actor", "verb", "object", "result", "context", "timestamp", "stored", "authority", "version", "attachments"})) return "an unknown property, or null";
  for (const char* needed : {"actor", "verb", "object"})
    if (!s.contains(needed)) return std::string("no ") + needed;
  if (s.contains("id") && !is(s["id"], kUuid)) return "id is no UUID";
  if (s.contains("version") && !is(s["version"], std::regex("1[.]0([.][0-9]+)?"))) return "version";
  if (s.contains("timestamp") && !is(s["timestamp"], kTime)) return "timestamp";
  const json& actor = s["actor"];
  if (!only(actor, {"objectType", "name", "mbox", "mbox_sha1sum", "openid", "account"})) return "actor";
  if (actor.value("objectType", "Agent") != "Agent") return "objectType of the actor";
  if (actor.count("mbox") + actor.count("mbox_sha1sum") + actor.count("openid") + actor.count("account") != 1) return "exactly one identifier of the actor";
  if (actor.contains("account") && (!only(actor["account"], {"homePage", "name"}) || !is(actor["account"].value("homePage", json()), kIri) || !actor["account"].value("name", json()).is_string()))
    return "account";
  if (!only(s["verb"], {"id", "display"}) || !is(s["verb"].value("id", json()), kIri) || (s["verb"].contains("display") && !language_map(s["verb"]["display"]))) return "verb";
  const json& object = s["object"];
  if (!only(object, {"objectType", "id", "definition"}) || object.value("objectType", "Activity") != "Activity" || !is(object.value("id", json()), kIri)) return "object";
  if (object.contains("definition")) {
    const json& d = object["definition"];
    if (!only(d, {"name", "description", "type", "moreInfo", "extensions"}) || (d.contains("name") && !language_map(d["name"])) || (d.contains("type") && !is(d["type"], kIri))) return "definition";
  }
  if (s.contains("result")) {
    const json& r = s["result"];
    if (!only(r, {"score", "success", "completion", "response", "duration", "extensions"})) return "result";
    if (r.contains("success") && !r["success"].is_boolean()) return "success";
    if (r.contains("completion") && !r["completion"].is_boolean()) return "completion";
    if (r.contains("duration") && !is(r["duration"], kDuration)) return "duration";
    if (r.contains("extensions") && !extensions(r["extensions"])) return "extensions of the result";
    if (r.contains("score")) {
      const json& c = r["score"];
      if (!only(c, {"scaled", "raw", "min", "max"})) return "score";
      if (c.contains("scaled") && !(c["scaled"] >= -1 && c["scaled"] <= 1)) return "scaled";
      if (c.contains("min") && c.contains("max") && !(c["min"] < c["max"])) return "min and max";
      if (c.contains("raw") && ((c.contains("min") && c["raw"] < c["min"]) || (c.contains("max") && c["raw"] > c["max"]))) return "raw";
    }
  }
  if (s.contains("context")) {
    const json& c = s["context"];
    if (!only(c, {"registration", "instructor", "team", "contextActivities", "revision", "platform", "language", "statement", "extensions"})) return "context";
    if (c.contains("registration") && !is(c["registration"], kUuid)) return "registration";
    if (c.contains("platform") && object.value("objectType", "Activity") != "Activity") return "platform";
    if (c.contains("extensions") && !extensions(c["extensions"])) return "extensions of the context";
  }
  return "";
}

class Export : public testing::Test {
 protected:
  Export() {
    const auto school = School::open(path_, error_);
    ada_.name = "Ada Meyer";
    bo_.name = "Bo";
    EXPECT_TRUE(school->add_person(ada_) && school->add_person(bo_));
    first_ = record_attempt(path_, 300, 1, "Ada Meyer");
    second_ = record_attempt(path_, 300, 2, "Bo");
    EXPECT_TRUE(school->set_void(second_, true, "=cmd, \"quoted\"\nand broken", "Mei"));
    Grade g;
    g.attempt_id = first_;
    g.plugins = {{"swage.lesson.grasp", "2.0.0"}};
    g.outcome = "failed";
    g.score = 40;
    g.metrics = {{"tries", "1", 4}};
    EXPECT_TRUE(Store::open(path_, error_)->add_grade(g, error_));
  }
  std::vector<Exported> read(const Selection& which = {}) {
    std::vector<Exported> out;
    EXPECT_TRUE(read_for_export(path_, which, out, error_)) << error_;
    return out;
  }
  std::string text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& path, const std::string& what) { std::ofstream(path, std::ios::binary) << what; }
  json statements() {
    std::string out;
    EXPECT_TRUE(xapi_statements(read(), kHome, out, error_)) << error_;
    return json::parse(out);
  }

  Folder folder_;
  std::string path_ = folder_ / "a.db", error_, first_, second_;
  Person ada_, bo_;
};

TEST_F(Export, TablesReadBackWithTheirProvenanceAndWithoutNames) {
  const std::string wide = csv_wide(read()), tall = csv_long(read());
  EXPECT_THAT(wide + tall, testing::Not(HasSubstr("Meyer")));
  const auto rows = parse_csv(wide);
  ASSERT_EQ(rows.size(), 3u);
  std::map<std::string, std::string> ada, bo;
  for (std::size_t i = 0; i < rows[0].size(); ++i) {
    ASSERT_EQ(rows[1].size(), rows[0].size());
    ada[rows[0][i]] = rows[1][i];
    bo[rows[0][i]] = rows[2][i];
  }
  EXPECT_EQ(ada["attempt"], first_);
  EXPECT_EQ(ada["person"], ada_.code);
  EXPECT_EQ(std::stod(ada["time [s]"]), 0.1 + 0.2) << "to the last bit";
  EXPECT_EQ(ada["never [m]"], "") << "no such column, as nobody reported it";
  EXPECT_EQ(ada["lesson_version"], lesson_digest(make_info().descriptor_text));
  EXPECT_EQ(ada["input"], "position") << "no hand of it takes forces, and none is scripted";
  EXPECT_EQ(ada["plugins"], "swage.object.needle 1.2.0; swage.device.mouse 1.0.0");
  EXPECT_EQ(ada["health.steps.executed [1]"], "1250");
  EXPECT_EQ(ada["health.solver.not_converged [1]"], "0");
  EXPECT_EQ(ada["calibration"], "[]");
  EXPECT_EQ(bo["void"], "1");
  EXPECT_EQ(bo["void_reason"], "'=cmd, \"quoted\" and broken") << "nothing that a spreadsheet would calculate";

  // the judgement of then, and the later one
  int then = 0, later = 0;
  for (const auto& row : parse_csv(tall)) {
    const std::size_t n = row.size();
    if (row[0] != first_ || row[n - 3] != "tries") continue;
    then += row[n - 2] == "3";
    later += row[n - 2] == "4" && row[n - 4] == "swage.lesson.grasp 2.0.0";
  }
  EXPECT_EQ(then, 1);
  EXPECT_EQ(later, 1);
  EXPECT_EQ(read({ada_.id, "", ""}).size(), 1u);
  EXPECT_EQ(read({"", "another", ""}).size(), 0u);
  std::vector<Exported> none;
  EXPECT_FALSE(read_for_export(folder_ / "absent.db", {}, none, error_));
}

// How it was seen and what it was measured with stand in every export, and come back with the recording.
TEST_F(Export, TheDisplayAndTheCalibrationStandInEveryExport) {
  AttemptInfo info = make_info(3, "Bo");
  info.display = {"lines", true, true, "up_down", 1, true};
  const std::string ours = R"({"format": "swage-calibration/1", "serial": "SN7", "date": "2026-11-01", "expires": "2027-11-01",
    "displacement": {"slope": 0.001, "worst": 2.5e-05}})", theirs = R"({"serial": "T1", "date": "2026-10-01", "residual": 0.25})";
  info.files.push_back({kCalibrationFile + std::string("handle"), ours});
  info.files.push_back({kCalibrationFile + std::string("pedal"), theirs});
  base::Problems problems;
  auto recorder = Recorder::open(path_, info, problems);
  ASSERT_NE(recorder, nullptr);
  recorder->step(make_step(3, 0));
  recorder->finish(make_end());
  const std::string id = recorder->attempt_id();

  const std::vector<Exported> one = read({"", "", id});
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].display, "lines, eyes swapped, mirrored up_down, scale 1, guided");
  const json calibrations = json::parse(one[0].calibration);
  ASSERT_EQ(calibrations.size(), 2u) << one[0].calibration;
  EXPECT_EQ(calibrations[0]["serial"], "SN7");
  EXPECT_EQ(calibrations[0]["date"], "2026-11-01");
  EXPECT_EQ(calibrations[0]["residual"], 2.5e-05) << "m, the worst of the fit";
  EXPECT_EQ(calibrations[1]["residual"], 0.25);
  EXPECT_THAT(csv_wide(one), HasSubstr("\"lines, eyes swapped, mirrored up_down, scale 1, guided\""));
  EXPECT_THAT(about_json(one[0]), HasSubstr("mirrored up_down"));
  std::string said;
  ASSERT_TRUE(xapi_statements(one, kHome, said, error_));
  EXPECT_EQ(json::parse(said)[0]["context"]["extensions"][std::string(kHome) + "/x/display"], one[0].display);
  EXPECT_EQ(broken_rule(json::parse(said)[0]), "");
  EXPECT_EQ(read({"", "", first_})[0].display, "") << "nobody said";

  Recording back;
  const std::string file = folder_ / "one.swage";
  ASSERT_TRUE(Store::open(path_, error_)->export_attempt(id, file, error_)) << error_;
  ASSERT_TRUE(read_recording(file, "", back, error_)) << error_;
  EXPECT_EQ(back.info.display, info.display);
  EXPECT_TRUE(same_attachments(back.info, info)) << "the display is no file of the lesson";
}

TEST_F(Export, StatementsKeepTheRulesOfXapi) {
  const json all = statements();
  ASSERT_EQ(all.size(), 2u);
  for (const json& s : all) EXPECT_EQ(broken_rule(s), "") << s.dump(1);
  EXPECT_EQ(all[0]["actor"]["account"]["name"], ada_.code);
  EXPECT_EQ(all[0]["result"]["extensions"][std::string(kHome) + "/x/metrics"]["tries"]["value"], 3.0);
  EXPECT_EQ(all[1]["context"]["extensions"][std::string(kHome) + "/x/valid"], false);
  EXPECT_FALSE(all[0]["result"].contains("success")) << "practice proves nothing";
  EXPECT_EQ(statements(), all) << "sent twice it is the same statement";
  EXPECT_NE(all[0]["id"], all[1]["id"]);
  std::string out;
  for (const char* wrong : {"", "school.example.org", "https://", "https://a b", "https://a/"}) {
    EXPECT_FALSE(xapi_statements(read(), wrong, out, error_)) << wrong;
    EXPECT_THAT(error_, HasSubstr("https://school.example.org"));
  }
}

// The rules themselves: each broken once.
TEST_F(Export, TheRulesOfXapiCanBeBroken) {
  const json good = statements()[0];
  const auto breaks = [&](const char* pointer, const json& value) {
    json s = good;
    s[json::json_pointer(pointer)] = value;
    EXPECT_NE(broken_rule(s), "") << pointer << " = " << value;
  };
  breaks("/id", "7");
  breaks("/id", "01a204d9-3873-796c-9ed0-6961a77946af");  // version 7: record stores of 1.0.3 refuse it
  breaks("/more", 1);
  breaks("/result/response", nullptr);
  breaks("/actor/mbox", "mailto:ada@example.org");
  breaks("/actor/account/homePage", "school");
  breaks("/verb/id", "attempted");
  breaks("/verb/display", "attempted");
  breaks("/object/id", "lesson 3");
  breaks("/object/definition/name/en", 3);
  breaks("/result/duration", "42.3 s");
  breaks("/result/duration", "PT");
  breaks("/result/score/scaled", 87.5);
  breaks("/result/score/raw", 101);
  breaks("/result/success", "yes");
  breaks("/result/extensions/metrics", 1);
  breaks("/context/registration", "course");
  breaks("/timestamp", "12 May");
  json s = good;
  s.erase("verb");
  EXPECT_NE(broken_rule(s), "");
}

TEST_F(Export, WhoIsErasedIsTakenOutOfWhatWasExported) {
  const auto school = School::open(path_, error_);
  std::string xapi;
  ASSERT_TRUE(xapi_statements(read(), kHome, xapi, error_));
  put(folder_ / "all.csv", csv_long(read()));
  put(folder_ / "all.json", xapi);
  put(folder_ / "ada.csv", csv_wide(read({ada_.id, "", ""})));
  Copied out;
  ASSERT_TRUE(backup_store(path_, folder_ / "all.backup", out, error_)) << error_;
  const auto clean = [&](const std::string& name, const std::string& kind, bool whole) {
    return erase_from_file({folder_ / name, station(), kind, "", whole}, ada_);
  };
  EXPECT_TRUE(clean("all.csv", "csv", false).done);
  EXPECT_THAT(text(folder_ / "all.csv"), testing::AllOf(testing::Not(HasSubstr(ada_.code)), HasSubstr(bo_.code)));
  EXPECT_TRUE(clean("all.json", "xapi", false).done);
  EXPECT_THAT(text(folder_ / "all.json"), testing::AllOf(testing::Not(HasSubstr(ada_.code)), HasSubstr(bo_.code)));
  EXPECT_EQ(json::parse(text(folder_ / "all.json")).size(), 1u);
  EXPECT_TRUE(clean("ada.csv", "csv", true).done);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "ada.csv"));
  EXPECT_TRUE(clean("all.backup", "backup", false).done);
  EXPECT_THAT(text(folder_ / "all.backup"), testing::Not(HasSubstr("Ada Meyer")));
  EXPECT_EQ(Store::open_to_read(folder_ / "all.backup", error_)->attempts("").size(), 1u);
  EXPECT_TRUE(clean("gone.csv", "csv", true).done) << "a file that is no longer there holds nothing";
  // what cannot be cleaned is said
  put(folder_ / "broken.json", "not JSON");
  EXPECT_FALSE(clean("broken.json", "xapi", false).done);
  const Cleaned elsewhere = erase_from_file({"/x.csv", "another machine", "csv", "", true}, ada_);
  EXPECT_FALSE(elsewhere.done);
  EXPECT_THAT(elsewhere.sentence, HasSubstr(say::kElsewhere("/x.csv", "another machine")));
  const Cleaned sent = erase_from_file({"https://lrs.example.org/xapi", "", "lrs", "", false}, ada_);
  EXPECT_FALSE(sent.done);
  EXPECT_THAT(sent.sentence, HasSubstr(say::kStatementsThere("https://lrs.example.org/xapi", ada_.code)));
}

}  // namespace
}  // namespace swage::record::test
