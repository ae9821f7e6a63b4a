/*=========================================================================
 *
 *  Copyright The DentalSCR authors
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef itkPoseCovarianceReference_h
#define itkPoseCovarianceReference_h

#include "vnl/algo/vnl_matrix_inverse.h"
#include "vnl/vnl_matrix.h"
#include "vnl/vnl_vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

/** The uncertainty of a pose as Documentation/Robust.md writes it: dense matrices, derivatives by differences, and none
 * of the toolkit's classes, so that whatever computes it can be compared. */
namespace PoseCovarianceReference
{
/** Pitch, roll, yaw (rad), tx, ty, tz (mm), kappa. */
using Parameters = std::array<double, 7>;
using Point = std::array<double, 3>;
using Place = std::array<double, 2>;
using Projection = std::function<Place(const Parameters &)>;

struct Imaging
{
  double sourceToMidsagittal;
  double sourceToDetector;
  /** +1: source on the patient's right. */
  double sourceSign;
  /** +1: facing right in the image. */
  double facingSign;
  Place  pixelSpacing;
  Place  principalPoint;
};

/** c = Ry Rx Rz p + t, m = exp(kappa) D / ((S + k c_y) 0.25), w = (m c_x, -m c_z): working plane, units of 0.25 mm. */
inline Place
ProjectToWorkingPlane(const Imaging & imaging, const Parameters & q, const Point & p)
{
  const double yawed[3] = { std::cos(q[2]) * p[0] - std::sin(q[2]) * p[1],
                            std::sin(q[2]) * p[0] + std::cos(q[2]) * p[1],
                            p[2] };
  const double rolled[3] = { yawed[0],
                             std::cos(q[1]) * yawed[1] - std::sin(q[1]) * yawed[2],
                             std::sin(q[1]) * yawed[1] + std::cos(q[1]) * yawed[2] };
  const double x = std::cos(q[0]) * rolled[0] + std::sin(q[0]) * rolled[2] + q[3];
  const double y = rolled[1] + q[4];
  const double z = -std::sin(q[0]) * rolled[0] + std::cos(q[0]) * rolled[2] + q[5];
  const double m =
    std::exp(q[6]) * imaging.sourceToDetector / ((imaging.sourceToMidsagittal + imaging.sourceSign * y) * 0.25);
  return { { m * x, -m * z } };
}

/** w = ((u - pp_u) f sp_u, (v - pp_v) sp_v) / 0.25, solved for the pixel. */
inline Place
ProjectToPixel(const Imaging & imaging, const Parameters & q, const Point & p)
{
  const Place w = ProjectToWorkingPlane(imaging, q, p);
  return { { imaging.principalPoint[0] + imaging.facingSign * 0.25 * w[0] / imaging.pixelSpacing[0],
             imaging.principalPoint[1] + 0.25 * w[1] / imaging.pixelSpacing[1] } };
}

/** 2 x 7, by central differences: steps that move a point by some hundredths of a pixel leave 1e-7 of the derivative.
 */
inline vnl_matrix<double>
Differentiate(const Projection & project, const Parameters & at)
{
  const double       steps[7] = { 1e-4, 1e-4, 1e-4, 1e-2, 1e-2, 1e-2, 1e-4 };
  vnl_matrix<double> jacobian(2, 7);
  for (unsigned int k = 0; k < 7; ++k)
  {
    Parameters after = at;
    Parameters before = at;
    after[k] += steps[k];
    before[k] -= steps[k];
    const Place a = project(after);
    const Place b = project(before);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
      jacobian(axis, k) = (a[axis] - b[axis]) / (2.0 * steps[k]);
    }
  }
  return jacobian;
}

/** Covariance of a projected point: 2 x 2. */
inline vnl_matrix<double>
ProjectCovariance(const Projection & project, const Parameters & at, const vnl_matrix<double> & covariance)
{
  const vnl_matrix<double> jacobian = Differentiate(project, at);
  return jacobian * covariance * jacobian.transpose();
}

/** Log density, but for a constant, of Student's t with so many degrees of freedom and this standard deviation. */
inline double
LogDensityOfT(double x, double sigma, double freedom)
{
  const double scale = sigma * std::sqrt((freedom - 2.0) / freedom);
  return -0.5 * (freedom + 1.0) * std::log1p(x * x / (freedom * scale * scale));
}

/** Precision of the parabola that touches minus the log density at x and has its middle at 0: -(d log p / dx) / x. */
inline double
TangentPrecisionOfT(double x, double sigma, double freedom)
{
  // Where x is 0, the limit.
  const double at = std::max(std::abs(x), 1e-3 * sigma);
  const double step = 1e-4 * at;
  return -(LogDensityOfT(at + step, sigma, freedom) - LogDensityOfT(at - step, sigma, freedom)) / (2.0 * step) / at;
}

