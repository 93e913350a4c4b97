// SPDX-License-Identifier: Apache-2.0
//
// A stage for one plugin: plays the host just far enough to configure an instance, keep what it declares, and call it. The
// plugin's sources are compiled into the test, and everything goes through the boundary as with a real host.
#pragma once

#include <gtest/gtest.h>
#include <swage/abi/coupling.h>
#include <swage/abi/device.h>
#include <swage/abi/display.h>
#include <swage/abi/lesson.h>

#include <array>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "toolkit/math.hpp"

extern "C" const swage_entry swage_plugin_entry;

namespace swage::stage {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// What a test gives for a parameter.
struct Given {
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  Given(Number x) : value(static_cast<double>(x)) {}  // NOLINT: reads better in tables of parameters
  Given(std::vector<double> list) : value(std::move(list)) {}
  Given(std::string words) : value(std::move(words)) {}
  std::variant<double, std::vector<double>, std::string> value;
};
using Params = std::map<std::string, Given>;

struct DeclaredBody {
  int32_t motion;
  swage_pose X_OB;
  swage_mass mass;
  std::string name;
};
struct DeclaredConvex {
  uint32_t body;
  std::vector<double> vertex;
  std::vector<uint32_t> face_start, face_vertex;
};
struct DeclaredShape {
  int32_t kind;
  uint32_t body, flags;
  swage_vec3 a, b;
  double radius;
};
struct Said {
  uint32_t event;
  double value;
};

/// One instance of one plugin.
class Stage {
 public:
  explicit Stage(const char* id, uint64_t seed = 1) : random_(seed) {
    host_ = {sizeof(swage_host), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0, this, find, report, fault, kind, bits};
    const auto* factory =
        static_cast<const swage_factory*>(swage_plugin_entry.get_factory(SWAGE_FACTORY_INSTANCES));
    const auto* params =
        static_cast<const swage_param_factory*>(swage_plugin_entry.get_factory(SWAGE_FACTORY_PARAMS));
    instance_ = factory->create(&host_, id);
    table_ = params->table(id, &n_param_);
    fill_builder();
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() {
    thread_ = SWAGE_THREAD_MAIN;
    if (instance_ == nullptr) return;
    if (active_) instance_->deactivate(instance_);
    instance_->destroy(instance_);
  }

  /// Defaults, with what the test gives instead. Unknown names fail the test.
  swage_result configure(const Params& given = {}) {
    std::vector<swage_value> values(n_param_);
    size_t used = 0;
    for (uint32_t i = 0; i < n_param_; ++i) {
      std::copy(table_[i].default_number, table_[i].default_number + 4, values[i].number);
      if (table_[i].default_text != nullptr) values[i].text = text(table_[i].default_text);
      const auto found = given.find(table_[i].id);
      if (found == given.end()) continue;
      ++used;
      if (const auto* number = std::get_if<double>(&found->second.value)) values[i].number[0] = *number;
      if (const auto* list = std::get_if<std::vector<double>>(&found->second.value)) {
        std::copy(list->begin(), list->end(), values[i].number);
      }
      if (const auto* words = std::get_if<std::string>(&found->second.value)) {
        values[i].text = {words->data(), words->size()};
      }
    }
    EXPECT_EQ(used, given.size()) << "a parameter of the test is not in the table";
    const swage_values all{sizeof(swage_values), n_param_, values.data(), text("subject")};
    return instance_->configure(instance_, &all, &builder_);
  }
  swage_result activate(double dt = 1e-3) {
    const swage_result result = instance_->activate(instance_, dt);
    active_ = result >= 0;
    return result;
  }
  void on_main() { thread_ = SWAGE_THREAD_MAIN; }
  void on_rt() { thread_ = SWAGE_THREAD_RT; }

  template <class Table>
  const Table& table(const char* id) {
    const auto* found = static_cast<const Table*>(instance_->get_extension(instance_, id));
    EXPECT_NE(found, nullptr) << id;
    return *found;
  }
  swage_instance* raw() { return instance_; }

  uint32_t index_of(int32_t what, const std::string& id) const {
    const auto& names = declared.at(what);
    for (uint32_t i = 0; i < names.size(); ++i) {
      if (names[i] == id) return i;
    }
    ADD_FAILURE() << id << " is not declared";
    return SWAGE_NONE;
  }

  // what was declared and reported
  std::vector<DeclaredBody> bodies;
  std::vector<DeclaredShape> shapes;
  std::vector<swage_arc> arcs;
  std::vector<DeclaredConvex> convexes;
  std::vector<swage_hinge> hinges;
  std::map<int32_t, std::vector<std::string>> declared;
  std::vector<std::string> errors, reports;
  uint32_t n_state = 0;
  int faults = 0;
  const void* pointer_table = nullptr;  // answer to SWAGE_HOST_POINTER
  int32_t eyes = SWAGE_EYES_NONE;       // answer of SWAGE_HOST_DISPLAY

 private:
  static swage_str text(const char* words) { return {words, std::strlen(words)}; }
  static Stage& of(const swage_host* host) { return *static_cast<Stage*>(host->host_data); }
  static Stage& of(swage_builder* builder) { return *static_cast<Stage*>(builder->host_data); }

  static const void* find(const swage_host* host, const char* id) {
    static constexpr swage_host_display display{[](const swage_host* h) { return of(h).eyes; }};
    if (std::strcmp(id, SWAGE_HOST_DISPLAY) == 0) return &display;
    return std::strcmp(id, SWAGE_HOST_POINTER) == 0 ? of(host).pointer_table : nullptr;
  }
  static void report(const swage_host* host, int32_t, swage_str, swage_str message) {
    of(host).reports.emplace_back(message.data, message.size);
  }
  static void fault(const swage_host* host, int32_t, double, double) { ++of(host).faults; }
  static int32_t kind(const swage_host* host) { return of(host).thread_; }
  static uint64_t bits(const swage_host* host) { return of(host).random_(); }

  static uint32_t add_shape(swage_builder* b, int32_t kind, uint32_t body, uint32_t flags, swage_vec3 p,
                            swage_vec3 q, double radius) {
    of(b).shapes.push_back({kind, body, flags, p, q, radius});
    return static_cast<uint32_t>(of(b).shapes.size() - 1);
  }

  void fill_builder() {
    builder_.struct_size = sizeof(swage_builder);
    builder_.host_data = this;
    fill_shapes();
    builder_.body = [](swage_builder* b, int32_t motion, const swage_pose* X_OB, const swage_mass* mass,
                       const char* name) {
      of(b).bodies.push_back({motion, *X_OB, mass != nullptr ? *mass : swage_mass{}, name});
      return static_cast<uint32_t>(of(b).bodies.size() - 1);
    };
    builder_.hinge = [](swage_builder* b, const swage_hinge* hinge) {
      of(b).hinges.push_back(*hinge);
      return static_cast<uint32_t>(of(b).hinges.size() - 1);
    };
    builder_.state = [](swage_builder* b, uint32_t n) { return of(b).n_state += n, 0u; };
    builder_.declare = [](swage_builder* b, int32_t what, const char* id, const char*, const char*) {
      auto& names = of(b).declared[what];
      names.emplace_back(id);
      return static_cast<uint32_t>(names.size() - 1);
    };
    builder_.error = [](swage_builder* b, const char* id, const char* message) {
      of(b).errors.push_back(std::string(id) + ": " + message);
    };
  }

  void fill_shapes() {
    builder_.sphere = [](swage_builder* b, uint32_t body, swage_vec3 c, double r, uint32_t flags) {
      return add_shape(b, SWAGE_SHAPE_SPHERE, body, flags, c, c, r);
    };
    builder_.capsule = [](swage_builder* b, uint32_t body, swage_vec3 p, swage_vec3 q, double r,
                          uint32_t flags) { return add_shape(b, SWAGE_SHAPE_CAPSULE, body, flags, p, q, r); };
    builder_.cylinder = [](swage_builder* b, uint32_t body, swage_vec3 p, swage_vec3 q, double r,
                           uint32_t flags) {
      return add_shape(b, SWAGE_SHAPE_CYLINDER, body, flags, p, q, r);
    };
    builder_.arc = [](swage_builder* b, uint32_t body, const swage_arc* arc, uint32_t flags) {
      of(b).arcs.push_back(*arc);
      return add_shape(b, SWAGE_SHAPE_ARC, body, flags, {}, {}, arc->wire_radius);
    };
    builder_.convex = [](swage_builder* b, uint32_t body, const swage_convex* c, uint32_t flags) {
      of(b).convexes.push_back({body,
                                {c->vertex, c->vertex + 3 * c->n_vertex},
                                {c->face_start, c->face_start + c->n_face + 1},
                                {c->face_vertex, c->face_vertex + c->face_start[c->n_face]}});
      return add_shape(b, SWAGE_SHAPE_CONVEX, body, flags, {}, {}, 0);
    };
  }

  swage_host host_{};
  swage_builder builder_{};
  swage_instance* instance_ = nullptr;
  const swage_param* table_ = nullptr;
  uint32_t n_param_ = 0;
  std::mt19937_64 random_;
  int32_t thread_ = SWAGE_THREAD_MAIN;
  bool active_ = false;
};

/// The arrays of one object, sized after what it declared; poses at the start.
struct ObjectArrays {
  explicit ObjectArrays(const Stage& stage)
      : V_WB(stage.bodies.size()),
        F_B_W(stage.bodies.size()),
        angle(stage.hinges.size()),
        rate(stage.hinges.size()),
        torque(stage.hinges.size()),
        drive(stage.hinges.size()),
        state(stage.n_state) {
    for (const DeclaredBody& body : stage.bodies) X_WB.push_back(body.X_OB);
    const auto found = stage.declared.find(SWAGE_DECLARE_SIGNAL);
    signal.resize(found == stage.declared.end() ? 0 : found->second.size());
  }

  /// Valid until the arrays change.
  swage_object_step step() {
    swage_object_step s{};
    s.struct_size = sizeof(s);
    s.dt_s = 1e-3;
    s.time_s = time_s;
    s.scene_length = 1e-3;
    s.input = input;
    s.X_WB = X_WB.data();
    s.V_WB = V_WB.data();
    s.F_B_W = F_B_W.data();
    s.hinge_angle = angle.data();
    s.hinge_rate = rate.data();
    s.hinge_torque = torque.data();
    s.drive = drive.data();
    s.state = state.data();
    s.signal = signal.data();
    s.n_body = static_cast<uint32_t>(X_WB.size());
    s.n_hinge = static_cast<uint32_t>(angle.size());
    s.n_state = static_cast<uint32_t>(state.size());
    s.n_signal = static_cast<uint32_t>(signal.size());
    return s;
  }

  std::vector<swage_pose> X_WB;
  std::vector<swage_twist> V_WB;
  std::vector<swage_wrench> F_B_W;
  std::vector<double> angle, rate, torque;
  std::vector<swage_drive> drive;
  std::vector<double> state, signal;
  const swage_input* input = nullptr;
  double time_s = 0;
};

}  // namespace swage::stage
