// SPDX-License-Identifier: Apache-2.0
#include "suture.hpp"

#include "properties/properties.hpp"

namespace swage::thread {

std::string read_suture(const std::string& path, Suture& suture) {
  const auto into = [&](double Suture::*of) { return [&suture, of](double x) { suture.*of = x; }; };
  // the bounds of the diameter's band are for people, the friction is the coupling's
  return properties::read_properties(path, "swage-thread/1", "suture",
                                     {{"diameter", {"um", 1e-6, into(&Suture::diameter)}},
                                      {"diameter_least", {"um", 1e-6, {}}},
                                      {"diameter_most", {"um", 1e-6, {}}},
                                      {"young", {"GPa", 1e9, into(&Suture::young)}},
                                      {"poisson", {"1", 1, into(&Suture::poisson)}},
                                      {"density", {"kg/m3", 1, into(&Suture::density)}},
                                      {"friction", {"1", 1, {}}},
                                      {"strength", {"mN", 1e-3, into(&Suture::strength)}},
                                      {"pull_off", {"mN", 1e-3, into(&Suture::pull_off)}},
                                      {"memory", {"1/m", 1, into(&Suture::memory)}},
                                      {"yield", {"1", 1, into(&Suture::yield)}},
                                      {"hardening", {"1", 1, into(&Suture::hardening)}}});
}

std::string fault(const Suture& s) {
  const bool sound = s.diameter >= 5e-6 && s.diameter <= 1e-3 && s.young >= 1e6 && s.young <= 1e12 &&
                     s.poisson >= 0 && s.poisson <= 0.5 && s.density >= 100 && s.density <= 25e3 &&
                     s.memory >= 0 && s.memory <= 1000 && s.strength >= 1e-4 && s.pull_off >= 1e-4 &&
                     (s.yield == 0 || (s.yield >= 1e-3 && s.yield <= 1)) && s.hardening >= 0 && s.hardening <= 0.95;
  return sound ? ""
               : "the material is none: diameter 5 to 1000 um, 1 MPa to 1000 GPa, Poisson's ratio 0 to 0.5, 100 to "
                 "25000 kg/m3, memory 0 to 1000 1/m, strength and pull-off 0.1 mN or more, yield 0 or 0.001 to 1, hardening 0 to 0.95";
}

}  // namespace swage::thread
