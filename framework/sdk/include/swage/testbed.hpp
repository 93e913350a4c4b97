// SPDX-License-Identifier: Apache-2.0
//
// A minimal host for unit tests of a plugin: no scene, no contacts, no clock. A bench makes one instance of a plugin, calls it
// through the same C tables as the host does, and records all that it reports.
//
//   swage::testbed::ObjectBench<Clip> bench;
//   bench.set("stiffness", 2);
//   bench.start();
//   bench.pose[0].p.x += 1e-3;
//   bench.forces();
//   CHECK(bench.wrench[0].f.x < 0);
//
// `swage validate` tests a plugin in a scene.
#pragma once

#include <swage/coupling.hpp>
#include <swage/device.hpp>
#include <swage/lesson.hpp>
#include <swage/object.hpp>
#include <swage/testbed/bench.hpp>

#include <string>
#include <utility>
#include <vector>

namespace swage::testbed {

/// An object with its arrays; bodies are at their declared poses, O at the origin of the world.
template <class T>
class ObjectBench : public Bench<T> {
 public:
  std::vector<swage_pose> pose;
  std::vector<swage_twist> twist;
  std::vector<swage_wrench> wrench;
  std::vector<double> particle_p, particle_v, particle_f;  // 3 n
  std::vector<double> hinge_angle, hinge_rate, hinge_torque;
  std::vector<swage_drive> drive;
  std::vector<double> state, signal;
  swage_input input{kIdentity, 0, 0, 0, 0};  // of a device; passed to the object once `input.valid` is not 0
  swage_object_step step{};

  /// configure, activate, reset. False when the plugin refused; see declared.errors and host.reports.
  bool start(double dt_s = 1e-3) {
    if (this->configure() < 0) return false;
    const Declared& d = this->declared;
    for (const auto& body : d.bodies) pose.push_back(body.X_OB);
    twist.resize(pose.size());
    wrench.resize(pose.size());
    particle_p = d.particles;
    particle_v.resize(particle_p.size());
    particle_f.resize(particle_p.size());
    hinge_angle.resize(d.hinges.size());
    hinge_rate.resize(d.hinges.size());
    hinge_torque.resize(d.hinges.size());
    drive.resize(d.hinges.size());
    state.resize(d.n_state);
    signal.resize(d.count(SWAGE_DECLARE_SIGNAL));
    if (this->activate(dt_s) < 0) return false;
    this->host.role = SWAGE_THREAD_RT;
    step.dt_s = dt_s;
    object()->reset(this->raw, fill());
    return true;
  }
  /// Clears the forces added before, then calls forces().
  swage_result forces() {
    wrench.assign(wrench.size(), {});
    particle_f.assign(particle_f.size(), 0);
    return object()->forces(this->raw, fill());
  }
  swage_result finish() { return object()->finish(this->raw, fill()); }
  /// Calls draw() of an object with Drawing; the list is in `drawn`.
  swage_result draw() { return this->draw_with(fill(), nullptr); }

  /// The step, pointing at the arrays above.
  const swage_object_step* fill() {
    step.struct_size = sizeof step;
    step.scene_length = 1e-3;
    step.input = input.valid != 0 ? &input : nullptr;
    step.X_WB = pose.data();
    step.V_WB = twist.data();
    step.F_B_W = wrench.data();
    step.particle_p_W = particle_p.data();
    step.particle_v_W = particle_v.data();
    step.particle_f_W = particle_f.data();
    step.hinge_angle = hinge_angle.data();
    step.hinge_rate = hinge_rate.data();
    step.hinge_torque = hinge_torque.data();
    step.drive = drive.data();
    step.state = state.data();
    step.signal = signal.data();
    step.n_body = static_cast<uint32_t>(pose.size());
    step.n_particle = static_cast<uint32_t>(particle_p.size() / 3);
    step.n_hinge = static_cast<uint32_t>(drive.size());
    step.n_state = static_cast<uint32_t>(state.size());
    step.n_signal = static_cast<uint32_t>(signal.size());
    return &step;
  }

