// SPDX-License-Identifier: Apache-2.0
//
// A lesson plugin on a small scene: one gripper, some things, a grasp coupling for each; everything it says is kept.
#pragma once

#include <deque>

#include "fake_objects.hpp"
#include "stage.hpp"

namespace swage::stage {

class LessonStage {
 public:
  /// Objects: "holder" with three bodies, then each thing with one. Grasp couplings "grasp", "grasp_2", ...
  LessonStage(const char* id, const std::vector<std::string>& things) : stage(id) {
    words_.push_back("holder");
    objects.push_back({text(words_.back()), text(words_.back()), 0, 3, 0, 0, &gripper_.raw});
    for (size_t i = 0; i < things.size(); ++i) {
      wires_.emplace_back();
      words_.push_back(things[i]);
      objects.push_back({text(words_.back()), text(words_.back()), static_cast<uint32_t>(3 + i), 1, 0, 0,
                         &wires_.back().raw});
      words_.push_back(i == 0 ? "grasp" : "grasp_" + std::to_string(i + 1));
      const swage_str owner = text(words_.back());
      for (const char* name : {"held", "force", "s", "tip_reach", "tilt_axis", "tilt_plane", "balance"}) {
        words_.push_back(std::string("grasp.") + name);
        signals.push_back({owner, text(words_.back()), {"1", 1}});
      }
      for (const char* name : {"grasp.touched", "grasp.taken", "grasp.released"}) {
        words_.push_back(name);
        events.push_back({owner, text(words_.back())});
      }
    }
    X_WB.resize(3 + things.size(), swage_pose{{0, 0, 0}, {1, 0, 0, 0}});
    signal.resize(signals.size());
    steps_.resize(objects.size());
  }

  /// One more thing with one body, which says what its traits say; not gripped by anything.
  void add_object(const char* name, swage_instance* instance) {
    words_.push_back(name);
    objects.push_back({text(words_.back()), text(words_.back()), 0, 1, 0, 0, instance});
    objects.back().first_body = static_cast<uint32_t>(X_WB.size());
    X_WB.push_back({{0, 0, 0}, {1, 0, 0, 0}});
    steps_.resize(objects.size());
  }
  /// One more coupling with its words; they follow those that are there.
  void add_coupling(const char* name, std::initializer_list<const char*> its_signals,
                    std::initializer_list<const char*> its_events) {
    words_.push_back(name);
    const swage_str owner = text(words_.back());
    for (const char* id : its_signals) signals.push_back({owner, {id, std::strlen(id)}, {"1", 1}});
    for (const char* id : its_events) events.push_back({owner, {id, std::strlen(id)}});
    signal.resize(signals.size());
  }
  /// What a signal says, by id.
  double& now(const std::string& id) {
    for (size_t i = 0; i < signals.size(); ++i)
      if (std::string(signals[i].id.data, signals[i].id.size) == id) return signal[i];
    ADD_FAILURE() << id << " is nobody's signal";
    return signal[0];
  }
  /// An event of the next step, by id.
  void happen(const std::string& id, double value = 0) {
    for (size_t i = 0; i < events.size(); ++i)
      if (std::string(events[i].id.data, events[i].id.size) == id)
        return happened.push_back({static_cast<uint32_t>(i), 0, value});
    ADD_FAILURE() << id << " is nobody's event";
  }

  swage_result bind(const Params& params = {}) {
    EXPECT_EQ(stage.configure(params), SWAGE_OK);
    table_ = &stage.table<swage_lesson>(SWAGE_EXT_LESSON);
    const swage_scene_card card{sizeof(swage_scene_card),
                                static_cast<uint32_t>(objects.size()),
                                static_cast<uint32_t>(signals.size()),
                                static_cast<uint32_t>(events.size()),
                                objects.data(),
                                signals.data(),
                                events.data(),
                                1e-3};
    swage_lesson_binder binder{sizeof(swage_lesson_binder), 0, this,
                               [](swage_lesson_binder* b, const swage_mark* mark) {
                                 auto& known = static_cast<LessonStage*>(b->host_data)->marks;
                                 known.push_back(*mark);
                                 return static_cast<uint32_t>(known.size() - 1);
                               },
                               [](swage_lesson_binder* b, const char* m) {
                                 static_cast<LessonStage*>(b->host_data)->problems.push_back(m);
                               }};
    return table_->bind(stage.raw(), &card, &binder);
  }
  void start() {
    ASSERT_EQ(stage.activate(), SWAGE_OK);
    stage.on_rt();
    state_.assign(stage.n_state, 0.0);
    table_->reset(stage.raw(), state_.data());
  }

