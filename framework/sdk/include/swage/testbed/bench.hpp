// SPDX-License-Identifier: Apache-2.0
//
// The host, the builder and the instance behind the benches of <swage/testbed.hpp>.
#pragma once

#include <swage/abi/visual.h>
#include <swage/environment.hpp>
#include <swage/plugin.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace swage::testbed {

/// Arguments of a call of swage_host.fault.
struct Fault {
  int32_t code;
  double a, b;
};

/// Tables that the host offers.
inline const void* host_table(const char* id);

/// A host with any thread role and any random number; records reports and faults.
struct Host {
  swage_host raw{};
  int32_t role = SWAGE_THREAD_MAIN;
  uint64_t random = 1;
  std::vector<std::string> reports;  // "who: what"
  std::vector<Fault> faults;
  swage_environment environment = kStillAir;  // read by the instance

  Host() {
    raw = {sizeof(swage_host),
           SWAGE_ABI_MAJOR,
           SWAGE_ABI_MINOR,
           0,
           this,
           nullptr,
           nullptr,
           nullptr,
           nullptr,
           nullptr};
    raw.get_extension = [](const swage_host*, const char* id) { return host_table(id); };
    raw.report = [](const swage_host* host, int32_t, swage_str where, swage_str message) {
      of(host).reports.push_back(std::string(view(where)) + ": " + std::string(view(message)));
    };
    raw.fault = [](const swage_host* host, int32_t code, double a, double b) {
      of(host).faults.push_back({code, a, b});
    };
    raw.thread_kind = [](const swage_host* host) { return of(host).role; };
    raw.random_u64 = [](const swage_host* host) {
      return of(host).random = of(host).random * 6364136223846793005u + 1;
    };
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  static Host& of(const swage_host* host) { return *static_cast<Host*>(host->host_data); }
};

/// A builder that records the declarations.
struct Declared {
  swage_builder raw{};
  struct Body {
    std::string name;
    int32_t motion;
    swage_pose X_OB;
    swage_mass mass;
  };
  struct Name {
    int32_t what;  // SWAGE_DECLARE_*
    std::string id, unit, doc;
  };
  std::vector<Body> bodies;
  std::vector<int32_t> shapes;  // SWAGE_SHAPE_*
  std::vector<swage_hinge> hinges;
  std::vector<double> particles;  // 3 n, in O
  std::vector<Name> names;
  std::vector<std::string> errors;  // "parameter: what"
  uint32_t n_state = 0;
  uint32_t points = 0;  // contact points that the object reserved
  bool refuse_bodies = false;

  Declared() {
    raw = {sizeof(swage_builder),
           0,
           this,
           add_body,
           add_particles,
           add_sphere,
           add_rod<SWAGE_SHAPE_CAPSULE>,
           add_rod<SWAGE_SHAPE_CYLINDER>,
           add_arc,
           add_convex,
           add_hinge,
           add_state,
           add_name,
           add_error};
  }
  Declared(const Declared&) = delete;
  Declared& operator=(const Declared&) = delete;

  /// How many of one kind, e.g. SWAGE_DECLARE_SIGNAL.
  uint32_t count(int32_t what) const {
    uint32_t n = 0;
    for (const Name& name : names) n += name.what == what ? 1 : 0;
    return n;
  }
  /// Index of a name among its kind, or kNone.
  uint32_t find(int32_t what, std::string_view id) const {
    uint32_t n = 0;
    for (const Name& name : names) {
      if (name.what != what) continue;
      if (name.id == id) return n;
      ++n;
    }
    return kNone;
  }

