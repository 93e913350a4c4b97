// SPDX-License-Identifier: Apache-2.0
//
// A trait of one's own with a table of functions: a pad says how strongly it sticks, and a coupling that has never heard of the pad
// asks it. Shown in the guide (objects.md).
#pragma once

#include <swage/coupling.hpp>
#include <swage/object.hpp>

namespace swage::test {

// --- what both sides include: the id of the trait and its table, plain C
#define STICKY_TRAIT "org.example.trait.sticky/1"
struct sticky_table {
  // N/m2 that the surface bears before it lets go, at a temperature in K
  swage_result (*strength)(swage_instance*, const swage_object_step*, double temperature, double* out);
};

struct PadParams {
  double strength = 2e3;  // Pa
};

class Pad final : public Object<PadParams>, public Solid, public Drawing {
 public:
  static constexpr auto id = "test.object.pad", version = "1.0.0", name = "Sticky pad",
                        summary = "A fixed pad that sticks less when it is warm.", author = "Swage", licence = "Apache-2.0";
  static constexpr std::array fields{
      real<&PadParams::strength>("strength", "Strength", "Pa", "kPa", 0, 1e6, "At 293 K.")};
  static constexpr std::array traits{STICKY_TRAIT};

  void build(const PadParams&, Builder& b) override {
    pad_ = b.fixed_body("pad");
    b.sphere(pad_, {0, 0, 0}, kRadius);
  }
  void draw(const Step& step, Visuals& out) override;

  double strength(double temperature) const { return params().strength * 293 / temperature; }

 protected:
  const void* extension(std::string_view wanted) override;

 private:
  static constexpr double kRadius = 1e-3;  // m
  Body pad_;
};

class Peel final : public Coupling<> {
 public:
  static constexpr auto id = "test.coupling.peel", version = "1.0.0", name = "Peel", summary = "Tells how strongly a pad sticks.",
                        author = "Swage", licence = "Apache-2.0";
  static constexpr std::array needs_a{SWAGE_TRAIT_SOLID}, needs_b{STICKY_TRAIT};
  static constexpr bool detects = true;

  void build(const NoParams&, CouplingBuilder& b) override { strength_ = b.signal("peel.strength", "Pa", "Of the pad at 310 K."); }
  void bind(const Peer& a, const Peer& b) override;
  void resolve(const CouplingStep&) override {}
  void finish(const CouplingStep& step) override;

 private:
  Signal strength_;
  Peer pad_;
  const sticky_table* table_ = nullptr;
};

}  // namespace swage::test