/** The same scaled so that it is that of the distribution's variance at 0: what a covariance is told. */
inline double
VariancePrecisionOfT(double x, double sigma, double freedom)
{
  return TangentPrecisionOfT(x, sigma, freedom) / (TangentPrecisionOfT(0.0, sigma, freedom) * sigma * sigma);
}

/** Residuals of one strand, their derivatives by the seven parameters, and what their noise depends on. */
struct Strand
{
  std::vector<double> arc;
  std::vector<double> nu;
  std::vector<double> nv;
  /** The robust kernel's times the tracing's own. */
  std::vector<double> weights;
  std::vector<double> residuals;
  /** n x 7 */
  vnl_matrix<double> jacobian;
};

/** Cov(r_i, r_j) = s_c^2 exp(-(s_i - s_j)^2 / 2 l^2) n_i n_j + delta_ij s_w^2 / w_i; no correlation where l is 0. */
inline vnl_matrix<double>
NoiseCovariance(const Strand & strand, double length, double smooth, double white)
{
  const auto         n = static_cast<unsigned int>(strand.arc.size());
  vnl_matrix<double> k(n, n);
  for (unsigned int i = 0; i < n; ++i)
  {
    for (unsigned int j = 0; j < n; ++j)
    {
      const double d = strand.arc[i] - strand.arc[j];
      const double correlation = length > 0.0 ? std::exp(-0.5 * d * d / (length * length)) *
                                                  (strand.nu[i] * strand.nu[j] + strand.nv[i] * strand.nv[j])
                                              : (i == j ? 1.0 : 0.0);
      k(i, j) = smooth * smooth * correlation;
    }
    k(i, i) += white * white / std::max(strand.weights[i], 1e-6);
  }
  return k;
}

/** J' K^-1 J over the strands, and the priors' precisions on the diagonal. */
inline vnl_matrix<double>
Information(
  const std::vector<Strand> & strands, double length, double smooth, double white, const Parameters & precision)
{
  vnl_matrix<double> information(7, 7, 0.0);
  for (unsigned int k = 0; k < 7; ++k)
  {
    information(k, k) = precision[k];
  }
  for (const Strand & strand : strands)
  {
    const vnl_matrix<double> inverse =
      vnl_matrix_inverse<double>(NoiseCovariance(strand, length, smooth, white)).inverse();
    information += strand.jacobian.transpose() * inverse * strand.jacobian;
  }
  return information;
}

/** Covariance of the parameters: those that are held have a width of their own (held[k] > 0), which the estimated ones
 * follow; a parameter of precision infinity is known. The inflation is a factor on the estimated ones' sigmas. */
inline vnl_matrix<double>
Covariance(const vnl_matrix<double> &  information,
           const Parameters &          held,
           const std::array<bool, 7> & known,
           double                      inflation)
{
  std::vector<unsigned int> estimated;
  for (unsigned int k = 0; k < 7; ++k)
  {
    if (!(held[k] > 0.0) && !known[k])
    {
      estimated.push_back(k);
    }
  }
  const auto         n = static_cast<unsigned int>(estimated.size());
  vnl_matrix<double> covariance(7, 7, 0.0);
  vnl_matrix<double> inverse(n, n);
  if (n > 0)
  {
    vnl_matrix<double> part(n, n);
    for (unsigned int a = 0; a < n; ++a)
    {
      for (unsigned int b = 0; b < n; ++b)
      {
        part(a, b) = information(estimated[a], estimated[b]);
      }
    }
    inverse = vnl_matrix_inverse<double>(part).inverse();
    for (unsigned int a = 0; a < n; ++a)
    {
      for (unsigned int b = 0; b < n; ++b)
      {
        covariance(estimated[a], estimated[b]) = inflation * inflation * inverse(a, b);
      }
    }
  }
  for (unsigned int h = 0; h < 7; ++h)
  {
    if (!(held[h] > 0.0))
    {
      continue;
    }
    // Where the best fit goes when the held parameter is off by one.
    vnl_vector<double> follows(7, 0.0);
    follows[h] = 1.0;
    for (unsigned int a = 0; a < n; ++a)
    {
      for (unsigned int b = 0; b < n; ++b)
      {
        follows[estimated[a]] -= inverse(a, b) * information(estimated[b], h);
      }
    }
    covariance += held[h] * held[h] * outer_product(follows, follows);
  }
  return covariance;
}

/** Geman and McClure's weight of a distance. */
inline double
RobustWeight(double distance, double width)
{
  const double share = width * width / (width * width + distance * distance);
  return share * share;
}
} // namespace PoseCovarianceReference

#endif