  /// n steps of 1 ms, or until the lesson ends the attempt. Events happen in the first of them.
  void observe(int n = 1) {
    swage_verdict verdict{};
    verdict.struct_size = sizeof(verdict);
    verdict.host_data = this;
    verdict.cue = [](const swage_verdict* v, uint32_t o, uint32_t c) { of(v).cues[o] = c; };
    verdict.mark = [](const swage_verdict* v, uint32_t m, uint32_t c, const swage_vec3* p_W) {
      of(v).mark_cues[m] = c;
      if (p_W != nullptr) of(v).mark_p_W[m] = *p_W;
    };
    verdict.metric = [](const swage_verdict* v, uint32_t i, double x) { of(v).metrics[i] = x; };
    verdict.event = [](const swage_verdict* v, uint32_t e, double x) { of(v).said.push_back({e, x}); };
    verdict.phase = [](const swage_verdict* v, uint32_t p) { of(v).phase = p; };
    verdict.finish = [](const swage_verdict* v, int32_t pass, double points, uint32_t why) {
      of(v).ends += 1;
      of(v).passed = pass;
      of(v).score = points;
      of(v).reason = why;
    };
    for (int i = 0; i < n && ends == 0; ++i) {
      swage_view view{};
      view.struct_size = sizeof(view);
      view.n_body = static_cast<uint32_t>(X_WB.size());
      view.n_signal = static_cast<uint32_t>(signal.size());
      view.time_s = 1e-3 * step_++;
      view.dt_s = 1e-3;
      view.X_WB = X_WB.data();
      view.signal = signal.data();
      view.event = happened.data();
      view.n_event = static_cast<uint32_t>(happened.size());
      view.object_step = steps_.data();
      view.n_object = static_cast<uint32_t>(steps_.size());
      ASSERT_EQ(table_->observe(stage.raw(), &view, &verdict, state_.data()), SWAGE_OK);
      happened.clear();
    }
  }
  /// Thing i is touched and taken in the next step, and held from then on.
  void hold(uint32_t i, double s, double force) {
    happened.push_back({3 * i, 0, 0});
    happened.push_back({3 * i + 1, 0, 0});
    const double now[] = {1, force, s, 1e-3, 0, 0, 0};
    std::copy(std::begin(now), std::end(now), signal.begin() + 7 * i);
  }
  void let_go(uint32_t i) { std::fill_n(signal.begin() + 7 * i, 2, 0.0); }

  double metric(const char* id) { return metrics[stage.index_of(SWAGE_DECLARE_METRIC, id)]; }
  uint32_t cue(const char* id) { return stage.index_of(SWAGE_DECLARE_CUE, id); }

  Stage stage;
  std::vector<swage_scene_object> objects;
  std::vector<swage_scene_signal> signals;
  std::vector<swage_scene_event> events;
  std::vector<swage_pose> X_WB;
  std::vector<double> signal;
  std::vector<swage_view_event> happened;
  // what it said
  std::vector<swage_mark> marks;
  std::vector<std::string> problems;
  std::map<uint32_t, uint32_t> cues;  // by object
  std::map<uint32_t, uint32_t> mark_cues;
  std::map<uint32_t, swage_vec3> mark_p_W;
  std::map<uint32_t, double> metrics;
  std::vector<Said> said;
  uint32_t phase = SWAGE_NONE, reason = SWAGE_NONE;
  int ends = 0, passed = -1;
  double score = -1;

 protected:
  FakeGripper gripper_;

 private:
  static LessonStage& of(const swage_verdict* v) { return *static_cast<LessonStage*>(v->host_data); }
  static swage_str text(const std::string& words) { return {words.data(), words.size()}; }

  std::deque<FakeWire> wires_;
  std::deque<std::string> words_;
  const swage_lesson* table_ = nullptr;
  std::vector<swage_object_step> steps_;
  std::vector<double> state_;
  int step_ = 0;
};

}  // namespace swage::stage
