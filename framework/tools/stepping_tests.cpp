// SPDX-License-Identifier: Apache-2.0
#include "tools/stepping_tests.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "base/rng.hpp"
#include "assembly/lesson_file.hpp"
#include "tools/extension_tests.hpp"
#include "tools/fuzz_harness.hpp"
#include "tools/print.hpp"
#include "tools/sentences.hpp"
#include "tools/test_scene.hpp"

namespace swage::tools {
namespace {

using host::Finding;
using host::Mark;
using host::PluginInfo;
using host::Subject;

Finding failed(const std::string& text) { return {Mark::kFailed, text}; }
Finding skipped(const std::string& text) { return {Mark::kSkipped, text}; }

// Sum of kinetic and potential energy of the dynamic bodies [J].
double energy(const scene::World& w, double& kinetic) {
  double potential = 0;
  kinetic = 0;
  for (std::size_t i = 0; i < w.body.size(); ++i) {
    const scene::BodyInfo& b = w.body[i];
    if (b.motion != SWAGE_MOTION_DYNAMIC) continue;
    const swage_twist& V = w.V_WB[i];
    const swage_quat& q = w.X_WB[i].q;
    // angular velocity in B: the vector part of conj(q) w q
    const auto in_body = [&q](const swage_vec3& v) {
      const swage_vec3 u{-q.x, -q.y, -q.z};
      const swage_vec3 t{2 * (u.y * v.z - u.z * v.y), 2 * (u.z * v.x - u.x * v.z),
                         2 * (u.x * v.y - u.y * v.x)};
      return swage_vec3{v.x + q.w * t.x + u.y * t.z - u.z * t.y, v.y + q.w * t.y + u.z * t.x - u.x * t.z,
                        v.z + q.w * t.z + u.x * t.y - u.y * t.x};
    };
    const swage_vec3 w_B = in_body(V.w);
    kinetic +=
        0.5 * b.mass * (V.v.x * V.v.x + V.v.y * V.v.y + V.v.z * V.v.z) +
        0.5 * (b.inertia[0] * w_B.x * w_B.x + b.inertia[1] * w_B.y * w_B.y + b.inertia[2] * w_B.z * w_B.z);
    const swage_vec3 &g = w.gravity, &p = w.X_WB[i].p;
    potential -= b.mass * (g.x * p.x + g.y * p.y + g.z * p.z);
  }
  return kinetic + potential;
}

// level 4: ten seconds with defaults
Finding stepping(const TestScene& scene, uint64_t) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return failed(error);
  double kinetic = 0, most = 0;
  const double start = energy(s.engine->world(), kinetic);
  for (int i = 0; i < 10'000; ++i) {
    s.engine->step();
    if (const std::string fault = s.fault(); !fault.empty()) return failed(fault);
    const double now = energy(s.engine->world(), kinetic);
    most = std::max(most, kinetic);
    // tolerance: 1e-6 of the kinetic energy, a thousand times the error of rounding and integration in ten seconds of free fall
    const bool free =
        s.rig->world.hinge.empty() && scene.plugin().kind == SWAGE_KIND_OBJECT && !scene.of_lesson();
    if (free && now - start > 1e-6 * most)
      return failed(
          say::kEnergy(format("%.3g", now - start), i));
  }
  for (const double x : s.rig->world.plugin_state)
    if (std::fpclassify(x) == FP_SUBNORMAL)
      return {Mark::kWarning,
              say::kSubnormal()};
  return {};
}

// level 5: the saved state determines the following steps
Finding rewind(const TestScene& scene, uint64_t seed) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return failed(error);
  base::Xoshiro256 random(seed);
  std::vector<std::byte> image(s.engine->image_size()), first(image.size()), second(image.size());
  for (int round = 0; round < 5; ++round) {
    if (const std::string fault = s.run(10 + random() % 100); !fault.empty()) return failed(fault);
    s.engine->save(image);
    s.run(50);
    const uint64_t hash = s.engine->hash(), step = s.engine->world().step;
    s.engine->save(first);
    if (!s.engine->restore(image)) return failed(say::kNotRestored());
    s.run(50);
    s.engine->save(second);
    if (s.engine->hash() != hash || first != second)
      return failed(say::kRewinds(step - 50));
  }
  return {};
}

