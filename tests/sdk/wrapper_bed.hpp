// SPDX-License-Identifier: Apache-2.0
//
// The sample plugins behind one entry, and an instance with what a step needs: what the tests of the wrapper share.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <swage/testbed.hpp>
#include <vector>

#include "sample_plugins.hpp"

namespace swage::test {

inline constexpr swage_entry kEntry = make_entry<Everything, Nothing, Touch, Wheel, Script, Watch>();

/// "what id unit" of everything that has a name.
inline std::vector<std::string> names(const testbed::Declared& declared) {
  std::vector<std::string> lines;
  for (const auto& name : declared.names)
    lines.push_back(std::to_string(name.what) + " " + name.id + " " + name.unit);
  return lines;
}

inline const swage_factory& factory() {
  return *static_cast<const swage_factory*>(kEntry.get_factory(SWAGE_FACTORY_INSTANCES));
}
inline const swage_param* table(const char* id, uint32_t& n) {
  return static_cast<const swage_param_factory*>(kEntry.get_factory(SWAGE_FACTORY_PARAMS))->table(id, &n);
}

/// The host's values for Everything: the defaults, to be changed by tests.
struct Values {
  std::vector<swage_value> value;
  std::string words = "steel";
  swage_values raw{};

  Values() {
    uint32_t n = 0;
    const swage_param* row = table(Everything::id, n);
    value.resize(n);
    for (uint32_t i = 0; i < n; ++i)
      for (int k = 0; k < 4; ++k) value[i].number[k] = row[i].default_number[k];
  }
  const swage_values* get() {
    value[4].text = str(words);
    raw = {sizeof(swage_values), static_cast<uint32_t>(value.size()), value.data(), str("ball")};
    return &raw;
  }
};

/// An instance of Everything with the arrays that a step needs.
struct Ball {
  testbed::Host host;
  testbed::Declared builder;
  Values values;
  swage_instance* raw = factory().create(&host.raw, Everything::id);
  swage_pose pose = kIdentity;
  swage_twist twist{};
  swage_wrench wrench{};
  double state[2] = {0, 0};
  double signal[1] = {0};
  swage_object_step step{};

  Ball() {
    step.struct_size = sizeof step;
    step.dt_s = 1e-3;
    step.X_WB = &pose;
    step.V_WB = &twist;
    step.F_B_W = &wrench;
    step.state = state;
    step.signal = signal;
    step.n_body = 1;
    step.n_state = 2;
    step.n_signal = 1;
  }
  ~Ball() {
    host.role = SWAGE_THREAD_MAIN;
    raw->destroy(raw);
  }
  swage_result configure() { return raw->configure(raw, values.get(), &builder.raw); }
  void start() {
    ASSERT_EQ(configure(), SWAGE_OK);
    ASSERT_EQ(raw->activate(raw, 1e-3), SWAGE_OK);
    host.role = SWAGE_THREAD_RT;
  }
  template <class Table>
  const Table* get(const char* id) {
    return static_cast<const Table*>(raw->get_extension(raw, id));
  }
};

}  // namespace swage::test
