// SPDX-License-Identifier: Apache-2.0
//
// What turns the volts of a jaw sensor into lengths, and lengths into the force of a hand (thesis 3.3). Pure arithmetic. [any]
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swage::sensor {

/// One row of a bench: the sensor was drawn to `length_m` and gave `volts`.
struct BenchPoint {
  double volts = 0, length_m = 0;
  double residual_m = 0;  // set by the fit: length of the fit minus that of the bench
  bool used = false;      // set by the fit: false where the sensor is beyond its stroke
};

/// length = slope volts + offset.
struct Displacement {
  double slope = 0;   // m/V
  double offset = 0;  // m
  double worst = 0, rms = 0;  // m, residuals of the points that were used
  std::vector<BenchPoint> points;
  bool valid() const { return slope != 0; }
  double length(double volts) const { return slope * volts + offset; }
};

struct FitLimits {
  // 0.7 % over 8 mm is the sensor's own non-linearity; with 1.9 um of resolution and a bench of 10 um it stays below this
  double worst = 60e-6;    // m
  double nominal = 1e-3;   // m/V, of the sensor's data sheet; 0: not known
  double most_off = 0.2;   // relative to nominal: beyond that the wrong range or the wrong sensor is connected
  std::size_t fewest = 7;  // points that a fit stands on
};

/// The straight line through the longest stretch of neighbouring points that all lie within `worst` of it: a sensor is irregular at the
/// ends of its stroke. "" or why there is none, as a sentence.
std::string fit_displacement(std::vector<BenchPoint> points, const FitLimits& limits, Displacement& out);

/// A curve through points that nowhere leaves the band between two neighbours: piecewise cubic, slopes after Fritsch and Carlson.
/// Beyond its ends it stays as it is there.
class MonotoneCurve {
 public:
  struct Point {
    double x = 0, y = 0;
  };
  /// 2 to 64 points; x goes up and y never goes down. "" or what is wrong, as a sentence.
  std::string set(std::vector<Point> points);
  bool empty() const { return points_.empty(); }
  const std::vector<Point>& points() const { return points_; }
  double value(double x) const;
  double slope(double x) const;  // 0 beyond the ends

 private:
  std::size_t piece(double x) const;
  std::vector<Point> points_;
  std::vector<double> slope_;
};

/// The sensor in the triangle of pivot and two swivels. Zeros: not measured, and the opening is taken as proportional to the length.
struct Geometry {
  double a = 0, b = 0;  // m, of the swivels from the pivot
  double gap = 0;       // m, between the swivels when the jaws are just closed
  bool known() const { return a > 0 && b > 0 && gap > 0; }
};

/// Lengths of the sensor in the three poses of a session, m.
struct Poses {
  double open = 0, closed = 0, squeezed = 0;
  bool known() const { return open != closed; }
};

/// "" or why these cannot be the three poses. `stored`: those of before, from which a span may differ by a fifth.
std::string check_poses(const Poses& poses, const Poses& stored);
/// How far a handle at this length is closed, as a share of the way from open to just closed; below 0 it is more open than open.
double closed_share(const Poses& poses, double length_m);
inline constexpr double kZeroShare = 0.03;      // within which a handle that is let go counts as open: 0.1 mm of a way of 3 mm
inline constexpr double kMostZeroShare = 0.2;   // beyond which no drift lies: a hand holds it, or it was mounted anew
/// Moves all three poses so that a handle which is let go at this length is open. "" or why it is too far off.
std::string set_zero(double length_m, Poses& poses);
inline constexpr double kZeroForce = 0.1;  // N at the handle that a gauge may tell while nobody presses
/// What a handle that keeps still in the first seconds of a session is off, as a sentence with what to do; "" while it is good, or in a hand.
/// `gauge_N`: beyond its zero, 0 without a gauge.
std::string rest_trouble(const Poses& poses, double length_m, double gauge_N);
/// "" or why this cannot be the needleholder.
std::string check_geometry(const Geometry& geometry, const Poses& poses);

/// What the tips were made to press on a gauge with a real needle between them, and what the calibration made of it.
struct TipCheck {
  double wanted = 0, measured = 0;  // N at the tips
  std::string date;
  bool known() const { return wanted > 0; }
};
inline constexpr double kCheckForce = 0.6;  // N, of a good grasp (thesis 3.3): where the calibration has to hold
inline constexpr double kCheckShare = 0.1;  // of it that the calibration may be off; a scale and a hand are good for 0.03
/// "" or by how much it is off, as a sentence.
std::string check_tip(const TipCheck& check);

/// All that is known of one sensor in one needleholder.
struct Calibration {
  std::string serial, name;       // of the sensor
  std::string date, by, expires;  // 2026-11-22
  Displacement displacement;
  MonotoneCurve force;  // N at the handle over m of travel after the jaws have met
  MonotoneCurve tip;    // N at the tips over N at the handle beyond what closes it
  TipCheck check;
  Geometry geometry;
  Poses poses;
  std::string poses_date, zero_date;  // when the poses were measured, and when only their zero was set since then
  double gauge_zero = 0;              // N that a gauge on the handle tells while nobody presses
};

/// A table of forces as people measure it: 5 to 11 points. "" or what is wrong, as a sentence.
std::string check_table_size(std::size_t points);
/// The curve of the tips from points (N at the handle beyond what closes it, N at the tips) in any order; nothing presses before the
/// jaws meet, so (0, 0) is one of them. "" or what is wrong.
std::string set_tip(std::vector<MonotoneCurve::Point> points, MonotoneCurve& out);

/// "" or a sentence: too old, or for another sensor. Dates as 2026-11-22.
std::string calibration_trouble(const Calibration& calibration, const std::string& serial, const std::string& today);

/// How far a handle is closed, and how hard it is squeezed.
class Handle {
 public:
  struct Held {
    double width = 0;  // m, of what is between the jaws
    double reach = 1;  // m, from the pivot to where it is held
  };
  struct Grip {
    double closure = 0;  // 0 open .. `meets` just closed .. 1 squeezed
    double force = 0;    // N at the handle, beyond what closes it; 0 until the jaws touch what is held
    double tip = 0;      // N at the tips; 0 without a table of them
  };
  /// `meets`: closure at which empty jaws of the scene meet.
  void set(const Calibration& calibration, double meets, const Held& held);
  Grip at(double length_m) const;
  /// N at the tips for N at the handle beyond what closes it; 0 without a table.
  double tip(double handle_N) const { return tip_.empty() ? 0 : tip_.value(handle_N); }
  double contact() const { return contact_; }  // m, length at which the jaws touch what is held

 private:
  double angle(double length_m) const;  // rad between the handles, 0 when the jaws meet; lengths where there is no geometry
  Poses poses_;
  Geometry geometry_;
  MonotoneCurve force_, tip_;
  double meets_ = 0.6, contact_ = 0, open_angle_ = 1;
};

}  // namespace swage::sensor
