// SPDX-License-Identifier: Apache-2.0
#include "shots.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "base/rng.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "dynamics/rebound.hpp"
#include "scene/kinematics.hpp"
#include "solids.hpp"

namespace swage::bench {
namespace {

enum Body : uint32_t { kShot, kTarget, kBodies };

constexpr double kRodHalf = 10e-3, kPlateHalf = 4e-3;  // m
constexpr double kMostSpin = 300;                      // rad/s
constexpr int kAfter = 40;                             // steps after the needle could be past the target
constexpr int kLast = 10;                              // of them, those in which the solver must converge
constexpr double kGain = 1e-3;                         // of the energy: what counts as gained
constexpr int kPlaces = 48;                            // along a wire
constexpr double kStep = 15e-6;                        // m, that a place moves from look to look
constexpr double kApart = 70e-6;                       // m, half of the way between places, and a little

Jaw plate(double thickness) {
  Jaw j;
  for (const double z : {-0.5 * thickness, 0.5 * thickness})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      j.vertex.push_back({x * kPlateHalf, y * kPlateHalf, z});
  j.face = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return j;
}

void make_dynamic(scene::BodyInfo& body, const Needle& n) {
  body.motion = SWAGE_MOTION_DYNAMIC;
  body.mass = n.mass();
  for (int i = 0; i < 3; ++i) body.inertia[i] = n.inertia()[i];
}

scene::World make_world(const ShotSetup& s, const Needle& n) {
  scene::World w;
  w.dt = s.dt;
  w.gravity = {0, 0, 0};
  w.body.resize(kBodies);
  for (uint32_t i = 0; i < kBodies; ++i) w.body[i].start = Pose{}.abi(), w.body[i].object = i;
  make_dynamic(w.body[kShot], n);
  scene::Shape wire = needle_shape(n), target = wire;
  if (s.target == Target::kPlate) {
    target = convex_shape();
    w.convex.push_back(convex(plate(s.size)));
  } else if (s.target == Target::kNeedle) {
    make_dynamic(w.body[kTarget], n);
  } else {
    w.body[kTarget].motion = SWAGE_MOTION_FOLLOWS;
    target.kind = SWAGE_SHAPE_CAPSULE;
    target.half_length = kRodHalf;
    target.X_BS = Pose(Vec3::Zero(), toolkit::exp_rotation({-std::numbers::pi / 2, 0, 0})).abi();
  }
  for (auto* shape : {&wire, &target}) shape->bounding_radius = 20e-3;
  wire.body = wire.object = kShot, target.body = target.object = kTarget;
  w.shape = {wire, target};
  scene::reset(w);
  return w;
}

/// The middle of what is shot at, in its own frame: a sheet for a plate, a line for a wire.
struct Middle {
  bool sheet = false;
  std::array<Vec3, kPlaces + 1> line;
};
using Wire = std::array<Vec3, kPlaces + 1>;

Wire wire_of(const Needle& n) {
  Wire w;
  for (int i = 0; i <= kPlaces; ++i) w[static_cast<size_t>(i)] = n.point(n.arc * (double(i) / kPlaces - 0.5));
  return w;
}
Middle middle_of(const ShotSetup& s, const Needle& n) {
  Middle m;
  m.sheet = s.target == Target::kPlate;
  m.line = wire_of(n);
  for (int i = 0; i <= kPlaces && s.target != Target::kNeedle; ++i)
    m.line[static_cast<size_t>(i)] = Vec3(0, kRodHalf * (2.0 * i / kPlaces - 1), 0);
  return m;
}

/// Whether the segment pq cuts the triangle abc.
bool cuts(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto volume = [](const Vec3& o, const Vec3& x, const Vec3& y, const Vec3& z) {
    return (x - o).cross(y - o).dot(z - o);
  };
  if ((volume(p, a, b, c) > 0) == (volume(q, a, b, c) > 0)) return false;
  const bool s = volume(p, q, a, b) > 0;
  return s == (volume(p, q, b, c) > 0) && s == (volume(p, q, c, a) > 0);
}

/// Whether the wire, on its way from `before` to `now`, both in the frame of the target, goes through its middle.
bool crosses(const Middle& m, const Wire& before, const Wire& now) {
  for (size_t i = 0; m.sheet && i <= kPlaces; ++i) {
    const double over = before[i].z(), under = now[i].z();
    if ((over > 0) == (under > 0)) continue;
    const Vec3 p = before[i] + over / (over - under) * (now[i] - before[i]);
    if (std::abs(p.x()) < kPlateHalf && std::abs(p.y()) < kPlateHalf) return true;
  }
  for (size_t i = 0; !m.sheet && i < kPlaces; ++i) {
    const double reach = (before[i + 1] - before[i]).norm() + 2 * kStep;
    for (size_t k = 0; k < kPlaces; ++k) {
      const double long_part = (m.line[k + 1] - m.line[k]).norm();
      if ((m.line[k] - before[i]).norm() > reach + long_part) continue;
      if (cuts(m.line[k], m.line[k + 1], before[i], before[i + 1], now[i]) ||
          cuts(m.line[k], m.line[k + 1], before[i + 1], now[i + 1], now[i]))
        return true;
    }
  }
  return false;
}

/// How near the wire is to the middle of the target [m].
double distance(const Middle& m, const Wire& w) {
  double least = 1;
  for (size_t i = 0; i <= kPlaces; ++i) {
    const Vec3& p = w[i];
    if (m.sheet) {
      const Vec3 out(std::max(0.0, std::abs(p.x()) - kPlateHalf), std::max(0.0, std::abs(p.y()) - kPlateHalf),
                     p.z());
      least = std::min(least, out.norm());
      continue;
    }
    for (size_t k = 0; k < kPlaces; ++k) {
      const Vec3 u = m.line[k + 1] - m.line[k];
      const double t = std::clamp((p - m.line[k]).dot(u) / u.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - m.line[k] - t * u).norm());
    }
  }
  return least;
}

/// One needle in flight.
class Shot {
 public:
  Shot(const ShotSetup& s, int number)
      : setup_(s),
        world_(make_world(s, needle_)),
        detector_(world_, {contact::Pair{0, 1, {s.friction, 1e6, s.restitution}}}, {}),
        dynamics_(world_, {}),
        middle_(middle_of(s, needle_)),
        wire_(wire_of(needle_)) {
    detector_.reserve(contacts_);
    aim(number);
  }

