// SPDX-License-Identifier: Apache-2.0
//
// Steps of a rod, its detector and its solver, divided as those of a lesson are (step/division.hpp): for tests and benches without plugins.
// Threads: [main].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "rod_body.hpp"
#include "scene/state_image.hpp"
#include "step/division.hpp"

namespace swage::dynamics {

class DividedSteps {
 public:
  DividedSteps(scene::World& world, RodBody& rod, contact::Detector& detector, Dynamics& solve, contact::ContactSet& contacts)
      : world_(world), rod_(rod), detector_(detector), solve_(solve), contacts_(contacts), watch_(world, detector) {
    scene::Writer size;
    solve_.save(size);
    for (Begun& begun : begun_) begun.state.resize(scene::image_size(world_) + size.size() + detector_.image_size());
  }

  /// A step of World::dt. `prepare()`: before each part; `touch()`: after its contacts were detected; `done()`: after each part that counts.
  template <class Prepare, class Touch, class Done>
  void step(const Prepare& prepare, const Touch& touch, const Done& done) {
    move(0, prepare, touch, done);
  }
  uint64_t divided() const { return divided_; }  // steps, and parts of steps, that were done in parts

 private:
  struct Begun {  // what a step starts from
    std::vector<std::byte> state;
    RodBody::Kept rod;
    base::SolverHealth health;
  };

  template <class Prepare, class Touch, class Done>
  void move(std::size_t level, const Prepare& prepare, const Touch& touch, const Done& done) {
    if (level < step::kDivisions) begin(begun_[level]);
    prepare();
    watch_.begin();
    solve_.free_motion(world_);
    rod_.advance();
    detector_.detect(world_, contacts_);
    watch_.keep();
    touch();
    FlexibleBody* const self[] = {&rod_};
    solve_.solve(world_, contacts_, self);
    solve_.finish(world_);
    if (level >= step::kDivisions || !step::fell_short(solve_.stats(), begun_[level].health, level, watch_, contacts_)) return done();
    take_back(begun_[level]);
    ++divided_;
    const double h = world_.dt;
    world_.dt = h / step::kParts;
    for (int part = 0; part < step::kParts; ++part) move(level + 1, prepare, touch, done);
    world_.dt = h;
  }
  void begin(Begun& begun) const {
    scene::Writer out(begun.state);
    scene::save(world_, out), solve_.save(out), detector_.save(contacts_, out);
    rod_.keep(begun.rod);
    begun.health = solve_.stats().health;
  }
  void take_back(const Begun& begun) {
    scene::Reader in(begun.state);
    scene::restore(world_, in), solve_.restore(in), detector_.restore(contacts_, in);
    solve_.take_back(begun.health);
    rod_.put_back(begun.rod);
  }

  scene::World& world_;
  RodBody& rod_;
  contact::Detector& detector_;
  Dynamics& solve_;
  contact::ContactSet& contacts_;
  step::ChainWatch watch_;
  std::array<Begun, step::kDivisions> begun_;  // per level of division
  uint64_t divided_ = 0;
};

}  // namespace swage::dynamics
