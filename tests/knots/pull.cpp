// SPDX-License-Identifier: Apache-2.0
#include "pull.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "../unit/dynamics/divided_steps.hpp"
#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "toolkit/knot/reader.hpp"
#include "toolkit/rod_passage.hpp"

namespace swage::test {
namespace {

// A laid throw is bent far more than it would be by itself: in oil it springs open slowly. What is left of its viscosity [Pa s]: thread
// drawn along itself at 5 mm/s then drags 2 uN per mm. Less at first: the tie jumps through itself as it is let go.
constexpr double kThin = 1;
constexpr double kSteady = 0.05;    // share of the pretension: tensions so near to what is wanted are there
constexpr double kUndone = 0.5;     // share of its tail that has slipped in: the knot does not hold
constexpr double kBears = 0.01;     // share of the greatest force that a contact bears to be one of the knot

double cpu_us() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

/// The tie with nodes one segment apart, and the node in the middle of its loop.
struct Laid {
  explicit Laid(const PullTest& test) {
    TieShape shape = test.shape;
    shape.tail = test.tail;
    const auto coarse = make_tie(test.word, shape, 1);
    if (!coarse) throw std::invalid_argument("no tie of the word " + text(test.word));
    double length = 0;
    for (size_t i = 1; i < coarse->node.size(); ++i) length += (coarse->node[i] - coarse->node[i - 1]).norm();
    shape.nodes = static_cast<int>(length * test.unit / test.segment) + 1;
    const auto tie = make_tie(test.word, shape, 1);
    if (!tie) throw std::invalid_argument("no tie of the word " + text(test.word) + " with segments of that length");
    for (const Vec3& p : tie->node) node.push_back(test.unit * p);
    const auto lowest = std::min_element(node.begin(), node.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
    loop = static_cast<int>(lowest - node.begin());
  }
  std::vector<Vec3> node;
  int loop = 0;
};

scene::World make_world(const PullTest& test, const Laid& laid) {
  scene::World w;
  w.dt = test.dt;
  w.gravity = {0, 0, 0};  // 0.4 nN of a segment
  w.capacity.contacts = 2048;
  dynamics::add_chain(w, laid.node, 0.5 * test.diameter, 0);
  w.chain[0].bend_radius = test.diameter;  // nylon round nylon
  // cut open: nodes beside the one in the middle are the ends of the legs
  for (const int j : {laid.loop - 1, laid.loop}) w.chain[0].radius[static_cast<size_t>(j)] = 0;
  scene::reset(w);
  return w;
}

/// One of the four ends that are drawn.
struct End {
  int node = 0, edge = 0;
  Vec3 outward = Vec3::Zero();
  double wanted = 0;  // N
  bool held = true;
};

class Rig {
 public:
  Rig(const PullTest& test, const std::string& trace)
      : test_(test), laid_(test), world_(make_world(test, laid_)),
        rod_(world_, 0, 0, toolkit::RodSection::round(test.diameter, test.young, test.poisson, test.density), true),
        n_(static_cast<int>(laid_.node.size())), boxes_(toolkit::room_for_passages(n_)) {
    contact::Options options;
    options.capacity = world_.capacity.contacts, options.margin = test.margin / world_.length;
    const contact::Law law{test.friction, test.stiffness, 0};
    detector_ = std::make_unique<contact::Detector>(world_, std::vector<contact::Pair>{{0, 0, law}}, options);
    solve_ = std::make_unique<dynamics::Dynamics>(world_, dynamics::Options());
    detector_->reserve(contacts_);
    steps_ = std::make_unique<dynamics::DividedSteps>(world_, rod_, *detector_, *solve_, contacts_);
    if (test.yield > 0) rod_.set_yield(toolkit::RodYield::round(test.diameter, test.yield, test.hardening));
    rod_.rod().cut(laid_.loop - 1), rod_.rod().cut(laid_.loop);
    const int nodes[] = {0, n_ - 1, laid_.loop - 1, laid_.loop + 1};
    for (int k = 0; k < 4; ++k) {
      End& e = end_[k];
      e.node = nodes[k], e.edge = k == 0 || k == 3 ? nodes[k] : nodes[k] - 1;
      // a leg goes to where the thread comes from above it
      const int beside = k < 2 ? e.node : e.node + (k == 2 ? -8 : 8);
      e.outward = Vec3(laid_.node[static_cast<size_t>(beside)].x() > 0 ? 1 : -1, 0, k < 2 ? 0.35 : -0.35).normalized();
      rod_.hold(e.node);
    }
    rod_.hold(laid_.loop);
    if (!trace.empty()) trace_.open(trace), trace_ << "t,T_tail_0,T_tail_1,T_leg_0,T_leg_1,tail_0,tail_1,contacts,bearing,overlap,passages,not_converged,us\n";
  }
  PullResult run();

