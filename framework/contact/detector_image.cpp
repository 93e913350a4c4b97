// SPDX-License-Identifier: Apache-2.0
//
// The detector's part of the saved state.
#include "contact/detector.hpp"

namespace swage::contact {
namespace {

/// One contact as plain numbers; candidates are computed again after loading.
struct Record {
  uint64_t pair, shape_a, shape_b, body_a, body_b, feature;
  swage_vec3 p_W, n_W, bristle_W, f_a_W;
  double gap, weight, slip, friction, stiffness, restitution;
};

Record record(const Contact& c) {
  return {c.pair,
          c.shape_a,
          c.shape_b,
          c.body_a,
          c.body_b,
          c.feature,
          toolkit::raw(c.p_W),
          toolkit::raw(c.n_W),
          toolkit::raw(c.bristle_W),
          toolkit::raw(c.f_a_W),
          c.gap,
          c.weight,
          c.slip,
          c.law.friction,
          c.law.stiffness,
          c.law.restitution};
}

Contact contact(const Record& r) {
  Contact c;
  c.pair = static_cast<uint32_t>(r.pair);
  c.shape_a = static_cast<uint32_t>(r.shape_a), c.shape_b = static_cast<uint32_t>(r.shape_b);
  c.body_a = static_cast<uint32_t>(r.body_a), c.body_b = static_cast<uint32_t>(r.body_b);
  c.feature = r.feature;
  c.p_W = toolkit::vec(r.p_W), c.n_W = toolkit::vec(r.n_W);
  c.bristle_W = toolkit::vec(r.bristle_W), c.f_a_W = toolkit::vec(r.f_a_W);
  c.gap = r.gap, c.weight = r.weight, c.slip = r.slip;
  c.law = {r.friction, r.stiffness, r.restitution};
  return c;
}

/// Place on a chain, saved for contacts of chains only.
struct PlaceRecord {
  uint64_t segment;
  double share, s;
};
PlaceRecord record(const ChainPlace& p) { return {p.segment, p.share, p.s}; }
ChainPlace place(const PlaceRecord& r) { return {static_cast<uint32_t>(r.segment), r.share, r.s}; }

}  // namespace

void Detector::save(const ContactSet& set, scene::Writer& out) const noexcept {
  out.put(uint64_t{shape_pairs_.size()});
  for (const ShapePair& pair : shape_pairs_)
    if (pair.remembers) out.put(toolkit::raw(pair.memory.n_B));
  out.put(uint64_t{set.contact.size()});
  for (const Contact& c : set.contact) {
    out.put(record(c));
    if (is_chain(c.shape_a)) out.put(record(c.place_a));
    if (is_chain(c.shape_b)) out.put(record(c.place_b));
  }
  out.put(uint64_t{set.of_pair.size()});
  for (const scene::Range& range : set.of_pair) out.put(range);
}

bool Detector::restore(ContactSet& set, scene::Reader& in) noexcept {
  uint64_t n = 0;
  in.get(n);
  if (!in.ok() || n != shape_pairs_.size()) return false;
  for (ShapePair& pair : shape_pairs_) {
    if (!pair.remembers) continue;
    swage_vec3 n_B{};
    in.get(n_B);
    pair.memory.n_B = toolkit::vec(n_B);
  }
  in.get(n);
  if (!in.ok() || n > options_.capacity) return false;
  set.contact.clear();
  set.candidate.clear();
  for (uint64_t i = 0; i < n; ++i) {
    Record r{};
    in.get(r);
    if (r.pair >= pairs_.size() || r.shape_a >= solids_.size() || r.shape_b >= solids_.size()) return false;
    Contact c = contact(r);
    for (const bool is_a : {true, false}) {
      if (!is_chain(is_a ? c.shape_a : c.shape_b)) continue;
      PlaceRecord found{};
      in.get(found);
      (is_a ? c.place_a : c.place_b) = place(found);
    }
    set.contact.push_back(c);
    set.candidate.emplace_back();
  }
  in.get(n);
  if (!in.ok() || n > pairs_.size()) return false;
  set.of_pair.clear();
  for (uint64_t i = 0; i < n; ++i) {
    scene::Range range;
    in.get(range);
    set.of_pair.push_back(range);
  }
  return in.ok();
}

size_t Detector::image_size() const {
  return 3 * sizeof(uint64_t) + shape_pairs_.size() * sizeof(swage_vec3) +
         options_.capacity * (sizeof(Record) + 2 * sizeof(PlaceRecord)) + pairs_.size() * sizeof(scene::Range);
}

}  // namespace swage::contact