 private:
  const swage_object* object() const { return this->template get<swage_object>(SWAGE_EXT_OBJECT); }
};

/// A coupling between two objects without bodies; the test fills `contacts`.
template <class T>
class CouplingBench : public Bench<T> {
 public:
  std::vector<swage_contact> contacts;
  std::vector<double> state, signal;
  std::vector<std::pair<uint32_t, double>> events;  // index, value
  std::vector<swage_tie> ties;
  swage_object_step a{}, b{};
  swage_coupling_step step{};

  bool start(swage_instance* object_a, swage_instance* object_b, double dt_s = 1e-3) {
    if (this->configure() < 0 || table()->bind(this->raw, object_a, object_b) < 0) return false;
    state.resize(this->declared.n_state);
    signal.resize(this->declared.count(SWAGE_DECLARE_SIGNAL));
    if (this->activate(dt_s) < 0) return false;
    this->host.role = SWAGE_THREAD_RT;
    step.dt_s = dt_s;
    table()->reset(this->raw, fill());
    return true;
  }
  swage_result resolve() { return table()->resolve(this->raw, fill()); }
  /// Calls ties() of a coupling with Ties; the result is in `ties`. Set their f_a_W and plastic_slip_W before on_solved().
  swage_result ask_ties(uint32_t capacity = 64) {
    uint32_t n = 0;
    ties.assign(capacity, {});
    const swage_result result = links()->ties(this->raw, fill(), capacity, ties.data(), &n);
    ties.resize(n);
    return result;
  }
  swage_result on_solved() {
    return links()->on_solved(this->raw, fill(), static_cast<uint32_t>(ties.size()), ties.data());
  }
  swage_result finish() { return table()->finish(this->raw, fill()); }
  /// Calls draw() of a coupling with DrawingOnB; the list is in `drawn`.
  swage_result draw() { return this->draw_with(nullptr, fill()); }

 private:
  const swage_coupling* table() const { return this->template get<swage_coupling>(SWAGE_EXT_COUPLING); }
  const swage_ties* links() const { return this->template get<swage_ties>(SWAGE_EXT_TIES); }
  const swage_coupling_step* fill() {
    step.struct_size = sizeof step;
    step.n_contact = static_cast<uint32_t>(contacts.size());
    step.a = &a;
    step.b = &b;
    step.contact = contacts.data();
    step.state = state.data();
    step.signal = signal.data();
    step.n_state = static_cast<uint32_t>(state.size());
    step.n_signal = static_cast<uint32_t>(signal.size());
    step.host_data = this;
    step.event = [](const swage_coupling_step* s, uint32_t event, double value) {
      static_cast<CouplingBench*>(s->host_data)->events.emplace_back(event, value);
    };
    return &step;
  }
};

/// A device whose exchange() the test calls.
template <class T>
class DeviceBench : public Bench<T> {
 public:
  swage_command command{};
  swage_sample sample{};

  bool start(double dt_s = 1e-3) {
    if (this->configure() < 0 || this->activate(dt_s) < 0 || table()->open(this->raw) < 0) return false;
    this->host.role = (table()->flags & SWAGE_DEVICE_LOCKSTEP) != 0 ? SWAGE_THREAD_RT : SWAGE_THREAD_IO;
    return true;
  }
  /// Calls exchange() at a simulated time; the result is in `sample`.
  swage_result exchange(double time_s) {
    command.time_s = time_s;
    return table()->exchange(this->raw, &command, &sample);
  }

