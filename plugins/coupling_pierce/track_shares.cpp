// SPDX-License-Identifier: Apache-2.0
//
// Division of a track's length among its supports, which are added, dropped and merged without a change of the forces that they bear.
#include <algorithm>
#include <cmath>

#include "track.hpp"

namespace swage::coupling_pierce {

using toolkit::Quat;
using toolkit::raw;
using toolkit::vec;

namespace {

// Stiffness of the bristle over that across the needle, as in make_ties.
constexpr double kStick = Track::kStick;
// In wire radii: smallest length that a support represents: at the start the point is in and has no length.
constexpr double kLeast = 1;
// In wire radii: length with which a support begins, a hundredth of its final one.
constexpr double kFirstShare = 0.02;
// In wire radii: a needle that is inserted by less than this is held at its entry alone.
constexpr double kOne = 2;
// In wire radii: the blunt end is out when it is farther than this outside the tissue.
constexpr double kBeyond = 1;
// Limit of the motion of borders between supports, over the advance of the point: length passes from one place of the tissue to another
// while the needle advances by that length, and not in one step, to which the tissue would respond with a jump. Below 2 a track is not
// thinned out before it is full again.
constexpr double kPasses = 4;

void put(double* to, const Vec3& a) {
  for (int i = 0; i < 3; ++i) to[i] = a[i];
}
Vec3 vec3(const double* a) { return {a[0], a[1], a[2]}; }
uint32_t supports(const Track& track) { return static_cast<uint32_t>(track.count); }

/// Stretch of a support, beyond the displacement of the tissue: across [m, O] and along the needle's advance [m].
struct Stretch {
  Vec3 across_O = Vec3::Zero();
  double along = 0;
};

Stretch stretch(const Site& site, const Support& support) {
  const double k = site.law.side_stiffness * support.share;
  if (!(k > 0)) return {};
  return {-vec3(support.across) / k, -support.along / (kStick * k)};
}

/// Moves the rest position of a support so that its stretch changes from `is` to `to`.
void stretch_to(const Site& site, Support& support, const Stretch& is, const Stretch& to) {
  put(support.p, vec3(support.p) + is.across_O - to.across_O);
  support.rest += (is.along - to.along) / site.length;
}

/// Force [N] that a support bears, and `rub` [N], the sum of opposite forces that cancel in it.
struct Load {
  Vec3 across_O = Vec3::Zero();
  double along = 0, rub = 0;
};

/// Gives a support another length and another load, and the stretch that belongs to them. A support that only grows keeps its force
/// and is stretched less, as the added length begins unstretched.
void set_load(const Site& site, Support& support, double share, const Load& load) {
  const Stretch is = stretch(site, support);
  support.share = share;
  put(support.across, load.across_O);
  support.along = load.along, support.rub = load.rub;
  if (share > 0) stretch_to(site, support, is, stretch(site, support));
}

Load load_of(const Support& support) { return {vec3(support.across), support.along, support.rub}; }
/// Load of a part of the length of a support, turned by turn_O where it passes to a place with another direction of the needle.
Load part_of(const Load& load, double part, const Quat& turn_O) {
  return {part * (turn_O * load.across_O), part * load.along, part * load.rub};
}
/// Rotation that turns directions across the needle at one support into directions across it at another.
Quat turn_between(const Site& site, const NeedlePoint& from, const NeedlePoint& to) {
  const Quat to_O = site.X_WO.q.conjugate();
  return Quat::FromTwoVectors(to_O * from.advance_W, to_O * to.advance_W);
}
/// Sum of two loads at one place. Forces that cancel add to `rub`, which decays as the needle slides out of their places (kEven).
Load sum_of(const Load& a, const Load& b) {
  Load sum{a.across_O + b.across_O, a.along + b.along, a.rub + b.rub};
  sum.rub += a.across_O.norm() + b.across_O.norm() - sum.across_O.norm();
  return sum;
}

/// Begins a support one wire radius behind the point, so that the point does not leave it at once. The tissue is displaced there as at the
/// support before. Its length is almost zero: the length that it takes over from that support in the next step brings its stretch, and
/// length that is cut afterwards begins unstretched.
void begin_support(const Site& site, const Track& track, Support& support) {
  const double s = site.radius / site.length;
  const auto place = site.needle.place(site.a, s);
  if (!place) return;
  const Support& before = track.support[supports(track) - 1];
  support = {};
  put(support.given, vec3(before.given));
  put(support.p, site.local(vec(place->p_W)) - vec3(support.given));
  support.rest = s;
  support.at = track.progress - needle_at(site, support).gone;
  support.share = kFirstShare * site.radius;
}

/// Moves a support to s and keeps its stretch.
void lay_again(const Site& site, const Track& track, double s, Support& support) {
  const auto place = site.needle.place(site.a, s);
  if (!place) return;
  const Vec3 advance = -vec(place->tangent_W);
  const Stretch is = stretch(site, support);
  const Vec3 across = toolkit::rotated(site.X_WO.q, is.across_O);
  put(support.p, site.local(vec(place->p_W) - (across - advance.dot(across) * advance)) - vec3(support.given));
  support.rest = s - is.along / site.length;
  support.at = track.progress - needle_at(site, support).gone;
}

/// Drops every other support, once its length is almost zero. The remaining ones bear the loads of all, with the mean of their stretches,
/// which stores no more energy than before.
void thin_out(const Site& site, const NeedlePoints& at, Track& track) {
  Support merged[Track::kSupports / 2];
  for (uint32_t i = 0; i < Track::kSupports / 2; ++i) {
    const uint32_t here = 2 * i;
    Support& kept = merged[i] = track.support[here];
    double share = kept.share;
    Load load = load_of(kept);
    for (const uint32_t gone : {here - 1, here + 1}) {
      if (gone >= Track::kSupports) continue;
      const Support& support = track.support[gone];
      // the last support has no neighbour beyond it
      const double part = gone + 1 < Track::kSupports ? 0.5 : 1;
      share += part * support.share;
      load = sum_of(load, part_of(load_of(support), part, turn_between(site, at.support[gone], at.support[here])));
    }
    set_load(site, kept, share, load);
  }
  std::copy_n(merged, Track::kSupports / 2, track.support);
  track.count = Track::kSupports / 2;
  track.spacing *= 2;
  track.thins = 0;
}

/// Length of a support by the places of its neighbours [m], and whether the needle or the tissue has left it.
struct Share {
  double length = 0;
  bool gone = false;
};

/// Length that passes from one support to its neighbour takes its load along, so that the load of the track is the same for any division;
/// length that enters at the point begins unstretched, length that leaves there loses its load. The stored energy does not grow: f^2/(2kl)
/// is convex in f and l together and homogeneous of degree 1, so of a sum it is at most the sum; the tissue itself stores the same.
class Passing {
 public:
  Passing(const Site& site, const NeedlePoints& at, Track& track, const Share* to)
      : site_(site), at_(at), track_(track), to_(to), count_(supports(track)) {
    double surplus = 0;
    for (uint32_t i = 0; i < count_; ++i) {
      has_[i] = track.support[i].share, load_[i] = load_of(track.support[i]);
      surplus = to[i].gone ? 0 : surplus + track.support[i].share - to[i].length;
      surplus_[i] = surplus;
    }
  }
  /// Passes length towards the point first and then away from it, so that it can pass through a support without length.
  void operator()() {
    for (uint32_t i = 0; i < count_; ++i)
      if (surplus_[i] > 0) pass(i, last(i) ? i : i + 1, surplus_[i]);
    for (uint32_t i = count_; i-- > 0;)
      if (surplus_[i] < 0 && !last(i)) pass(i + 1, i, -surplus_[i]);
    for (uint32_t i = 0; i < count_; ++i) {
      const bool gone = to_[i].gone;
      set_load(site_, track_.support[i], gone ? 0 : to_[i].length, gone ? Load{} : load_[i]);
    }
  }

