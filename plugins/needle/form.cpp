// SPDX-License-Identifier: Apache-2.0
#include "form.hpp"

#include <cmath>
#include <numbers>

#include "properties/properties.hpp"

namespace swage::needle {
namespace {

// number of slices of a wire whose thickness changes: the mass of a taper is then exact to 1e-4
constexpr int kSlices = 64;

/// Integrals over a length of wire with one section, from angle a0 to a1 in the circle frame, as in `mass_of(Arc)` before the
/// reduction to the centre of mass.
struct Sum {
  double mass = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0, zz = 0;

  void add(double R, double r2, double line_density, double a0, double a1) {
    const double rho = R + r2 / (4 * R), rho2 = R * R + 0.75 * r2, per = line_density * R;
    const double c = std::sin(a1) - std::sin(a0), s = std::cos(a0) - std::cos(a1);
    const double cc = 0.5 * (a1 - a0) + 0.25 * (std::sin(2 * a1) - std::sin(2 * a0));
    const double cs = 0.5 * (std::sin(a1) * std::sin(a1) - std::sin(a0) * std::sin(a0));
    mass += per * (a1 - a0);
    x += per * rho * c;
    y += per * rho * s;
    xx += per * rho2 * cc;
    yy += per * rho2 * (a1 - a0 - cc);
    xy += per * rho2 * cs;
    zz += per * (a1 - a0) * 0.25 * r2;
  }
};

}  // namespace

ArcMass mass_of(const Form& form, double s0, double s1) {
  const Arc arc = form.arc();
  if (form.uniform() && s0 == 0 && s1 == 1) return mass_of(arc, form.material.density);
  const double length = arc.length();
  Sum sum;
  for (int i = 0; i < kSlices; ++i) {
    const double from = s0 + (s1 - s0) * i / kSlices, upto = s0 + (s1 - s0) * (i + 1) / kSlices;
    const double area = form.section(0.5 * (from + upto), length).area;
    sum.add(arc.radius, area / std::numbers::pi, form.material.density * area, arc.angle(from),
            arc.angle(upto));
  }
  ArcMass m;
  m.mass = sum.mass;
  m.centre = sum.x / sum.mass;
  m.along = sum.y / sum.mass;
  const double x2 = sum.xx - sum.mass * m.centre * m.centre, y2 = sum.yy - sum.mass * m.along * m.along;
  m.inertia = Vec3(y2 + sum.zz, x2 + sum.zz, x2 + y2);
  m.product = sum.xy - sum.mass * m.centre * m.along;
  return m;
}

std::string fault(const Form& f) {
  const toolkit::WireMaterial& m = f.material;
  if (!(f.share > 0 && f.share < 1)) return "a needle spans more than nothing and less than a full circle";
  if (!(f.flattening >= 0.3 && f.flattening <= 1)) return "the flattening is between 0.3 and 1";
  if (!(f.swage_hole >= 0 && f.swage_hole < 1)) return "the hole of the swage is thinner than the wire";
  if (f.taper_length + f.swage_length > f.arc().length()) return "taper and swage are longer than the needle";
  const bool sound = m.youngs >= 1e9 && m.yield >= 1e6 && m.yield < 0.1 * m.youngs && m.density >= 100 &&
                     m.poisson >= 0 && m.poisson < 0.5 && m.hardening > 0 && m.break_strain > 0;
  return sound ? ""
               : "the material is none: 1 GPa or more, yield between 1 MPa and a tenth of that, 100 kg/m3 or "
                 "more";
}

std::string read_model(const std::string& path, Form& f) {
  return properties::read_properties(
      path, "swage-needle/1", "needle",
      {{"chord", {"mm", 1e-3, [&](double x) { f.size = x, f.chord = true; }}},
       {"length", {"mm", 1e-3, [&](double x) { f.size = x, f.chord = false; }}},
       {"wire_diameter", {"um", 1e-6, [&](double x) { f.wire_diameter = x; }}},
       {"taper_length", {"mm", 1e-3, [&](double x) { f.taper_length = x; }}},
       {"point_diameter", {"um", 1e-6, [&](double x) { f.point_diameter = x; }}},
       {"flattening", {"1", 1, [&](double x) { f.flattening = x; }}},
       {"swage_length", {"mm", 1e-3, [&](double x) { f.swage_length = x; }}},
       {"swage_hole", {"1", 1, [&](double x) { f.swage_hole = x; }}},
       {"youngs_modulus", {"GPa", 1e9, [&](double x) { f.material.youngs = x; }}},
       {"poisson_ratio", {"1", 1, [&](double x) { f.material.poisson = x; }}},
       {"yield_stress", {"MPa", 1e6, [&](double x) { f.material.yield = x; }}},
       {"hardening", {"1", 1, [&](double x) { f.material.hardening = x; }}},
       {"break_strain", {"1", 1, [&](double x) { f.material.break_strain = x; }}},
       {"density", {"kg/m3", 1, [&](double x) { f.material.density = x; }}},
       {"circle_share", {"1", 1, [&](double x) { f.share = x; }}}});
}

}  // namespace swage::needle
