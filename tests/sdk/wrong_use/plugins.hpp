// SPDX-License-Identifier: Apache-2.0
//
// What is right, for fixtures to spoil.
#pragma once

#include <swage/coupling.hpp>
#include <swage/device.hpp>
#include <swage/lesson.hpp>
#include <swage/object.hpp>

struct Said {
  static constexpr auto id = "org.example.ball", version = "1.0.0", name = "Ball", summary = "A ball.",
                        author = "Somebody", licence = "Apache-2.0";
};

struct BallParams {
  double radius = 1e-3;  // m
  int count = 1;
  std::string words;
};

class BallBase : public swage::Object<BallParams>, public Said {
 public:
  void build(const BallParams& p, Builder& b) override {
    b.sphere(b.fixed_body("ball"), {0, 0, 0}, p.radius);
  }
};

class Watch : public swage::Lesson<> {
 public:
  static constexpr auto id = "org.example.watch", version = "1.0.0", name = "Watch", summary = "Watches.",
                        author = "Somebody", licence = "Apache-2.0";
  void build(const Params&, Builder& b) override {
    metric_ = b.metric("time", "s", "How long it took.");
    cue_ = b.cue("good", "As it should be.");
  }
  void observe(const swage::View&, const swage::Verdict& verdict, std::span<double>) override {
    verdict.metric(metric_, 1);
  }

 protected:
  swage::Metric metric_;
  swage::Cue cue_;
};