 private:
  bool last(uint32_t i) const { return i + 1 == count_ || to_[i + 1].gone; }
  /// Passes length on; from a support into itself: its load is released.
  void pass(uint32_t from, uint32_t into, double length) {
    if (to_[from].gone || !(has_[from] > 0)) return;
    const double part = std::min(1.0, length / has_[from]);
    const Quat turn = from == into ? Quat::Identity() : turn_between(site_, at_.support[from], at_.support[into]);
    const Load given = part_of(load_[from], part, turn);
    load_[from] = part_of(load_[from], 1 - part, Quat::Identity());
    has_[from] -= length;
    if (from == into) return;
    load_[into] = sum_of(load_[into], given);
    has_[into] += length;
  }

  const Site& site_;
  const NeedlePoints& at_;
  Track& track_;
  const Share* to_;
  uint32_t count_;
  double surplus_[Track::kSupports], has_[Track::kSupports];  // m: surplus of the supports up to this one; present length of each
  Load load_[Track::kSupports];
};

/// Moves the borders towards their targets by at most `most` [m]; the last support gets the remaining length.
void limit(const Track& track, double most, Share* to) {
  const uint32_t count = supports(track);
  double surplus = 0, before = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (to[i].gone) {
      surplus = before = 0;
      continue;
    }
    surplus += track.support[i].share - to[i].length;
    const bool last = i + 1 == count || to[i + 1].gone;
    const double shift = last ? 0 : surplus - std::clamp(surplus, -most, most);
    to[i].length += shift - before;
    before = shift;
  }
  // the point went back beyond a border
  for (uint32_t i = count; i-- > 1;) {
    if (to[i].gone || to[i].length >= 0) continue;
    if (!to[i - 1].gone) to[i - 1].length += to[i].length;
    to[i].length = 0;
  }
}

}  // namespace

