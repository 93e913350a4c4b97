// SPDX-License-Identifier: Apache-2.0
#include "tools/needle_bench.hpp"

#include <nlohmann/json.hpp>
#include <numbers>
#include <type_traits>

#include "host/units.hpp"
#include "toolkit/read_file.hpp"

namespace swage::tools {
namespace {

using toolkit::JointSection;
using toolkit::StripSection;
using toolkit::WireArm;
using toolkit::WireMaterial;

constexpr int kFineCells = 60, kStrips = 60;  // of the reference; the tests state the remaining error
constexpr int kSteps = 60;                    // load steps of a test
constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kProbe = 1e-3;  // N, well within elasticity

WireArm<StripSection> fine_arm(const NeedleModel& n, double length) {
  return {length, std::vector<StripSection>(kFineCells, StripSection(n.diameter, n.material, kStrips))};
}
WireArm<JointSection> loop_arm(const NeedleModel& n, double length, int cells) {
  return {length, std::vector<JointSection>(static_cast<size_t>(cells),
                                            JointSection(n.diameter, n.material, length / cells))};
}

/// Results of the bending test of one arm.
struct Bent {
  double deflection = 0;  // m under kProbe
  double yield = 0;       // N m at the clamp when its outer fibre yields
  double most = 0;        // N m at a right angle
  double back = 0;        // rad, elastic springback of the end on release
};

template <class Section>
Bent bend(WireArm<Section> arm, const NeedleModel& n) {
  Bent out;
  arm.push(kProbe);
  out.deflection = arm.deflection();
  arm.push(0);
  // the first fibre yields between two steps: linear interpolation
  const double to = toolkit::yield_moment(n.diameter, n.material.yield) /
                    toolkit::bending_stiffness(n.diameter, n.material.youngs);
  double before = 0, moment_before = 0;
  for (int k = 1; k <= 4 * kSteps && arm.angle() < kRightAngle; ++k) {
    arm.bend_root(arm.root_curvature() + (k <= kSteps ? 1.5 * to / kSteps : 0.1 * to), 1);
    if (out.yield == 0 && arm.outer() >= 1) {
      const double part = (1 - before) / (arm.outer() - before);
      out.yield = moment_before + part * (arm.moment() - moment_before);
    }
    before = arm.outer(), moment_before = arm.moment();
  }
  out.most = arm.moment();
  const double turned = arm.turn();
  arm.release(kSteps / 5);
  out.back = turned - arm.turn();
  return out;
}

/// Force between flat jaws of a width at which the wire yields: three-point bending, two arms of half the width. `yield`: N m.
/// The joint model has the moment at the contacts by statics, at any coarseness; for strips the outer fibre decides.
template <class Section>
double squeeze(WireArm<Section> arm, double yield) {
  const auto yields = [&](const WireArm<Section>& a) {
    return a.outer() >= 1 || (std::is_same_v<Section, JointSection> && a.moment() >= yield);
  };
  double low = 0, high = 1;
  for (; high < 1e4; high *= 2) {
    WireArm<Section> copy = arm;
    copy.push(0.5 * high);
    if (yields(copy)) break;
  }
  for (int k = 0; k < 30; ++k) {
    const double middle = 0.5 * (low + high);
    WireArm<Section> copy = arm;
    copy.push(0.5 * middle);
    (yields(copy) ? high : low) = middle;
  }
  return high;
}

/// Number of bends by a right angle over 1 mm and back until the wire reaches its strain at break; with a fraction.
template <class Section>
double ductility(Section section, const WireMaterial& m, double diameter) {
  constexpr double kOver = 1e-3;  // m
  const double EI = toolkit::bending_stiffness(diameter, m.youngs);
  const double far = kRightAngle / kOver;
  const auto residual = [&](double curvature) { return curvature - section.moment(curvature) / EI; };
  section.bend(far), section.bend(0), section.bend(far);
  const double at_far = residual(far);
  section.bend(0);
  const double per_bend = 2 * (at_far - residual(0)) * 0.5 * diameter / (1 - m.hardening);
  return m.break_strain / per_bend;
}

}  // namespace

double NeedleModel::length() const {
  const double sweep = 2 * std::numbers::pi * share;
  return chord ? 0.5 * size / std::sin(0.5 * sweep) * sweep : size;
}

double NeedleModel::arm() const {
  const double sweep = 2 * std::numbers::pi * share, held = 2.0 / 3;
  return 2 * length() / sweep * std::sin(0.5 * held * sweep);
}

std::vector<NeedleFigure> bench_needle(const NeedleModel& n, int pieces, double width) {
  const WireMaterial& m = n.material;
  const double d = n.diameter, arm = n.arm(), EI = toolkit::bending_stiffness(d, m.youngs);
  const double M_y = toolkit::yield_moment(d, m.yield), M_p = toolkit::plastic_moment(d, m.yield);
  const int cells = std::max(2, static_cast<int>(std::lround(pieces * 2.0 / 3)));
  const Bent loop = bend(loop_arm(n, arm, cells), n), fine = bend(fine_arm(n, arm), n);

  const int in_jaw = std::max(1, static_cast<int>(std::lround(0.5 * width / (n.length() / pieces))));
  const double half_turn = 0.5 * kRightAngle / 1e-3 / (M_y / EI);
  const double strain = (2 * half_turn - 2 * toolkit::round_moment(half_turn)) * m.yield / m.youngs;
  const JointSection joint(d, m, 1e-3);
  const StripSection strips(d, m, kStrips);
  return {
      {"deflection of the point under 1 mN", "um", 1e-6, kProbe * arm * arm * arm / (3 * EI), loop.deflection,
       fine.deflection},
      {"yield moment", "N mm", 1e-3, M_y, loop.yield, fine.yield},
      {"maximum moment at a right angle", "N mm", 1e-3, M_p, loop.most, fine.most},
      {"springback from there", "deg", std::numbers::pi / 180, M_p * arm / (2 * EI), loop.back, fine.back},
      {"squeeze between flat jaws to first yield", "N", 1, 4 * M_y / width,
       squeeze(loop_arm(n, 0.5 * width, in_jaw), M_y), squeeze(fine_arm(n, 0.5 * width), M_y)},
      {"right-angled bends over 1 mm until it breaks", "1", 1, m.break_strain / (2 * strain),
       ductility(joint, m, d), ductility(strips, m, d)}};
}

std::string read_needle(const std::string& path, NeedleModel& out) {
  using Json = nlohmann::json;
  std::string text, why;
  if (!toolkit::read_file(path, toolkit::kMostFileBytes, text, why)) return path + ": " + why;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("format") || json["format"] != "swage-needle/1" || !json.contains("values"))
    return path + " is not a needle of format swage-needle/1.";
  out = {};
  out.file = path;
  out.name = json.value("name", path);
  for (const auto& [key, entry] : json["values"].items()) {
    const host::Unit* unit = entry.is_object() ? host::find_unit(entry.value("unit", "")) : nullptr;
    if (!unit || !entry.contains("value") || !entry["value"].is_number())
      return path + ": \"" + key + "\" needs a value and a unit.";
    const double x = entry["value"].get<double>() * unit->scale;
    ++(entry.value("status", "") == "sourced" ? out.sourced : out.assumed);
    if (key == "circle_share") out.share = x;
    if (key == "chord" || key == "length") out.size = x, out.chord = key == "chord";
    if (key == "wire_diameter") out.diameter = x;
    if (key == "youngs_modulus") out.material.youngs = x;
    if (key == "poisson_ratio") out.material.poisson = x;
    if (key == "yield_stress") out.material.yield = x;
    if (key == "hardening") out.material.hardening = x;
    if (key == "break_strain") out.material.break_strain = x;
    if (key == "density") out.material.density = x;
  }
  return "";
}

}  // namespace swage::tools