  ShotCounts fly() {
    ShotCounts result;
    result.shots = 1;
    const double start = energy();
    const int steps = static_cast<int>(3 * kBack / setup_.speed / setup_.dt) + kAfter;
    uint64_t converged = 0;
    for (int i = 0; i < steps && !result.passed; ++i) {
      if (i == steps - kLast) converged = dynamics_.stats().health.not_converged;
      const std::array<Pose, 2> from = {Pose(world_.X_WB[0]), Pose(world_.X_WB[1])};
      step();
      for (const contact::Contact& c : contacts_.contact) result.hit |= !c.f_a_W.isZero(0);
      result.passed = went_through(from);
      result.most = std::max(result.most, energy() / start);
    }
    result.gained = !(result.most <= 1 + kGain);
    const double outside = setup_.target == Target::kPlate ? 0.5 * setup_.size : needle_.wire_radius();
    result.stuck = !result.passed && (dynamics_.stats().health.not_converged > converged ||
                                      distance(middle_, seen()) < outside + 0.5 * needle_.wire_radius());
    return result;
  }

 private:
  static constexpr double kBack = 5.3e-3;  // m, from where it is shot: the needle's chord is 5 mm

  /// Everything about a shot from its number.
  void aim(int number) {
    base::Xoshiro256 random(977 * static_cast<uint64_t>(number) + 5);
    const auto unit = [&] {
      Vec3 v;
      do v = Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      while (v.squaredNorm() > 1 || v.squaredNorm() < 1e-3);
      return Vec3(v.normalized());
    };
    Vec3 way = unit();
    // at a plate from both sides, at a rod from all round
    if (middle_.sheet && std::abs(way.z()) < 0.5) way.z() = std::copysign(0.5, way.z()), way.normalize();
    const Quat q = toolkit::exp_rotation(std::numbers::pi * random.uniform() * unit());
    const Vec3 spin = kMostSpin * (number % 4) / 3.0 * random.uniform(0.5, 1) * unit();
    const Vec3 at = middle_.line[static_cast<size_t>(random.uniform(0.3, 0.7) * kPlaces)];
    const Vec3 place = needle_.point(needle_.arc * random.uniform(-0.5, 0.5));
    const double back = kBack / (middle_.sheet ? std::abs(way.z()) : 1) + setup_.speed * setup_.dt * random.uniform();
    const Vec3 target = middle_.sheet ? Vec3(1e-3 * unit().x(), 1e-3 * unit().y(), 0) : at;
    // its turn when it arrives is random all the same
    Pose X(target - q * place - back * way, q);
    while (distance(middle_, seen(X, Pose{})) < 0.4e-3) X.p -= 0.3e-3 * way;
    world_.X_WB[kShot] = X.abi();
    way_ = setup_.speed * way;
    const bool comes = setup_.target == Target::kMovingRod;
    world_.V_WB[kShot] = {toolkit::raw(comes ? Vec3::Zero() : way_), toolkit::raw(spin)};
  }

  void step() {
    if (setup_.target == Target::kMovingRod) {
      const double t = static_cast<double>(world_.step + 1) * setup_.dt;
      scene::follow(world_, kTarget, Pose(-t * way_, Quat::Identity()));
    }
    dynamics_.free_motion(world_);
    const auto V_WB = world_.V_WB;
    if (!setup_.swept)
      for (auto& V : world_.V_WB) V = {};
    detector_.detect(world_, contacts_);
    world_.V_WB = V_WB;
    dynamics_.solve(world_, contacts_, {}, {}, setup_.swept ? &detector_ : nullptr);
    dynamics_.finish(world_);
    ++world_.step;
  }