void follow(const Site& site, const NeedlePoints& at, Track& track) {
  // drops supports that the point has left: the track stays cut, and supports are added again when the point comes back
  const auto last = [&] { return supports(track) - 1; };
  const auto deep = [&] { return track.support[last()].at + at.support[last()].gone; };
  while (at.support[last()].s < 0 && (last() > 1 || (last() == 1 && deep() < kOne * site.radius))) {
    const Support& left = track.support[last()];
    Support& before = track.support[last() - 1];
    const Load load = part_of(load_of(left), 1, turn_between(site, at.support[last()], at.support[last() - 1]));
    set_load(site, before, before.share + left.share, sum_of(load_of(before), load));
    track.count -= 1;
  }
  track.progress = deep();
  track.deepest = std::max(track.deepest, track.progress);
  track.below = std::max(track.below, site.point_in.depth);
}

bool share_out(const Site& site, const NeedlePoints& points, Track& track) {
  const uint32_t count = supports(track);
  const auto at = [&](uint32_t i) { return points.support[i].s; };
  const double tip = track.out == Track::kOut ? track.s_out : 0;
  double upper = track.s_in;
  bool held = false;
  Share share[Track::kSupports];
  for (uint32_t i = 0; i < count; ++i) {
    // while the track is thinned out, every other support loses its length
    const bool goes = track.thins != 0 && i % 2 == 1;
    const uint32_t next = i + (track.thins != 0 ? 2 : 1);
    const double lower = goes ? upper : next < count ? std::clamp(0.5 * (at(i) + at(next)), tip, upper) : tip;
    share[i].length = std::max(0.0, upper - lower) * site.length;
    upper = lower;
    if (i == 0 && track.s_in < 1) share[i].length = std::max(share[i].length, kLeast * site.radius);
    const auto place = site.tissue.inside(site.b, raw(site.world(track.support[i].p)));
    const bool beyond = place && place->edge < 0;  // torn up to the rim
    share[i].gone = at(i) >= 1 || beyond;          // or the needle has left the support
    held = held || !beyond;
  }
  const bool fresh =
      std::all_of(track.support, track.support + count, [](const Support& support) { return support.share == 0; });
  limit(track, fresh ? HUGE_VAL : kPasses * std::abs(track.progress - track.shared), share);
  track.shared = track.progress;
  Passing(site, points, track, share)();
  return held;
}

void support_end(const Site& site, NeedlePoints& at, Track& track) {
  const uint32_t last = supports(track) - 1;
  if (track.out != Track::kOut || track.passed == 0) return;
  // no thinning out where the other supports are left behind
  track.thins = 0;
  if (at.support[last].s < 1 || track.s_out >= 1) return;
  lay_again(site, track, 0.5 * (track.s_out + 1), track.support[last]);
  at.support[last] = needle_at(site, track.support[last]);
}

bool is_through(const Site& site, const Track& track) {
  // progress is at least the needle's length: it did not leave by its entry, which may lie in the plane of its exit
  if (track.out != Track::kOut || track.passed == 0 || track.progress < site.length) return false;
  if (track.s_out >= 1) return true;
  // a needle that lies flat against the exit does not cross it; and a rim has no exit plane
  const auto end = site.needle.place(site.a, 1);
  const auto in = end ? site.tissue.inside(site.b, end->p_W) : std::nullopt;
  return in && std::min({in->depth, -in->beyond, in->edge}) < -kBeyond * site.radius;
}

void lengthen(const Site& site, const NeedlePoints& at, Track& track) {
  const NeedlePoint& end = at.support[supports(track) - 1];
  Support& last = track.support[supports(track) - 1];
  // with its entry support alone the inserted part would swing as on a hinge
  if (supports(track) > 1 && end.s < 0) return lay_again(site, track, 0.5 * track.progress / site.length, last);
  if (supports(track) < Track::kSupports) track.thins = 0;
  if (track.thins != 0) {
    const double least = kFirstShare * site.radius;
    if (std::max(track.support[1].share, track.support[3].share) <= least) thin_out(site, at, track);
    return;
  }
  if (track.out != Track::kInside || track.progress - last.at < track.spacing) return;
  if (supports(track) == Track::kSupports) {
    track.thins = 1;
    return;
  }
  begin_support(site, track, track.support[supports(track)]);
  track.count += 1;
}

}  // namespace swage::coupling_pierce