// level 5: a second run, and a run with a second instance, give the same bits
Finding alone(const TestScene& scene, uint64_t) {
  const bool object = scene.plugin().kind == SWAGE_KIND_OBJECT;
  Stepped a, b, c;
  std::string error;
  Wish crowded;
  crowded.with_neighbour = object && !scene.of_lesson();
  if (!scene.make({}, a, error) || !scene.make({}, b, error) || !scene.make(crowded, c, error))
    return failed(error);
  for (int i = 0; i < 500; ++i) {
    a.engine->step();
    b.engine->step();
    c.engine->step();
    if (a.engine->hash() != b.engine->hash())
      return failed(say::kTwoRuns(i));
    if (object && a.engine->object_hash(scene.subject({})) != c.engine->object_hash(scene.subject(crowded)))
      return failed(say::kNotAlone(i));
  }
  return {};
}

// level 6: a translated scene has the same motion
Finding moved(const TestScene& scene, uint64_t) {
  if (scene.of_lesson()) return skipped(say::kLessonPlaces());
  Stepped here, there;
  std::string error;
  Wish away;
  away.at = {0.1, -0.1, 0.1};  // less than the thousand scene lengths that limit all positions
  if (!scene.make({}, here, error) || !scene.make(away, there, error)) return failed(error);
  for (int i = 0; i < 200; ++i) {
    here.engine->step();
    there.engine->step();
  }
  // rounding at 1 m is 1e-16 m per step; a millionth of the scene's length is far above that and too small to be visible
  const double tolerance = 1e-6 * here.rig->world.length;
  const scene::World &a = here.engine->world(), &b = there.engine->world();
  for (std::size_t i = 0; i < a.X_WB.size(); ++i) {
    const swage_vec3 &p = a.X_WB[i].p, &q = b.X_WB[i].p;
    const double off = std::max({std::abs(q.x - p.x - 0.1), std::abs(q.y - p.y + 0.1), std::abs(q.z - p.z - 0.1)});
    if (!(off < tolerance))
      return failed(say::kFrames(a.body[i].name, format("%.3g", off)));
  }
  return {};
}

// random value of a parameter as JSON; `at` gives places in its range, 0..1
nlohmann::json value_at(const host::Param& p, const std::function<double()>& at) {
  const auto between = [&] { return p.min + (p.max - p.min) * at(); };
  switch (p.type) {
    case SWAGE_PARAM_REAL:
      return std::clamp(between(), p.min, p.max);
    case SWAGE_PARAM_INTEGER:
      return static_cast<int64_t>(std::llround(between()));
    case SWAGE_PARAM_BOOL:
      return at() >= 0.5;
    case SWAGE_PARAM_CHOICE: {
      const auto n = static_cast<double>(p.choices.size());
      return p.choices[static_cast<std::size_t>(std::min(n - 1, std::floor(at() * n)))];
    }
    case SWAGE_PARAM_VECTOR: {
      auto list = nlohmann::json::array();
      for (uint32_t i = 0; i < p.dimension; ++i) list.push_back(std::clamp(between(), p.min, p.max));
      return list;
    }
    default:
      return nullptr;  // texts and files keep their defaults
  }
}

std::string try_params(const TestScene& scene, const nlohmann::json& params) {
  Stepped s;
  std::string error;
  Wish wish;
  wish.params = params.dump();
  if (!scene.make(wish, s, error)) return error.empty() ? say::kRefusedSilently() : "";
  return s.run(20);
}