  Wire seen(const Pose& X_WS, const Pose& X_WT) const {
    const Pose X_TS = X_WT.inverse() * X_WS;
    Wire w;
    for (size_t i = 0; i <= kPlaces; ++i) w[i] = X_TS * wire_[i];
    return w;
  }
  Wire seen() const { return seen(Pose(world_.X_WB[kShot]), Pose(world_.X_WB[kTarget])); }

  /// Along what moved: from waypoint to waypoint, where the step says that there were some.
  bool went_through(const std::array<Pose, 2>& start) const {
    std::array<Pose, 2> from = start;
    double since = 0;
    const auto rest = [&](double t) { return (t - since) / (setup_.dt - since); };
    const auto ways = dynamics_.waypoints();
    for (const dynamics::Waypoint& w : ways) {
      if (!(w.t > since)) continue;
      std::array<Pose, 2> to;
      for (uint32_t b = 0; b < kBodies; ++b) {
        to[b] = between(from[b], Pose(world_.X_WB[b]), rest(w.t));
        for (const dynamics::Waypoint& at : ways)
          if (at.body == b && at.t == w.t) to[b] = at.X_WB;
      }
      if (goes_through(from, to)) return true;
      from = to, since = w.t;
    }
    return goes_through(from, {Pose(world_.X_WB[0]), Pose(world_.X_WB[1])});
  }
  static Pose between(const Pose& from, const Pose& to, double t) {
    const Vec3 turn = toolkit::log_rotation(to.q * from.q.conjugate());
    return {from.p + t * (to.p - from.p), toolkit::exp_rotation(t * turn) * from.q};
  }
  bool goes_through(const std::array<Pose, 2>& from, const std::array<Pose, 2>& to) const {
    const Wire before = seen(from[0], from[1]), now = seen(to[0], to[1]);
    double way = 0;
    for (size_t i = 0; i <= kPlaces; ++i) way = std::max(way, (now[i] - before[i]).norm());
    if (distance(middle_, before) > way + 1e-4 && distance(middle_, now) > way + 1e-4) return false;
    const int looks = static_cast<int>(way / kStep) + 1;
    const auto at = [&](int k) {
      const double t = static_cast<double>(k) / looks;
      return seen(between(from[0], to[0], t), between(from[1], to[1], t));
    };
    Wire last = before;
    for (int k = 0; k < looks;) {
      // places of the wire are kApart apart: one that goes through is near, and what is far takes its time to come
      const double room = distance(middle_, last) - kApart;
      const int clear = static_cast<int>(room / kStep);
      k += std::max(1, clear);
      if (k > looks) return false;
      const Wire next = at(k);
      if (clear < 1 && crosses(middle_, last, next)) return true;
      last = next;
    }
    return false;
  }

  /// Of both, seen from the target at the start [J].
  double energy() const {
    const Vec3 frame = setup_.target == Target::kMovingRod ? Vec3(-way_) : Vec3::Zero();
    double sum = 0;
    for (uint32_t b = 0; b < kBodies; ++b) {
      if (world_.body[b].motion != SWAGE_MOTION_DYNAMIC) continue;
      const Vec3 v = toolkit::vec(world_.V_WB[b].v) - frame;
      const Vec3 w = Pose(world_.X_WB[b]).q.conjugate() * toolkit::vec(world_.V_WB[b].w);
      sum += 0.5 * needle_.mass() * v.squaredNorm() + 0.5 * w.dot(needle_.inertia().cwiseProduct(w));
    }
    return sum;
  }

  const ShotSetup setup_;
  const Needle needle_;
  scene::World world_;
  contact::Detector detector_;
  dynamics::Dynamics dynamics_;
  contact::ContactSet contacts_;
  Middle middle_;
  Wire wire_;
  Vec3 way_ = Vec3::Zero();  // m/s
};

}  // namespace

ShotCounts& ShotCounts::operator+=(const ShotCounts& other) {
  shots += other.shots, hit += other.hit;
  passed += other.passed, stuck += other.stuck, gained += other.gained;
  most = std::max(most, other.most);
  first += other.first;
  return *this;
}

ShotCounts shoot(const ShotSetup& setup, int first, int count) {
  ShotCounts all;
  for (int i = first; i < first + count; ++i) {
    ShotCounts one = Shot(setup, i).fly();
    if (one.failed() > 0)
      one.first = " " + std::to_string(i) + (one.passed ? "p" : "") + (one.stuck ? "s" : "") + (one.gained ? "g" : "");
    all += one;
  }
  return all;
}

}  // namespace swage::bench