 private:
  void step(PullPhase& phase, double speed);
  void draw(double speed);
  void note(double us);
  /// Steps until done() or for so long [s].
  template <class Done>
  bool go(PullPhase& phase, double speed, double most, const Done& done);
  void sum_up(PullPhase& phase);
  bool all_there(int first);
  bool undone();
  bool tighten();
  void rest();
  void pull_apart();
  void read_word();
  double tension(const End& e) const { return const_cast<Rig*>(this)->rod_.rod().linear_tension(e.edge); }
  double slipped(int tail) const { return begun_[tail] - tail_[tail]; }
  double most_tension() {
    double most = 0;
    for (int j = 0; j + 1 < n_; ++j) most = std::max(most, rod_.rod().linear_tension(j));
    return most;
  }

  const PullTest test_;
  const Laid laid_;
  scene::World world_;
  dynamics::RodBody rod_;
  int n_, steady_ = 0;
  std::vector<double> boxes_, before_, us_;
  std::unique_ptr<contact::Detector> detector_;
  std::unique_ptr<dynamics::Dynamics> solve_;
  contact::ContactSet contacts_;
  std::unique_ptr<dynamics::DividedSteps> steps_;
  End end_[4];  // tails, then legs
  std::ofstream trace_;
  PullResult result_;
  double time_ = 0;
  double tail_[2] = {}, begun_[2] = {};  // m, from its end to the outermost contact that bears; at the beginning of the rest or pull
  size_t bearing_ = 0;
  double overlap_ = 0;
  bool broken_ = false;
  double friction_ = 0;
};

/// Ends go outward, or give way, no faster than `speed` and no farther in a step than brings a third of what is missing to a
/// millimetre of thread.
void Rig::draw(double speed) {
  const double section = 0.25 * M_PI * test_.diameter * test_.diameter;
  const double per_newton = 0.3 * 1e-3 / (test_.young * section) / test_.dt;
  toolkit::RodState s = rod_.state();
  Eigen::Map<Vec3>(s.v + 3 * laid_.loop).setZero();
  for (const End& e : end_) {
    if (!e.held) continue;
    const double v = std::clamp(per_newton * (e.wanted - tension(e)), -speed, speed);
    Eigen::Map<Vec3>(s.v + 3 * e.node) = v * e.outward;
  }
}

/// A step, whose ends are drawn.
void Rig::step(PullPhase& phase, double speed) {
  const toolkit::RodState s = rod_.state();
  const uint64_t failed = solve_->stats().health.total(), directions = solve_->stats().newton;
  const double begin = cpu_us();
  const auto friction = [&] {
    for (contact::Contact& c : contacts_.contact) c.law.friction = friction_;
  };
  const auto there = [&](int j) { return j != laid_.loop - 1 && j != laid_.loop; };
  steps_->step([&] { before_.assign(s.x, s.x + 3 * n_), draw(speed); }, friction,
               [&] { phase.passages += toolkit::passages(n_, before_.data(), s.x, there, boxes_); });
  us_.push_back(cpu_us() - begin);
  time_ += world_.dt;
  ++phase.steps;
  phase.not_converged += solve_->stats().health.total() - failed;
  phase.directions += solve_->stats().newton - directions;
  double most = 0, length = world_.chain[0].s.back();
  for (const contact::Contact& c : contacts_.contact) most = std::max(most, c.f_a_W.norm());
  double first = length, last = 0;
  bearing_ = 0, overlap_ = 0;
  for (const contact::Contact& c : contacts_.contact) {
    bearing_ += c.f_a_W.norm() > 0;
    overlap_ = std::max(overlap_, -c.gap);
    if (!(c.f_a_W.norm() > kBears * most)) continue;
    first = std::min({first, c.place_a.s, c.place_b.s}), last = std::max({last, c.place_a.s, c.place_b.s});
  }
  if (last > first) tail_[0] = first, tail_[1] = length - last;
  phase.contacts = std::max(phase.contacts, contacts_.contact.size());
  phase.bearing = std::max(phase.bearing, bearing_);
  result_.overlap = std::max(result_.overlap, overlap_);
  broken_ = most_tension() > test_.strength;
  if (trace_.is_open() && phase.steps % 10 == 0) {
    trace_ << time_;
    for (const End& e : end_) trace_ << ',' << tension(e);
    trace_ << ',' << tail_[0] << ',' << tail_[1] << ',' << contacts_.contact.size() << ',' << bearing_ << ',' << overlap_ << ','
           << phase.passages << ',' << phase.not_converged << ',' << us_.back() << std::endl;
  }
}

template <class Done>
bool Rig::go(PullPhase& phase, double speed, double most, const Done& done) {
  const double begun = time_;
  while (time_ < begun + most) {
    rod_.fluid = {1000, kThin + test_.oil * std::exp(-time_ / test_.thins)};
    step(phase, speed);
    if (done()) return true;
  }
  return false;
}

void Rig::sum_up(PullPhase& phase) {
  if (us_.empty()) return;
  std::sort(us_.begin(), us_.end());
  const auto share = [&](double q) { return us_[std::min(us_.size() - 1, static_cast<size_t>(q * static_cast<double>(us_.size())))]; };
  phase.median_us = share(0.5), phase.p999_us = share(0.999), phase.most_us = us_.back();
  us_.clear();
}

/// The thread with its loop closed far below.
void Rig::read_word() {
  const toolkit::RodState s = rod_.state();
  std::vector<double> node;
  const auto add = [&](const Vec3& p) { node.insert(node.end(), {p.x(), p.y(), p.z()}); };
  const Vec3 a = s.node(end_[2].node), b = s.node(end_[3].node), down(0, 0, -3 * std::max(a.norm(), b.norm()));
  // every node if they are few enough, all that matter else
  const int every = n_ + 6 > toolkit::KnotThread::kNodes ? 2 : 1;
  for (int i = 0; i < n_; i += every) {
    if (i > end_[2].node && i < end_[3].node) continue;
    add(s.node(i));
    if (i <= end_[2].node && i + every > end_[2].node) add(a + down), add(b + down);
  }
  auto thread = std::make_unique<toolkit::KnotThread>();
  if (!thread->begin(node.data(), static_cast<int>(node.size() / 3))) return;
  auto reader = std::make_unique<toolkit::KnotReader>();
  toolkit::KnotName name;
  while (!reader->read(*thread, 1 << 20, name)) {
  }
  for (int i = 0; i < name.word.throws; ++i) {
    const auto& t = name.word.tied[static_cast<size_t>(i)];
    result_.word.push_back(t.turns * t.sign);
  }
  result_.certain = name.certain;
  result_.same_word = name.certain && name.word.others == 0 && result_.word == test_.word;
}

bool Rig::all_there(int first) {
  bool there = true;
  for (int k = first; k < 4; ++k) there = there && std::abs(tension(end_[k]) - end_[k].wanted) < kSteady * test_.pretension;
  return (steady_ = there ? steady_ + 1 : 0) >= 30;
}

bool Rig::undone() {
  result_.most = std::max({result_.most, tension(end_[2]), tension(end_[3])});
  const double left = kUndone * std::min(begun_[0], begun_[1]);
  return broken_ || bearing_ == 0 || slipped(0) > left || slipped(1) > left;
}

bool Rig::tighten() {
  for (int k = 0; k < 4; ++k) end_[k].wanted = test_.pretension * (k < 2 ? 1 : test_.legs) * (k % 2 == 0 ? 1 : test_.winds);
  friction_ = std::min(test_.friction, test_.tying_friction);
  steady_ = 0;
  const bool tight = go(result_.tighten, test_.tighten_speed, test_.draw_for > 0 ? test_.draw_for : 4, [&] { return broken_ || all_there(0); });
  sum_up(result_.tighten);
  friction_ = test_.friction;
  return (tight || test_.draw_for > 0) && !broken_;
}

void Rig::rest() {
  std::copy_n(tail_, 2, begun_);
  const double from = time_, borne[] = {end_[0].wanted, end_[1].wanted};
  go(result_.rest, test_.tighten_speed, 0.15, [&] {
    for (int k = 0; k < 2; ++k) end_[k].wanted = borne[k] * std::max(0.0, 1 - (time_ - from) / 0.1);
    return broken_;
  });
  for (int k = 0; k < 2; ++k) rod_.let_go(end_[k].node), end_[k].held = false;
  go(result_.rest, test_.tighten_speed, 0.1, [] { return false; });
  result_.sprung = slipped(0) + slipped(1);
  std::copy_n(tail_, 2, begun_);
  sum_up(result_.rest);
  for (int i = 0; i < n_; ++i) result_.rested.push_back(rod_.state().node(i));
  result_.loop = laid_.loop;
}

void Rig::pull_apart() {
  for (int k = 2; k < 4; ++k) end_[k].wanted = test_.load;
  steady_ = 0;
  bool gone = false;
  const bool loaded = go(result_.pull, test_.pull_speed, 4, [&] { return (gone = undone()) || all_there(2); }) && !gone;
  if (loaded && !go(result_.pull, test_.pull_speed, 0.5 * test_.keep, [&] { return gone = undone(); })) {
    const double middle = slipped(0) + slipped(1);
    go(result_.pull, test_.pull_speed, 0.5 * test_.keep, [&] { return gone = undone(); });
    result_.creep = (slipped(0) + slipped(1) - middle) / (0.5 * test_.keep);
  }
  for (int k = 0; k < 2; ++k) result_.slip[k] = slipped(k);
  result_.end = broken_ ? PullEnd::kBreaks : loaded && !gone ? PullEnd::kHolds : PullEnd::kSlips;
}

PullResult Rig::run() {
  if (tighten()) {
    rest();
    if (test_.load > 0) pull_apart();
  }
  sum_up(result_.pull);
  read_word();
  result_.health = base::text(solve_->stats().health);
  return result_;
}

}  // namespace

const char* text(PullEnd end) {
  constexpr const char* kText[] = {"holds", "slips", "breaks", "not tight"};
  return kText[static_cast<int>(end)];
}

PullResult pull(const PullTest& test, const std::string& trace) { return Rig(test, trace).run(); }

}  // namespace swage::test