// level 6: any value within a parameter's range gives a reported error or a good run
Finding range(const TestScene& scene, uint64_t seed) {
  base::Xoshiro256 random(seed);
  const host::ParamTable& table = scene.plugin().params;
  const auto check = [&](const nlohmann::json& params) -> Finding {
    const std::string fault = try_params(scene, params);
    return fault.empty() ? Finding{} : failed(fault + say::kParameters(params.dump()));
  };
  for (const host::Param& p : table)
    for (const double end : {0.0, 1.0}) {
      const nlohmann::json value = value_at(p, [end] { return end; });
      if (value.is_null()) continue;
      if (Finding f = check({{p.id, value}}); f.mark != Mark::kSuccess) return f;
    }
  for (int trial = 0; trial < 200 && !table.empty(); ++trial) {
    nlohmann::json params = nlohmann::json::object();
    for (const host::Param& p : table)
      if (const nlohmann::json value = value_at(p, [&] { return random.uniform(); }); !value.is_null())
        params[p.id] = value;
    if (Finding f = check(params); f.mark != Mark::kSuccess) {
      f.text += say::kSeed(seed);
      return f;
    }
  }
  return {};
}

// level 8: processor time of a step; never more than a warning, because it depends on the machine
Finding time(const TestScene& scene, uint64_t) {
  Stepped s;
  std::string error;
  if (!scene.make({}, s, error)) return failed(error);
  std::vector<double> ms;
  for (int i = 0; i < 5'000; ++i) {
    const int64_t before = base::cpu_ns();
    s.engine->step();
    ms.push_back(1e-6 * static_cast<double>(base::cpu_ns() - before));
  }
  std::sort(ms.begin(), ms.end());
  const double p99 = ms[ms.size() * 99 / 100];
  const auto told = [](double value_ms) { return format("%.4f", value_ms); };
  const std::string text = say::kStepTakes(told(ms[ms.size() / 2]), told(p99), told(ms.back()));
  // a fifth of the step's budget for one plugin alone
  return {p99 > 0.2 ? Mark::kWarning : Mark::kSuccess, text};
}

// a hand with any faulty sample but those with NaN or infinity, which would be a fault of the device
class WildHand final : public step::DevicePort {
 public:
  explicit WildHand(uint64_t seed) : random_(seed) {}
  void read(uint64_t, double time_s, swage_sample& sample) noexcept override {
    if (random_() % 4 == 0) return;  // nothing new
    double x[15];
    for (double& number : x) number = wild();
    sample.sequence += random_() % 3;
    sample.time_s = random_() % 8 == 0 ? wild() : time_s;
    sample.pose = {{x[0], x[1], x[2]}, {x[3], x[4], x[5], x[6]}};
    sample.twist = {{x[7], x[8], x[9]}, {x[10], x[11], x[12]}};
    sample.closure = x[13];
    sample.grip_force = x[14];
    sample.buttons = static_cast<uint32_t>(random_());
    sample.valid = static_cast<uint32_t>(random_()) & ~SWAGE_VALID_DONE;
  }
  void send(const step::ToolForce&) noexcept override {}

 private:
  double wild() noexcept {
    switch (random_() % 16) {
      case 0:
        return 0;
      case 1:
        return 900;  // m: far outside the scene
      case 2:
        return -10;
      case 3:
        return std::numeric_limits<double>::denorm_min();
      default:
        return 1e-2 * (random_.uniform() - 0.5);
    }
  }
  base::Xoshiro256 random_;
};

