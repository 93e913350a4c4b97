// SPDX-License-Identifier: Apache-2.0
#include "knot.hpp"

#include <algorithm>
#include <string>

#include "toolkit/knot/form.hpp"
#include "toolkit/knot/touch.hpp"

namespace swage::coupling_knot {

namespace {

enum class Kind : int { kNone, kHalf, kSquare, kGranny, kMixed, kTangled };

/// Readings in a row without a word, after which the thread is told as tangled though no invariant proves it: 0.4 s with a reading of all views in
/// some 50 steps, much longer than a thread that is drawn keeps one shape. Fewer: a knot in a shape that no view can be reduced in is told as a tangle.
constexpr double kUnread = 8;
/// nodes. A passage and one back through the same strands within a step are one place; the thread slides by less in a step.
constexpr double kSamePlace = 2;

/// The signs of the throws alternate in a square knot and are equal in a granny.
Kind kind_of(const KnotTold& told) {
  if (told.tangled != 0) return Kind::kTangled;
  const int n = static_cast<int>(told.throws);
  if (n < 2) return n == 0 ? Kind::kNone : Kind::kHalf;
  bool square = true, granny = true;
  for (int i = 1; i < std::min(n, KnotTold::kThrows); ++i)
    (told.tied[i] * told.tied[i - 1] > 0 ? square : granny) = false;
  return square ? Kind::kSquare : granny ? Kind::kGranny : Kind::kMixed;
}

/// Thread that one strand takes in the loosest throw, in places: from the throw before it, of the first throw from its own beginning.
double loosest(const toolkit::KnotWord& word) {
  double most = 0;
  for (int i = 0; i < word.throws; ++i) {
    const toolkit::KnotThrow& t = word.tied[static_cast<size_t>(i)];
    double inner[2] = {t.strand[0].last, t.strand[1].first};
    if (i > 0) {
      const toolkit::KnotThrow& before = word.tied[static_cast<size_t>(i - 1)];
      if (before.knot != t.knot) break;
      inner[0] = before.strand[0].first, inner[1] = before.strand[1].last;
    }
    most = std::max({most, inner[0] - t.strand[0].first, t.strand[1].last - inner[1]});
  }
  return most;
}

}  // namespace

void Knot::build(const KnotParams& params, CouplingBuilder& builder) {
  params_ = params;
  builder.state<KnotState>();
  throws_ = builder.signal("knot.throws", "1", "Throws that are tied.");
  for (int i = 0; i < KnotTold::kThrows; ++i)
    tied_[i] = builder.signal(("knot.throw_" + std::to_string(i + 1)).c_str(), "1",
                              "Turns of this throw, with its sign; 0 where it is not tied.");
  kind_ = builder.signal("knot.kind", "1",
                         "0 no knot, 1 half knot, 2 square (signs take turns), 3 granny (signs alike), 4 of both, 5 knotted in another way.");
  sliding_ = builder.signal("knot.sliding", "1", "Throws in which one strand runs straight: they slide.");
  loop_ = builder.signal("knot.loop", "m", "Length of the thread from one strand of the first throw to the other: what the knot is tied around; 0: no knot.");
  from_ = builder.signal("knot.from", "m", "Where the knot begins, from the thread's first end: all throws and the loop lie between there and knot.to; 0: no knot.");
  to_ = builder.signal("knot.to", "m", "Where it ends; 0: no knot.");
  loosest_ = builder.signal("knot.loosest", "m", "Thread that one strand takes in the loosest throw, from the throw before it on: a throw that is drawn down takes little; 0: no knot.");
  certain_ = builder.signal("knot.certain", "1", "1 when all views of the thread agreed in the last reading, else 0.");
  passages_ = builder.signal("knot.passages", "1", "How often the thread has gone through itself.");
  tied_event_ = builder.event("knot.tied", "A throw has been tied; value: its turns with their sign.");
  untied_event_ = builder.event("knot.untied", "A throw has come undone; value: the turns it had, with their sign.");
  tangled_event_ = builder.event("knot.tangled", "The thread is knotted in another way than by throws; value: 1 proved by its invariants, 2 no view could be read for some time.");
  passage_event_ = builder.event("knot.passage",
                                 "The thread has gone through itself: what is tied from here on is not to be trusted; value: where, in m from "
                                 "its first end.");
}

void Knot::bind(const Peer& a, const Peer& b) {
  thread_ = StrandPeer(a);
  if (!thread_.valid()) return refuse("the thread has no table of " SWAGE_TRAIT_STRAND);
  if (a.raw() != b.raw()) refuse("a knot is of one thread: name the same one twice in \"between\"");
}

void Knot::reset(const CouplingStep& step) {
  step.state<KnotState>() = {};
  params_.places = thread_.places(step.a(), params_.places, kMostPlaces);
}

/// Finds the piece of the thread that has the knot, of one without a knot the longest that has not broken, and its places.
void Knot::look(const CouplingStep& step, const KnotState& state) {
  places_ = 0;
  const auto law = thread_.law(step.a());
  const auto n = static_cast<size_t>(params_.places);
  if (!law || !thread_.line(step.a(), {p_W_, 3 * n}, {parted_, n})) return;
  length_ = law->length, radius_ = law->radius;
  const double knot = state.told.throws > 0 ? 0.5 * (state.from + state.to) / length_ * (params_.places - 1) : -1;
  int run = 0;
  bool found = false;
  for (int i = 0; i < params_.places; ++i) {
    run = parted_[i] != 0 ? 0 : run + 1;
    const bool has_knot = i + 1 - run <= knot && knot <= i;
    if (has_knot || (!found && run > places_)) places_ = run, first_ = i + 1 - run;
    found = found || has_knot;
  }
}

void Knot::find_passages(KnotState& state) {
  const double* now = p_W_ + 3 * first_;
  const bool same = state.places == places_ && state.first == first_;
  if (same && std::equal(now, now + 3 * places_, state.p_W)) return;
  if (!same) state.reading = 0, state.wait_s = 0;  // what is being read is another piece
  if (same) {
    const int n = finder_.find(state.p_W, now, places_, found_);
    state.passages += std::max(0, n - found_.size());  // those beyond the list, whose places are not known
    for (const toolkit::KnotPassage& p : found_) note_passage(p, state);
  }
  std::copy_n(now, 3 * places_, state.p_W);
  state.places = places_, state.first = first_;
}

/// A passage back takes away the one before it: the free motion of a step, which no contact has stopped yet, may go through the thread.
void Knot::note_passage(const toolkit::KnotPassage& p, KnotState& state) {
  const int n = static_cast<int>(state.n_crossed);
  for (int k = 0; k < n; ++k) {
    KnotCrossed& c = state.crossed[k];
    if (c.jump + p.jump != 0 || std::abs(c.s - p.s) > kSamePlace || std::abs(c.other - p.other) > kSamePlace) continue;
    c = state.crossed[n - 1], state.n_crossed -= 1;
    return;
  }
  if (n == KnotState::kCrossed) return void(state.passages += 1);
  state.crossed[n] = {p.s, p.other, static_cast<double>(p.jump)}, state.n_crossed += 1;
}

void Knot::tell_passages(const CouplingStep& step, KnotState& state) const {
  state.passages += state.n_crossed;
  for (int k = 0; k < static_cast<int>(state.n_crossed); ++k)
    step.event(passage_event_, length_ * (first_ + state.crossed[k].s) / (params_.places - 1));
  state.n_crossed = 0;
}

void Knot::take(const toolkit::KnotName& said, KnotState& state) const {
  KnotTold seen;
  state.certain = said.certain;
  state.unread = said.unread ? state.unread + 1 : 0;
  if (!said.certain && !said.tangled && state.unread < kUnread) return;  // not known: the last reading is kept
  state.sliding = 0;
  if (said.certain) {
    seen.throws = said.word.throws;
    if (said.word.throws > 0) take_places(said.word, state);
    for (int i = 0; i < said.word.throws; ++i) {
      const toolkit::KnotThrow& t = said.word.tied[static_cast<size_t>(i)];
      if (i < KnotTold::kThrows) seen.tied[i] = t.sign * t.turns;
      state.sliding += toolkit::KnotForm(state.p_W, places_, t).core() >= 0;
    }
  } else {
    seen.tangled = said.tangled ? 1 : 2;
  }
  if (!(seen == state.seen)) state.seen = seen, state.seen_s = 0;
}

void Knot::take_places(toolkit::KnotWord word, KnotState& state) const {
  word.tied[0] = toolkit::KnotTouch(state.p_W, places_, 2 * radius_).up_to_loop(word.tied[0]);
  const double place = length_ / (params_.places - 1);
  int outer = 0;
  while (outer + 1 < word.throws && word.tied[static_cast<size_t>(outer + 1)].knot == word.tied[0].knot) ++outer;
  const toolkit::KnotThrow &first = word.tied[0], &last = word.tied[static_cast<size_t>(outer)];
  state.loop = place * (first.strand[1].first - first.strand[0].last);
  state.from = place * (first_ + last.strand[0].first);
  state.to = place * (first_ + last.strand[1].last);
  state.loosest = place * loosest(word);
}

void Knot::read(const CouplingStep& step, KnotState& state) {
  state.wait_s -= step.dt();
  if (state.reading == 0) {
    if (state.wait_s > 0) return;
    state.wait_s = params_.period;
    state.reading = state.thread.begin(state.p_W, places_);
    return;
  }
  toolkit::KnotName said;
  if (!reader_.read(state.thread, params_.work, said)) return;
  state.reading = 0;
  take(said, state);
}

/// Reports what has been read unchanged for `settle`: first throws that are undone, from the last on, then new ones.
void Knot::tell(const CouplingStep& step, KnotState& state) const {
  state.seen_s += step.dt();
  if (state.seen == state.told || state.seen_s < params_.settle) return;
  const KnotTold &old = state.told, &now = state.seen;
  if (now.tangled != 0) {
    if (old.tangled == 0) step.event(tangled_event_, now.tangled);
    state.told.tangled = now.tangled;  // the reported throws are kept
    return;
  }
  const auto count = [](const KnotTold& t) { return std::min(static_cast<int>(t.throws), KnotTold::kThrows); };
  int same = 0;
  while (same < count(old) && same < count(now) && old.tied[same] == now.tied[same]) ++same;
  for (int i = count(old); i-- > same;) step.event(untied_event_, old.tied[i]);
  for (int i = same; i < count(now); ++i) step.event(tied_event_, now.tied[i]);
  state.told = now;
}

void Knot::write(const CouplingStep& step, const KnotState& state) const {
  step.signal(throws_, state.told.throws);
  for (int i = 0; i < KnotTold::kThrows; ++i) step.signal(tied_[i], state.told.tied[i]);
  step.signal(kind_, static_cast<int>(kind_of(state.told)));
  step.signal(sliding_, state.sliding);
  const bool tied = state.told.throws > 0;
  step.signal(loop_, tied ? state.loop : 0);
  step.signal(from_, tied ? state.from : 0);
  step.signal(to_, tied ? state.to : 0);
  step.signal(loosest_, tied ? state.loosest : 0);
  step.signal(certain_, state.certain);
  step.signal(passages_, state.passages);
}

/// A step may be done in substeps. The thread is where the last substep and the free motion of this one have led it.
void Knot::resolve(const CouplingStep& step) {
  look(step, step.state<KnotState>());
  if (places_ > 1) find_passages(step.state<KnotState>());
}

void Knot::finish(const CouplingStep& step) {
  KnotState& state = step.state<KnotState>();
  look(step, state);
  if (places_ > 1) {
    find_passages(state);
    tell_passages(step, state);
    read(step, state);
    tell(step, state);
  }
  write(step, state);
}

}  // namespace swage::coupling_knot

SWAGE_EXPORT(swage::coupling_knot::Knot)
