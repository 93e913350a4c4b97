// SPDX-License-Identifier: Apache-2.0
//
// swage.lesson.look: observes for a set time, measures the signals that its parameters name, and judges nothing. For trying an object, a
// coupling or a device, and for demonstrations.
#include <swage/lesson.hpp>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "sentences.hpp"

namespace swage::lesson_look {

struct LookParams {
  double duration = 2;   // s
  std::string measures;  // "owner signal unit, ..."
};

/// One signal whose greatest value is a metric.
struct Measure {
  std::string owner, id, unit;
  Signal signal;
  Metric metric;
};

/// "needle needle.stress 1, press contact.force N"; an entry without three words has an empty unit.
std::vector<Measure> read(const std::string& text) {
  std::vector<Measure> out;
  std::istringstream all(text);
  for (std::string one; std::getline(all, one, ',');) {
    std::istringstream words(one);
    Measure m;
    std::string more;
    words >> m.owner >> m.id >> m.unit;
    if (words >> more) m.unit.clear();
    out.push_back(std::move(m));
  }
  return out;
}

class Look final : public Lesson<LookParams> {
 public:
  static constexpr auto id = "swage.lesson.look", version = "1.1.0", name = "Look",
                        summary = "Looks on for a while and judges nothing; always passes.", author = "Swage",
                        licence = "Apache-2.0";
  static constexpr swage_criterion criteria[] = {
      {"Watch for {duration}. Nothing is judged.", nullptr, SWAGE_CRITERION_SHOW, 0}};
  static constexpr std::array fields = {
      real<&LookParams::duration>("duration", "Duration", "s", "s", 1e-3, 36000,
                                  "Simulated time to the end."),
      text<&LookParams::measures>(
          "measures", "Measures",
          "Signals whose greatest value becomes a metric, each as owner, signal and unit: \"needle "
          "needle.stress 1, press contact.force N\"."),
  };

  void build(const LookParams& params, Builder& builder) override {
    time_ = builder.metric("time.task", "s", "Simulated time that was looked at.");
    looking_ = builder.phase("look", "Watch what happens.");
    measures_ = read(params.measures);
    for (Measure& m : measures_) {
      if (m.unit.empty())
        builder.error("measures", say::kThreeWords());
      else
        m.metric = builder.metric(metric_id(m).c_str(), m.unit.c_str(), "Greatest value of this signal.");
    }
    if (!measures_.empty()) builder.state(static_cast<uint32_t>(measures_.size()));
  }

  void bind(const Scene& scene, Binder& binder) override {
    for (Measure& m : measures_) {
      m.signal = scene.find_signal(m.owner, m.id);
      if (!m.signal.valid()) {
        binder.missing(scene, "signal", m.owner, m.id, say::kNamed());
      } else if (view(scene->signal[m.signal].unit) != m.unit) {
        binder.error(say::kOtherUnit(m.id, view(scene->signal[m.signal].unit), m.unit));
      }
    }
  }

  /// Id of the signal; preceded by the owner if two owners have that signal.
  std::string metric_id(const Measure& m) const {
    const auto same = [&m](const Measure& other) { return other.id == m.id; };
    return std::count_if(measures_.begin(), measures_.end(), same) > 1 ? m.owner + "." + m.id : m.id;
  }

  void observe(const View& view, const Verdict& verdict, std::span<double> state) override {
    verdict.phase(looking_);
    verdict.metric(time_, view.time());
    for (size_t i = 0; i < measures_.size(); ++i) {
      state[i] = std::max(state[i], view.signal(measures_[i].signal));
      verdict.metric(measures_[i].metric, state[i]);
    }
    if (view.time() >= params().duration) verdict.pass(100);
  }

 private:
  Metric time_;
  Phase looking_;
  std::vector<Measure> measures_;
};

}  // namespace swage::lesson_look

SWAGE_EXPORT(swage::lesson_look::Look)