// level 9: for any samples of the hand the world stays finite
Finding fuzz(const TestScene& scene, uint64_t seed) {
  if (!scene.is_led()) return skipped(say::kHandsOff());
  WildHand hand(seed);
  Wish wish;
  wish.hand = &hand;
  Stepped s;
  std::string error;
  if (!scene.make(wish, s, error)) return failed(error);
  const std::string fault = s.run(5'000);
  return fault.empty() ? Finding{}
                       : failed(fault + say::kSeed(seed));
}

using Test = Finding (*)(const TestScene&, uint64_t);

// the worst finding of a test over the plugins of a library
Finding of_all(const Subject& subject, const std::vector<std::string>& plugin_dirs, const std::string& with, Test test,
               uint32_t kinds) {
  host::Catalogue::Options options;
  options.plugin_dirs = plugin_dirs;
  options.plugin_dirs.insert(options.plugin_dirs.begin(),
                             std::filesystem::path(subject.library_path).parent_path().string());
  const host::Catalogue catalogue(options);
  assembly::LessonFile lesson;
  base::Problems problems;
  if (!with.empty() && !assembly::read_lesson_file(with, lesson, problems))
    return failed(say::kNoScene(with, problems.empty() ? "" : problems[0].message));
  Finding worst{Mark::kSkipped, ""};
  bool any = false;
  for (const PluginInfo& p : subject.plugins) {
    if ((kinds & host::kind_bit(p.kind)) == 0) continue;
    const PluginInfo* plugin = catalogue.find(p.id);
    if (plugin == nullptr) return failed(catalogue.missing_text(p.id));
    const TestScene scene = with.empty() ? TestScene(*plugin, catalogue) : TestScene(*plugin, catalogue, lesson);
    Finding f = skipped(scene.skipped());
    if (scene.on_thread() && test != driver)
      f = skipped(say::kOwnThread());
    else if (scene.skipped().empty())
      f = test(scene, subject.seed);
    if (subject.plugins.size() > 1 && !f.text.empty()) f.text = p.id + ": " + f.text;
    // "skipped" counts only if no plugin was tested
    const bool worse =
        !any || worst.mark == Mark::kSkipped || (f.mark != Mark::kSkipped && f.mark > worst.mark);
    if (worse) worst = f;
    any = true;
  }
  return worst;
}

}  // namespace

std::vector<host::ValidateTest> stepping_tests(const std::vector<std::string>& plugin_dirs, const std::string& with) {
  struct Entry {
    uint32_t level;
    const char *name, *asks;
    Test test;
    uint32_t kinds;
  };
  constexpr uint32_t kObject = host::kind_bit(SWAGE_KIND_OBJECT),
                     kCoupling = host::kind_bit(SWAGE_KIND_COUPLING),
                     kLesson = host::kind_bit(SWAGE_KIND_LESSON), kDevice = host::kind_bit(SWAGE_KIND_DEVICE);
  static constexpr Entry kTests[] = {
      {4, "stepping", "10 000 steps with defaults: every number finite, no energy out of nothing", stepping,
       host::kAllKinds},
      // not for devices: their state is outside the host
      {5, "rewind", "the same steps again after restoring the saved state: the same bytes", rewind,
       kObject | kCoupling | kLesson},
      {5, "alone", "the same bits in a second run, and with another instance in the scene", alone,
       kObject | kCoupling | kLesson},
      {5, "solver", "the solver's answers: symmetric, no energy out of nothing, the same bits again, and kept", solver, kObject},
      {5, "drawing", "what it draws beside its shapes: within its room, sensible, and it changes nothing", drawing, kObject},
      {5, "traits", "what its traits answer, near, far and beyond its ends", traits, kObject},
      {5, "driver", "opens and closes again and again on a thread of its own, measures forwards, comes back in time", driver,
       kDevice},
      {5, "sight", "what a hand that sees makes of its scene, and of one that lies elsewhere: finite, unit, the same bits again",
       sight, kDevice},
      // not for couplings and lessons: contacts amplify rounding, so that positions may differ
      {6, "moved", "the scene 0.1 m away: the same motion", moved, kObject},
      {6, "range", "every parameter at its ends and 200 random sets: an error that is told, or a good run",
       range, host::kAllKinds},
      {6, "fuzz_values",
       "2000 steps of a world in which nothing belongs together: behaves, remembers nothing, forgets",
       fuzz_values, kCoupling | kLesson},
      // objects have that of the host
      {7, "real_time", "no allocation in the step", real_time, kCoupling | kLesson},
      {7, "waits", "1000 steps by the clocks of a paced run: no sleep or wait in them", waits, kObject | kCoupling | kLesson},
      {8, "time", "processor time of a step", time, host::kAllKinds},
      {9, "fuzz", "5000 steps led by a hand that sends random values", fuzz, kObject | kCoupling | kLesson},
  };
  std::vector<host::ValidateTest> out;
  for (const Entry& e : kTests)
    out.push_back({e.level, e.name, e.asks,
                   [plugin_dirs, with, test = e.test, kinds = e.kinds](const Subject& s) {
                     return of_all(s, plugin_dirs, with, test, kinds);
                   },
                   e.kinds});
  return out;
}

}  // namespace swage::tools
