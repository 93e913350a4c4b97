// SPDX-License-Identifier: Apache-2.0
//
// Conversion of the volts of a jaw sensor to lengths, and of lengths to the force of a hand (thesis 3.3). Pure arithmetic. [any]
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swage::sensor {

/// One row of a bench: the sensor was set to `length_m` and gave `volts`.
struct BenchPoint {
  double volts = 0, length_m = 0;
  double residual_m = 0;  // set by the fit: length of the fit minus that of the bench
  bool used = false;      // set by the fit: false where the sensor is outside its stroke
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
  // 0.7 % over 8 mm is the sensor's own non-linearity; with 1.9 um of resolution and a bench of 10 um residuals stay below this
  double worst = 60e-6;    // m
  double nominal = 1e-3;   // m/V, of the sensor's data sheet; 0: not known
  double most_off = 0.2;   // relative to nominal: beyond this the wrong range or the wrong sensor is connected
  std::size_t fewest = 7;  // least number of points of a fit
};

/// Fits a straight line to the longest run of neighbouring points that all lie within `worst` of it: a sensor is non-linear at the
/// ends of its stroke. "" or the reason why there is none, as a sentence.
std::string fit_displacement(std::vector<BenchPoint> points, const FitLimits& limits, Displacement& out);

/// A monotone curve through points: piecewise cubic, slopes after Fritsch and Carlson, so that it stays between neighbouring values.
/// Constant beyond its ends.
class MonotoneCurve {
 public:
  struct Point {
    double x = 0, y = 0;
  };
  /// 2 to 64 points; x increases and y never decreases. "" or the fault, as a sentence.
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

/// The sensor in the triangle of pivot and two swivels. Zeros: not measured; the opening is then taken as proportional to the length.
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

/// "" or the reason why these cannot be the three poses. `stored`: the former ones, from which a span may differ by a fifth.
std::string check_poses(const Poses& poses, const Poses& stored);
/// Closure of a handle at this length, as a share of the travel from open to just closed; below 0 it is more open than the open pose.
double closed_share(const Poses& poses, double length_m);
inline constexpr double kZeroShare = 0.03;      // a released handle counts as open within this: 0.1 mm of a travel of 3 mm
inline constexpr double kMostZeroShare = 0.2;   // larger than any drift: a hand holds the handle, or the sensor was remounted
/// Shifts all three poses so that the released handle at this length is open. "" or the reason why it is too far off.
std::string set_zero(double length_m, Poses& poses);
inline constexpr double kZeroForce = 0.1;  // N at the handle that a gauge may show while it is released
/// Zero error of a handle that rests in the first seconds of a session, as a sentence with the remedy; "" while it is good, or in a hand.
/// `gauge_N`: force above the gauge's zero, 0 without a gauge.
std::string rest_trouble(const Poses& poses, double length_m, double gauge_N);
/// "" or the reason why this cannot be the needleholder.
std::string check_geometry(const Geometry& geometry, const Poses& poses);

/// Check with a force gauge: force of the tips on it with a real needle between them, and the force by the calibration.
struct TipCheck {
  double wanted = 0, measured = 0;  // N at the tips
  std::string date;
  bool known() const { return wanted > 0; }
};
inline constexpr double kCheckForce = 0.6;  // N, of a good grasp (thesis 3.3): where the calibration must be valid
inline constexpr double kCheckShare = 0.1;  // admissible error of the calibration, relative; a scale and a hand are accurate to 0.03
/// "" or the error, as a sentence.
std::string check_tip(const TipCheck& check);

/// Everything known about one sensor in one needleholder.
struct Calibration {
  std::string serial, name;       // of the sensor
  std::string date, by, expires;  // 2026-11-22
  Displacement displacement;
  MonotoneCurve force;  // N at the handle over m of travel after the jaws have met
  MonotoneCurve tip;    // N at the tips over N at the handle beyond what closes it
  TipCheck check;
  Geometry geometry;
  Poses poses;
  std::string poses_date, zero_date;  // date of the poses; date of the last change of their zero alone
  double gauge_zero = 0;              // N that a gauge on the handle shows while it is released
};

/// A table of forces as usually measured: 5 to 11 points. "" or the fault, as a sentence.
std::string check_table_size(std::size_t points);
/// The curve of the tip forces from points (N at the handle beyond the closing force, N at the tips) in any order; there is no force
/// before the jaws meet, so (0, 0) is one of them. "" or the fault.
std::string set_tip(std::vector<MonotoneCurve::Point> points, MonotoneCurve& out);

/// "" or a sentence: too old, or for another sensor. Dates as 2026-11-22.
std::string calibration_trouble(const Calibration& calibration, const std::string& serial, const std::string& today);

/// Closure of a handle, and force on it.
class Handle {
 public:
  struct Held {
    double width = 0;  // m, of the object between the jaws
    double reach = 1;  // m, from the pivot to the object
  };
  struct Grip {
    double closure = 0;  // 0 open .. `meets` just closed .. 1 squeezed
    double force = 0;    // N at the handle, beyond the closing force; 0 until the jaws touch the held object
    double tip = 0;      // N at the tips; 0 without a table of tip forces
  };
  /// `meets`: closure at which empty jaws of the scene meet.
  void set(const Calibration& calibration, double meets, const Held& held);
  Grip at(double length_m) const;
  /// N at the tips for N at the handle beyond the closing force; 0 without a table.
  double tip(double handle_N) const { return tip_.empty() ? 0 : tip_.value(handle_N); }
  double contact() const { return contact_; }  // m, length at which the jaws touch the held object

 private:
  double angle(double length_m) const;  // rad between the handles, 0 when the jaws meet; a length where the geometry is unknown
  Poses poses_;
  Geometry geometry_;
  MonotoneCurve force_, tip_;
  double meets_ = 0.6, contact_ = 0, open_angle_ = 1;
};

}  // namespace swage::sensor
