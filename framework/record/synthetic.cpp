// SPDX-License-Identifier: Apache-2.0
#include "record/synthetic.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>

#include "base/rng.hpp"
#include "judge/learning.hpp"
#include "record/attempt_rows.hpp"
#include "record/identity.hpp"
#include "record/recorder.hpp"
#include "record/schema.hpp"
#include "record/school.hpp"
#include "record/seal.hpp"
#include "record/sentences.hpp"

namespace swage::record {
namespace {

constexpr double kNoise = 0.15;     // relative, scatter of the novice's share of an attempt about the person's curve
constexpr uint32_t kADay = 10;      // attempts per session
constexpr uint32_t kTestFrom = 6;   // attempts of a lesson before the first in Test; then every second is in Test
constexpr int64_t kDay = 86400;     // s
constexpr const char* kExperts = "Experts";  // name used by the console

// Real attempts at one lesson.
struct Model {
  Recording expert_recording;
  AttemptRow expert;
  std::vector<AttemptRow> novices, failed;
  std::string expert_id;
};

struct Trainee {
  Person person;
  bool is_expert = false;
  double talent = 0, pace = 0;  // share of the novice's distance that remains; number of attempts to a third
  std::vector<uint32_t> done;   // per lesson
};

double normal(base::Xoshiro256& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

std::string utc(int64_t seconds) {
  const time_t at = seconds;
  tm t{};
  gmtime_r(&at, &t);
  char out[96];
  std::snprintf(out, sizeof out, "%04d-%02d-%02dT%02d:%02d:%02d.000Z", t.tm_year + 1900, t.tm_mon + 1, t.tm_mday, t.tm_hour, t.tm_min, t.tm_sec);
  return out;
}

const MetricValue* find(const AttemptRow& a, const std::string& id) {
  const auto found = std::find_if(a.metrics.begin(), a.metrics.end(), [&](const MetricValue& m) { return m.id == id; });
  return found == a.metrics.end() ? nullptr : &*found;
}

/// Real attempts with their weights; the sum of the weights is 1.
using Mix = std::vector<std::pair<const AttemptRow*, double>>;

// Whole numbers stay whole. A value that one of the attempts lacks is missing in the mean.
template <class Value>
double mean(const Mix& mix, Value value) {
  double out = 0;
  bool whole = true;
  for (const auto& [attempt, weight] : mix) {
    const double v = value(*attempt);
    out += weight * v;
    whole = whole && v == std::round(v);
  }
  return whole ? std::round(out) : out;
}

double metric(const AttemptRow& a, const std::string& id) {
  const MetricValue* m = find(a, id);
  return m != nullptr ? m->value : std::numeric_limits<double>::quiet_NaN();
}

// Adds several attempts, with random weights whose sum is `share`.
void add_mix(Mix& mix, const std::vector<AttemptRow>& attempts, double share, base::Xoshiro256& random) {
  const std::size_t first = mix.size();
  double sum = 0;
  for (const AttemptRow& a : attempts) sum += mix.emplace_back(&a, -std::log(1 - random.uniform())).second;
  for (std::size_t i = first; i < mix.size(); ++i) mix[i].second *= share / sum;
}

class Writer {
 public:
  Writer(Database& to, Database& from, School& school, const SyntheticSchool& what)
      : to_(to), from_(from), school_(school), what_(what), random_(what.seed) {}

  bool write(std::vector<Model>& models, std::string& error) {
    if (!make_people(models.size())) return error = school_.error(), false;
    const std::vector<std::size_t> quota = quotas();
    const std::size_t most = *std::max_element(quota.begin(), quota.end()), days = (most + kADay - 1) / kADay;
    // the last attempts end yesterday, at any date of the run; people with fewer attempts end earlier
    const int64_t end = time(nullptr) / kDay * kDay - kDay;
    std::size_t left = what_.attempts;
    bool ok = to_.begin();
    for (std::size_t i = 0; i < most; ++i)
      for (std::size_t n = 0; ok && n < trainees_.size(); ++n) {
        if (i >= quota[n]) continue;
        const std::size_t day = i / kADay, lesson = std::min(models.size() - 1, i * models.size() / most);
        const int64_t start = end - static_cast<int64_t>((days - 1 - day) * 2) * kDay + 9 * 3600 +
                              static_cast<int64_t>(i % kADay) * 180 + static_cast<int64_t>(n) * 7;
        ok = attempt(trainees_[n], models[lesson], lesson, day, start, left-- <= what_.recordings);
      }
    ok = ok && to_.commit();
    // updates the server's statistics for its query plans, which it would do by itself only after a minute
    if (ok && to_.on_postgres()) ok = to_.run("ANALYZE");
    if (!ok) {
      error = "The synthetic school cannot be written: " + to_.error() + ".";
      to_.rollback();
      return false;
    }
    return make_course(models) || (error = school_.error(), false);
  }

 private:
  bool make_people(std::size_t lessons) {
    // the group whose band is the reference, unless a group of real experts exists
    const std::vector<Group> there = school_.groups();
    const bool taken = std::any_of(there.begin(), there.end(), [](const Group& g) { return g.name == kExperts; });
    Group trainees{"", "Synthetic residents", "", ""}, experts{"", taken ? "Synthetic experts" : kExperts, "", ""};
    if (!school_.add_group(trainees) || !school_.add_group(experts)) return false;
    const uint32_t masters = std::max(1u, what_.people / 10);
    for (uint32_t i = 0; i < what_.people; ++i) {
      Trainee t;
      char name[32];
      std::snprintf(name, sizeof name, "Synthetic %02u", i + 1);
      t.person.name = name;
      t.is_expert = i + masters >= what_.people;
      t.person.group_id = t.is_expert ? experts.id : trainees.id;
      t.person.handedness = random_.uniform() < 0.1 ? "left" : "right";
      t.talent = t.is_expert ? 0.02 : 0.05 + 0.45 * random_.uniform() * random_.uniform();
      t.pace = 4 + 20 * random_.uniform();
      t.done.assign(lessons, 0);
      if (!school_.add_person(t.person)) return false;
      trainees_.push_back(std::move(t));
    }
    group_ = trainees.id;
    return true;
  }

  // Number of attempts of each person: some have a third of the others'; the sum is what_.attempts.
  std::vector<std::size_t> quotas() {
    std::vector<double> weight;
    double sum = 0;
    for (const Trainee& t : trainees_) sum += weight.emplace_back(t.is_expert ? 1.0 : random_.uniform(0.4, 1.2));
    std::vector<std::size_t> out;
    std::size_t left = what_.attempts;
    for (const double w : weight) out.push_back(static_cast<std::size_t>(w / sum * what_.attempts)), left -= out.back();
    for (std::size_t i = 0; left > 0; i = (i + 1) % out.size(), --left) ++out[i];
    return out;
  }

  bool attempt(Trainee& t, const Model& m, std::size_t lesson, std::size_t day, int64_t start, bool recorded) {
    const uint32_t before = t.done[lesson]++;
    const double novice = t.is_expert ? t.talent : t.talent + (1 - t.talent) * std::exp(-static_cast<double>(before) / t.pace);
    const bool test = t.is_expert || (before >= kTestFrom && before % 2 == 0);
    AttemptInfo info = m.expert_recording.info;
    info.person = t.person.code;
    info.mode = test ? "test" : "practice";
    info.device = "swage.synthetic";
    info.synthetic = true;
    info.seed = 1 + random_() % 999999;  // six digits at most, as when a person draws one
    if (!recorded) info.files.clear();
    // the flag of a scripted hand is cleared, as the attempt represents a person; the synthetic mark is set
    for (HandInfo& h : info.hands) h.flags &= ~uint32_t{SWAGE_DEVICE_SCRIPTED};

    const std::string id = make_id();
    const AttemptEnd end = drawn_end(m, novice);
    Batch rows = attempt_rows(id, info);
    for (const Write& w : end_rows(id, info, end, 0)) rows.push_back(w);
    const std::string& session = session_of(t.person.id + " " + std::to_string(day));
    for (Write& w : rows) {
      if (w.kind == Kind::kSession) w.values[0] = session, w.values[3] = utc(start);
      if (w.kind == Kind::kAttempt) w.values[1] = session, w.values[6] = utc(start);
      if (w.kind == Kind::kEnd) w.values[0] = utc(start + static_cast<int64_t>(end.simulated_s) + 1);
      if (!record::write(to_, w)) return false;
    }
    return (!recorded || copy_chunks(m.expert_id, id)) && seal_attempt(to_, id);
  }

  AttemptEnd drawn_end(const Model& m, double novice) {
    AttemptEnd end;
    // a novice fails half of the attempts
    const bool failed = !m.failed.empty() && random_.uniform() < 0.55 * novice;
    const double share = std::clamp(novice * (1 + kNoise * normal(random_)), 0.0, 1.0);
    Mix mix;
    if (failed) {
      add_mix(mix, m.failed, 1, random_);
    } else {
      mix.emplace_back(&m.expert, 1 - share);
      add_mix(mix, m.novices, share, random_);
    }
    end.outcome = failed ? judge::Outcome::kFailed : judge::Outcome::kPassed;
    end.reason = failed ? m.failed[0].reason : m.expert.reason;
    end.score = mean(mix, [](const AttemptRow& a) { return a.score; });
    end.simulated_s = mean(mix, [](const AttemptRow& a) { return a.simulated_s; });
    for (const judge::Name& name : m.expert_recording.info.script.metrics)
      end.metric.push_back(mean(mix, [&](const AttemptRow& a) { return metric(a, name.id); }));
    end.health.executed = static_cast<uint64_t>(end.simulated_s * 1000);
    return end;
  }

  bool copy_chunks(const std::string& source, const std::string& id) {
    bool ok = true;
    const bool read = from_.each("SELECT attempt_id, stream, seq, t0_us, n, codec, crc32c, data, dictionary FROM chunk"
                                 " WHERE attempt_id = ? ORDER BY stream, seq",
                                 {source}, [&](Row row) {
                                   row[0] = id;
                                   return ok = record::write(to_, {Kind::kChunk, std::move(row)});
                                 });
    return read && ok;
  }

  const std::string& session_of(const std::string& key) {
    std::string& id = sessions_[key];
    if (id.empty()) id = make_id();
    return id;
  }

  // Limits at three tenths of the distance from expert to novice, on the metrics in which the two differ most.
  bool make_course(const std::vector<Model>& models) {
    Course course;
    course.title = "Synthetic course";
    for (const Model& m : models) {
      CourseStep step;
      step.lesson_id = m.expert.lesson_id;
      step.title = m.expert.lesson_title;
      std::vector<std::pair<double, judge::Limit>> candidates;
      for (const MetricValue& e : m.expert.metrics) {
        const MetricValue* s = find(m.novices[0], e.id);
        if (s == nullptr || s->value == e.value || !std::isfinite(s->value) || !std::isfinite(e.value)) continue;
        judge::Limit limit;
        limit.metric = e.id;
        limit.unit = e.unit;
        limit.source = "synthetic";
        (s->value > e.value ? limit.most : limit.least) = e.value + 0.3 * (s->value - e.value);
        candidates.emplace_back(std::abs(s->value - e.value) / (std::abs(s->value) + std::abs(e.value)), limit);
      }
      std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
      for (std::size_t i = 0; i < std::min<std::size_t>(3, candidates.size()); ++i) step.limits.push_back(candidates[i].second);
      if (!step.limits.empty()) step.limits[0].is_gate = true;
      course.steps.push_back(std::move(step));
    }
    Assignment task;
    task.to_group = true;
    task.who_id = group_;
    if (!school_.save_course(course)) return false;
    task.course_id = course.id;
    return school_.assign(task);
  }

  Database &to_, &from_;
  School& school_;
  const SyntheticSchool& what_;
  base::Xoshiro256 random_;
  std::vector<Trainee> trainees_;
  std::map<std::string, std::string> sessions_;
  std::string group_;
};

bool read_models(const SyntheticSchool& what, std::vector<Model>& out, std::string& error) {
  const auto store = Store::open_to_read(what.from, error);
  if (!store) return false;
  for (const SyntheticLesson& lesson : what.lessons) {
    Model m;
    m.expert_id = lesson.expert;
    if (!store->attempt(lesson.expert, m.expert) || !read_recording(what.from, lesson.expert, m.expert_recording, error)) return false;
    for (const std::string& id : lesson.novices) store->attempt(id, m.novices.emplace_back());
    for (const std::string& id : lesson.failed) store->attempt(id, m.failed.emplace_back());
    if (m.novices.empty()) return error = say::kNeedsNovice(), false;
    out.push_back(std::move(m));
  }
  if (out.empty()) error = say::kSchoolNeedsLesson();
  return !out.empty();
}

}  // namespace

bool write_synthetic_school(const std::string& where, const SyntheticSchool& what, std::string& error) {
  std::vector<Model> models;
  if (what.people == 0 || what.attempts == 0) return error = say::kSchoolNeedsPeople(), false;
  if (!read_models(what, models, error)) return false;
  const auto school = School::open(where, error);
  const auto to = school ? open_store(where.empty() ? Store::default_path() : where, error) : nullptr;
  const auto from = to ? open_for_reading(what.from, error) : nullptr;
  if (!from) return false;
  if (!to->rows("SELECT 1 FROM provenance WHERE is_synthetic = 1 LIMIT 1").empty())
    return error = say::kSyntheticAlready(shown(where)), false;
  return Writer(*to, *from, *school, what).write(models, error);
}

}  // namespace swage::record
