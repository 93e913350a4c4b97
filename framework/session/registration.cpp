// SPDX-License-Identifier: Apache-2.0
#include "session/registration.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "session/sentences.hpp"
#include "toolkit/math.hpp"

namespace swage::session {

using toolkit::Mat3;
using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

namespace {

std::string millimetres(double m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g mm", 1e3 * m);
  return text;
}

Vec3 middle(std::span<const Touched> points, swage_vec3 Touched::* of) {
  Vec3 sum = Vec3::Zero();
  for (const Touched& t : points) sum += toolkit::vec(t.*of);
  return sum / static_cast<double>(points.size());
}

// rms distance from the line of best fit
double spread(std::span<const Touched> points, swage_vec3 Touched::* of, const Vec3& centre) {
  Mat3 around = Mat3::Zero();
  for (const Touched& t : points) {
    const Vec3 r = toolkit::vec(t.*of) - centre;
    around += r * r.transpose();
  }
  const Vec3 axes = Eigen::JacobiSVD<Mat3>(around).singularValues();
  return std::sqrt((axes[1] + axes[2]) / static_cast<double>(points.size()));
}

}  // namespace

std::string fit_registration(std::span<const Touched> points, Registration& out) {
  if (points.size() < 3) return say::kFewPoints(points.size());
  for (const Touched& t : points)
    if (!toolkit::vec(t.p_S).allFinite() || !toolkit::vec(t.p_D).allFinite()) return say::kPointNoNumber();
  const Vec3 c_S = middle(points, &Touched::p_S), c_D = middle(points, &Touched::p_D);
  const double least = std::min(spread(points, &Touched::p_S, c_S), spread(points, &Touched::p_D, c_D));
  if (least < kLeastSpread)
    return say::kOneLine(millimetres(least), millimetres(kLeastSpread));
  Mat3 cross = Mat3::Zero();
  for (const Touched& t : points) cross += (toolkit::vec(t.p_S) - c_S) * (toolkit::vec(t.p_D) - c_D).transpose();
  const Eigen::JacobiSVD<Mat3> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double hand = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;  // excludes reflections
  const Mat3 R_SD = svd.matrixU() * Vec3(1, 1, hand).asDiagonal() * svd.matrixV().transpose();
  Registration found;
  const Pose X_SD(Vec3(c_S - R_SD * c_D), Quat(R_SD).normalized());
  found.X_SD = X_SD.abi();
  for (const Touched& t : points) {
    const double off = (X_SD * Vec3(toolkit::vec(t.p_D)) - toolkit::vec(t.p_S)).norm();
    found.worst = std::max(found.worst, off);
    found.rms += off * off / static_cast<double>(points.size());
  }
  found.rms = std::sqrt(found.rms);
  if (found.worst > kMostResidual)
    return say::kPointOff(millimetres(found.worst), millimetres(kMostResidual));
  out = found;
  return "";
}

swage_pose place_device(const Registration& registration, const swage_vec3& p_WS, const swage_quat& q_WS, double scale) {
  const Pose X_SD(registration.X_SD);
  const Quat R_WS = toolkit::quat(q_WS);
  return Pose(Vec3(toolkit::vec(p_WS) + R_WS * X_SD.p / scale), (R_WS * X_SD.q).normalized()).abi();
}

}  // namespace swage::session