 private:
  const swage_device* table() const { return this->template get<swage_device>(SWAGE_EXT_DEVICE); }
};

/// A lesson that watches a scene of named objects with one body each.
template <class T>
class LessonBench : public Bench<T> {
 public:
  std::vector<std::string> objects;                          // names; set before start()
  std::vector<std::pair<std::string, std::string>> signals;  // owner, id; set before start()
  std::vector<swage_pose> pose;                              // of each object
  std::vector<double> signal;
  std::vector<double> state;
  std::vector<std::string> errors;  // of bind()
  std::vector<uint32_t> cue;        // of each object, kNone for none
  std::vector<double> metric;
  uint32_t phase = kNone, n_mark = 0;
  bool finished = false, passed = false;
  double score = 0;
  uint32_t reason = kNone;
  double time_s = 0, dt_s = 1e-3;

  bool start() {
    if (this->configure() < 0) return false;
    cue.assign(objects.size(), kNone);
    pose.assign(objects.size(), kIdentity);
    twist_.assign(objects.size(), {});
    signal.resize(signals.size());
    metric.resize(this->declared.count(SWAGE_DECLARE_METRIC));
    state.resize(this->declared.n_state);
    if (!bind() || this->activate(dt_s) < 0) return false;
    this->host.role = SWAGE_THREAD_RT;
    table()->reset(this->raw, state.data());
    return true;
  }
  /// Calls observe() with the present scene.
  swage_result observe() {
    swage_view view{};
    view.struct_size = sizeof view;
    view.n_body = view.n_object = static_cast<uint32_t>(pose.size());
    view.n_signal = static_cast<uint32_t>(signal.size());
    view.time_s = time_s;
    view.dt_s = dt_s;
    view.X_WB = pose.data();
    view.V_WB = twist_.data();
    view.signal = signal.data();
    time_s += dt_s;
    const swage_verdict verdict = hear();
    return table()->observe(this->raw, &view, &verdict, state.data());
  }

 private:
  const swage_lesson* table() const { return this->template get<swage_lesson>(SWAGE_EXT_LESSON); }
  static LessonBench& of(const swage_verdict* verdict) {
    return *static_cast<LessonBench*>(verdict->host_data);
  }

  bool bind() {
    std::vector<swage_scene_object> object;
    for (uint32_t i = 0; i < objects.size(); ++i)
      object.push_back({str(objects[i]), str(""), i, 1, 0, 0, nullptr});
    std::vector<swage_scene_signal> offered;
    for (const auto& [owner, id] : signals) offered.push_back({str(owner), str(id), str("1")});
    const swage_scene_card card{sizeof(swage_scene_card),
                                static_cast<uint32_t>(object.size()),
                                static_cast<uint32_t>(offered.size()),
                                0,
                                object.data(),
                                offered.data(),
                                nullptr,
                                1e-3};
    swage_lesson_binder binder{sizeof(swage_lesson_binder), 0, this, nullptr, nullptr};
    binder.mark = [](swage_lesson_binder* b, const swage_mark*) {
      return static_cast<LessonBench*>(b->host_data)->n_mark++;
    };
    binder.error = [](swage_lesson_binder* b, const char* message) {
      static_cast<LessonBench*>(b->host_data)->errors.push_back(message);
    };
    return table()->bind(this->raw, &card, &binder) >= 0;
  }

  swage_verdict hear() {
    swage_verdict v{};
    v.struct_size = sizeof v;
    v.host_data = this;
    v.cue = [](const swage_verdict* s, uint32_t object, uint32_t index) { of(s).cue.at(object) = index; };
    v.mark = [](const swage_verdict*, uint32_t, uint32_t, const swage_vec3*) {};
    v.metric = [](const swage_verdict* s, uint32_t index, double value) { of(s).metric.at(index) = value; };
    v.event = [](const swage_verdict*, uint32_t, double) {};
    v.phase = [](const swage_verdict* s, uint32_t index) { of(s).phase = index; };
    v.finish = [](const swage_verdict* s, int32_t pass, double points, uint32_t why) {
      of(s).finished = true;
      of(s).passed = pass != 0;
      of(s).score = points;
      of(s).reason = why;
    };
    return v;
  }

  std::vector<swage_twist> twist_;
};

}  // namespace swage::testbed