 private:
  static Declared& of(swage_builder* builder) { return *static_cast<Declared*>(builder->host_data); }
  static uint32_t shape(swage_builder* b, int32_t kind) {
    of(b).shapes.push_back(kind);
    return static_cast<uint32_t>(of(b).shapes.size() - 1);
  }
  static uint32_t add_body(swage_builder* b, int32_t motion, const swage_pose* X_OB, const swage_mass* mass,
                           const char* name) {
    if (of(b).refuse_bodies) return kNone;
    of(b).bodies.push_back({name, motion, *X_OB, mass != nullptr ? *mass : swage_mass{}});
    return static_cast<uint32_t>(of(b).bodies.size() - 1);
  }
  static uint32_t add_particles(swage_builder* b, uint32_t n, const double* p_O, const double*, double) {
    const auto first = static_cast<uint32_t>(of(b).particles.size() / 3);
    of(b).particles.insert(of(b).particles.end(), p_O, p_O + 3 * size_t{n});
    return first;
  }
  static uint32_t add_sphere(swage_builder* b, uint32_t, swage_vec3, double, uint32_t) {
    return shape(b, SWAGE_SHAPE_SPHERE);
  }
  template <int32_t kind>
  static uint32_t add_rod(swage_builder* b, uint32_t, swage_vec3, swage_vec3, double, uint32_t) {
    return shape(b, kind);
  }
  static uint32_t add_arc(swage_builder* b, uint32_t, const swage_arc*, uint32_t) {
    return shape(b, SWAGE_SHAPE_ARC);
  }
  static uint32_t add_convex(swage_builder* b, uint32_t, const swage_convex*, uint32_t) {
    return shape(b, SWAGE_SHAPE_CONVEX);
  }
  static uint32_t add_height_field(swage_builder* b, uint32_t, const swage_height_field*, uint32_t) {
    return shape(b, SWAGE_SHAPE_HEIGHT_FIELD);
  }
  static uint32_t add_chain(swage_builder* b, uint32_t, const swage_chain*, uint32_t) {
    return shape(b, SWAGE_SHAPE_CHAIN);
  }
  static uint32_t add_hinge(swage_builder* b, const swage_hinge* hinge) {
    of(b).hinges.push_back(*hinge);
    return static_cast<uint32_t>(of(b).hinges.size() - 1);
  }
  static uint32_t add_state(swage_builder* b, uint32_t n) {
    of(b).n_state += n;
    return of(b).n_state - n;
  }
  static uint32_t add_name(swage_builder* b, int32_t what, const char* id, const char* unit,
                           const char* doc) {
    of(b).names.push_back({what, id, unit, doc});
    return of(b).count(what) - 1;
  }
  static void add_error(swage_builder* b, const char* param, const char* message) {
    of(b).errors.push_back(std::string(param) + ": " + message);
  }
  static uint32_t reserve_points(swage_builder* b, uint32_t points) {
    of(b).points = std::max(of(b).points, points);
    return points;
  }
  friend const void* host_table(const char* id);
};

inline const void* host_table(const char* id) {
  static constexpr swage_host_height_field height_field{Declared::add_height_field};
  static constexpr swage_host_capacities capacities{
      Declared::reserve_points, [](const swage_host*, swage_capacities* out) {
        *out = {sizeof(swage_capacities), 1024, 64, 256, 512, 256};  // the largest that a host offers
      }};
  if (std::string_view(id) == SWAGE_HOST_CAPACITIES) return &capacities;
  static constexpr swage_host_chain chain{Declared::add_chain};
  if (std::string_view(id) == SWAGE_HOST_CHAIN) return &chain;
  static constexpr swage_host_environment environment{
      [](const swage_host* host, swage_environment* out) { *out = Host::of(host).environment; }};
  if (std::string_view(id) == SWAGE_HOST_ENVIRONMENT) return &environment;
  return std::string_view(id) == SWAGE_HOST_HEIGHT_FIELD ? &height_field : nullptr;
}

/// One instance of plugin T with its parameters: base of the benches of each kind.
template <class T>
class Bench {
 public:
  Host host;
  Declared declared;
  swage_instance* raw;

  Bench() : raw(detail::create<T>(&host.raw)) {
    uint32_t n = detail::Table<T>::count();
    const swage_param* row = detail::Table<T>::rows();
    values_.resize(n);
    texts_.resize(n);
    for (uint32_t i = 0; i < n; ++i) {
      for (int k = 0; k < 4; ++k) values_[i].number[k] = row[i].default_number[k];
      if (row[i].default_text != nullptr) texts_[i] = row[i].default_text;
    }
  }
  ~Bench() {
    host.role = SWAGE_THREAD_MAIN;
    if (active_) raw->deactivate(raw);
    raw->destroy(raw);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  /// Sets a parameter by its id [SI]; a choice by its index. False when there is none.
  bool set(std::string_view id, double a, double b = 0, double c = 0, double d = 0) {
    const uint32_t i = find(id);
    if (i != kNone) values_[i] = {{a, b, c, d}, {}};
    return i != kNone;
  }
  bool set_text(std::string_view id, const std::string& text) {
    const uint32_t i = find(id);
    if (i != kNone) texts_[i] = text;
    return i != kNone;
  }

  swage_result configure() {
    for (size_t i = 0; i < values_.size(); ++i) values_[i].text = str(texts_[i]);
    const swage_values values{sizeof(swage_values), static_cast<uint32_t>(values_.size()), values_.data(),
                              str("it")};
    return raw->configure(raw, &values, &declared.raw);
  }
  swage_result activate(double dt_s) {
    const swage_result result = raw->activate(raw, dt_s);
    active_ = active_ || result >= 0;
    return result;
  }
  /// No errors, reports or faults so far.
  bool content() const { return declared.errors.empty() && host.reports.empty() && host.faults.empty(); }

  /// What the last draw() gave of what a picture shows of it: at most kDrawn. A longer list is reported, as a host counts it.
  std::vector<swage_visual> drawn;
  static constexpr uint32_t kDrawn = 80;  // primitives of one plugin that a host has room for

  template <class Table>
  const Table* get(const char* id) const {
    return static_cast<const Table*>(raw->get_extension(raw, id));
  }

 protected:
  /// draw() of a plugin with Drawing or DrawingOnB; SWAGE_ERROR where it has none.
  swage_result draw_with(const swage_object_step* object, const swage_coupling_step* coupling) {
    const auto* table = get<swage_visuals>(SWAGE_EXT_VISUAL);
    if (table == nullptr) return SWAGE_ERROR;
    uint32_t n = 0;
    drawn.assign(kAsked, {});
    const swage_result result = table->draw(raw, object, coupling, kAsked, drawn.data(), &n);
    if (n > kDrawn) host.reports.push_back("draw: " + std::to_string(n) + " primitives, and a host draws " + std::to_string(kDrawn));
    drawn.resize(std::min(n, kDrawn));
    return result;
  }

 private:
  static constexpr uint32_t kAsked = 4096;  // room in which a list that makes sense has its place

  static uint32_t find(std::string_view id) {
    for (uint32_t i = 0; i < detail::Table<T>::count(); ++i)
      if (detail::Table<T>::rows()[i].id == id) return i;
    return kNone;
  }

  std::vector<swage_value> values_;
  std::vector<std::string> texts_;
  bool active_ = false;
};

}  // namespace swage::testbed
