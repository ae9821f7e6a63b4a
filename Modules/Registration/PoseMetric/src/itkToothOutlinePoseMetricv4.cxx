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
#include "itkToothOutlinePoseMetricv4.h"

#include "itkContourNoiseModel.h"
#include "itkFrontalToothOutline.h"
#include "itkGemanMcClureKernel.h"
#include "itkPoseContourIndex.h"
#include "itkPoseMatching.h"
#include "itkPoseToothContourModel.h"
#include "itkWholeToothOutline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace itk
{
namespace
{
constexpr std::size_t NoMatch = PoseContourIndex::None;
constexpr std::size_t NumberOfErrors = 6;
/** Positions of front teeth, of which an analysis draws the most prominent; behind them it draws between the images. */
constexpr unsigned int LastFrontTooth = 3;
/** On a frontal radiograph: cosine between the arch at each position, 1 to 8, and the film. In the front the arch runs
 * along it, from the canine on it turns into the depth. */
constexpr double ArchAlongFilm[8] = { 1.0, 0.95, 0.8, 0.5, 0.4, 0.3, 0.3, 0.3 };
/** px a unit normal in the matching, as of a tracing's points (PoseSilhouetteSettings::orientationWeight). */
constexpr double OrientationWeight = 8.0;
/** Smallest width of the points' robust kernel, px: 1 mm, what lies further from its tooth's outline is not of it. */
constexpr double PointWidth = 4.0;
/** The width follows the spread of the points where it is larger, far from the solution: so many standard deviations,
 * which are 1.48 medians. */
constexpr double WidthInSigmas = 2.5;
constexpr double SigmaOfMedian = 1.48;
/** Width of the teeth's robust kernel, standard deviations, as of landmarks. */
constexpr double ToothWidthInSigmas = 4.0;
/** Rounds of matching in which a tooth finds how far it is beside its crown, and weight of a shift of 0 beside points,
 * (1 px / 12 px)^2: a jaw that was placed from the side alone may lie 3 mm beside its frontal image, and the nearest
 * sample of a crown is then one of its other end. */
constexpr int    ShiftRounds = 4;
constexpr double ShiftRidge = 1.0 / 144.0;
/** Fewest teeth that have a spread. As of points the width follows it where it is larger: a jaw that is still some
 * millimetres beside its place is off with all of its teeth, and is not to be caught by the one that happens to fit. */
constexpr std::size_t FewestTeethWithASpread = 4;
/** No weight is quite 0: the covariance is inverted. */
constexpr double SmallestToothWeight = 1e-4;
/** Component along the arch of a normal above which its point is at an end of the tooth. */
constexpr double CutFacing = 0.5;
/** By which the deviance of a jaw's templates has to be less: three of ten readers use templates, and what is not quite
 * a tooth's shape may also be how its crown was cut out of the scan. */
constexpr double TemplatePenalty = 12.0;
/** Of a template's error along the arch: a front tooth's tip is what it is placed by. */
constexpr double TipShare = 0.4;
/** Rounds of weights and errors in one update: each settles the other, and optimizer runs follow. */
constexpr int Rounds = 3;

/** mm by which a tooth's outline and its crown differ where no hand is wrong: part of a shift's error. */
constexpr double OutlineSigma = 0.25;

/** mm along the dental frame's z. */
double
ComputeHeight(const TriangleSurface & crown)
{
  const auto range = std::minmax_element(
    crown.points.begin(), crown.points.end(), [](const auto & a, const auto & b) { return a[2] < b[2]; });
  return (*range.second)[2] - (*range.first)[2];
}

/** The samples of a crown's outline as one line, in pixels, that begins behind the widest gap: where it was cut. */
std::vector<std::array<double, 2>>
MakeOpenLine(const PoseContour & contour, const PoseGeometry & geometry)
{
  const std::size_t n = contour.Size();
  std::size_t       begin = 0;
  double            widest = -1.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t before = (i + n - 1) % n;
    const double      gap = std::hypot(contour.u[i] - contour.u[before], contour.v[i] - contour.v[before]);
    if (gap > widest)
    {
      widest = gap;
      begin = i;
    }
  }
  std::vector<std::array<double, 2>> line;
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::size_t i = (begin + k) % n;
    line.push_back(PoseModel::ToPixel(geometry, { { contour.u[i], contour.v[i] } }));
  }
  return line;
}

/** The drawing error that the file gives an outline, mm on the detector; 0 where it gives none. */
double
ComputeSigma(const DentalContour::PolylineType & polyline, const PoseGeometry & geometry)
{
  double squares = 0.0, count = 0.0;
  for (const double sigma : polyline.sigmas)
  {
    squares += sigma * sigma;
    count += sigma > 0.0 ? 1.0 : 0.0;
  }
  return count > 0.0 ? std::sqrt(squares / count * 0.5 *
                                 (geometry.pixelSpacing[0] * geometry.pixelSpacing[0] +
                                  geometry.pixelSpacing[1] * geometry.pixelSpacing[1]))
                     : 0.0;
}

/** What of a shift's error is the hand's: the square of it, without what crown and outline differ by anyway. */
double
ComputeHandVariance(double error)
{
  return std::max(0.0, error * error - OutlineSigma * OutlineSigma);
}

/** The errors of a hand of which the file says how far it is off with the tooth: what the points of one tooth share,
 * they do not average away, and who is off in place is off in turn and size. */
ToothOutlinePoseMetricv4::ErrorsType
WithSigma(ToothOutlinePoseMetricv4::ErrorsType errors, double sigma)
{
  if (sigma > 0.0)
  {
    const double along = ComputeHandVariance(errors.along), across = ComputeHandVariance(errors.across);
    const double usual = std::sqrt(0.5 * (along + across));
    if (usual > 0.0)
    {
      const double share = sigma / usual;
      errors.along = std::hypot(share * std::sqrt(along), OutlineSigma);
      errors.across = std::hypot(share * std::sqrt(across), OutlineSigma);
      errors.turn *= share;
      errors.size *= share;
    }
  }
  return errors;
}
} // namespace

void
ToothOutlinePoseMetricv4::SetErrors(const ErrorsType & errors)
{
  if (!(errors.along > 0.0) || !(errors.across > 0.0) || !(errors.turn > 0.0) || !(errors.size > 0.0) ||
      !(errors.templateTurn > 0.0) || !(errors.templateSize > 0.0) || !(errors.templateAlong >= 0.0) ||
      !(errors.templateAcross >= 0.0) || !(errors.lingual > 0.0) || !(errors.drift > 0.0) || !(errors.jitter > 0.0) ||
      !(errors.frontalJitter > 0.0))
  {
    itkExceptionMacro("Errors of outlines are standard deviations and must be positive: see SetErrors().");
  }
  m_Errors = errors;
  this->Modified();
}

void
ToothOutlinePoseMetricv4::SetMarkedTeeth(const std::vector<ToothCode> & teeth)
{
  if (m_MarkedTeeth != teeth)
  {
    m_MarkedTeeth = teeth;
    this->Modified();
  }
}

void
ToothOutlinePoseMetricv4::SetDrawing(DrawingEnum drawing)
{
  if (m_Drawing != drawing)
  {
    m_Drawing = drawing;
    m_Noise.clear();
    this->SettingsChanged();
  }
}

void
ToothOutlinePoseMetricv4::SetExcludedTeeth(const std::vector<std::uint8_t> & teeth)
{
  if (m_ExcludedTeeth != teeth)
  {
    m_ExcludedTeeth = teeth;
    this->Modified();
  }
}

void
ToothOutlinePoseMetricv4::Prepare()
{
  Superclass::InitializeTerm();
  if (this->GetCrowns() == nullptr)
  {
    itkExceptionMacro("No crowns of the scan: call SetCrowns() with a ToothCrownSet in its dental frame, as "
                      "ToothCrownFilter finds them.");
  }
  if (this->GetFixedContour() == nullptr)
  {
    itkExceptionMacro("No outlines: call SetFixedContour() with the tracing of this jaw.");
  }
  m_Noise.clear();
  m_LastPosition.clear();
  m_Hold = HoldEnum::Nothing;
  const ModifiedTimeType time = std::max({ this->Object::GetMTime(),
                                           this->GetTransform()->GetMTime(),
                                           this->GetCrowns()->GetMTime(),
                                           this->GetFixedContour()->GetMTime() });
  if (m_Teeth && m_TeethTime >= time)
  {
    return;
  }
  m_Failure.clear();
  m_Unused.clear();
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  const bool           upper = m_Jaw == JawEnum::Upper;
  const double         perMillimetre = 1.0 / PoseWorkingPixel;
  const double         magnification = geometry.sourceToDetector / geometry.sourceToMidsagittal;
  const bool           isFrontal = this->IsFrontal();
  auto                 teeth = std::make_shared<TeethType>();
  for (const auto & polyline : this->GetFixedContour()->GetPolylines())
  {
    const unsigned int position = polyline.code.GetPosition();
    ToothType          tooth;
    tooth.code = polyline.code;
    tooth.name = isFrontal ? polyline.code.GetName() : (upper ? "U" : "L") + std::to_string(position);
    if (!polyline.code.IsKnown())
    {
      m_Unused.push_back({ "without a code", "nothing says which tooth it is of" });
      continue;
    }
    if (std::find(m_ExcludedTeeth.begin(), m_ExcludedTeeth.end(), polyline.code.GetFDI()) != m_ExcludedTeeth.end())
    {
      m_Unused.push_back({ tooth.name, "its tooth is excluded" });
      continue;
    }
    const auto sameName = [&](const ToothType & other) { return other.name == tooth.name; };
    if (std::any_of(teeth->begin(), teeth->end(), sameName))
    {
      m_Unused.push_back({ tooth.name, "there is an outline of this tooth already" });
      continue;
    }
    std::vector<std::shared_ptr<const TriangleSurface>> crowns;
    double                                              sigmaAlong = 0.0;
    double                                              sigmaWidth = 0.0;
    double                                              height = NumericTraits<double>::max();
    const ToothCode right(10 * ((upper ? 1U : 4U) + (polyline.code.IsPrimary() ? 4U : 0U)) + position);
    const auto      codes =
      isFrontal ? std::vector<ToothCode>{ polyline.code } : std::vector<ToothCode>{ right, right.GetContralateral() };
    for (const ToothCode & code : codes)
    {
      if (const auto * crown = this->GetCrowns()->Find(code))
      {
        crowns.push_back(crown->profile && !isFrontal ? crown->profile : crown->surface);
        sigmaAlong = std::max(sigmaAlong, crown->sigmaAlong);
        sigmaWidth = std::max(sigmaWidth, crown->sigmaWidth);
        height = std::min(height, ComputeHeight(*crowns.back()));
      }
    }
    std::shared_ptr<const ToothOutline> outline;
    if (isFrontal)
    {
      outline = std::make_shared<const FrontalToothOutline>(geometry, polyline, m_Jaw);
    }
    else
    {
      outline =
        std::make_shared<const WholeToothOutline>(geometry, polyline, m_Jaw, magnification * perMillimetre * height);
    }
    if (!outline->GetFailure().empty())
    {
      m_Unused.push_back({ tooth.name, outline->GetFailure() });
      continue;
    }
    if (crowns.empty())
    {
      m_Unused.push_back({ tooth.name, "its crown was not found on the scan" });
      continue;
    }
    const bool marked = std::any_of(m_MarkedTeeth.begin(), m_MarkedTeeth.end(), [&](const ToothCode & code) {
      return isFrontal ? code == polyline.code : code.GetPosition() == position;
    });
    if (sigmaAlong > m_MaximumCutSigma && (marked || !isFrontal))
    {
      m_Unused.push_back(
        { tooth.name,
          "the crown is known by a textbook's place along the arch alone, of which a landmark tells as "
          "much: give tooth labels or landmarks_3d" });
      continue;
    }
    const bool front = position <= LastFrontTooth;
    tooth.outline = outline;
    // From the side it is a back tooth that has neighbours before and behind it, from the front it is a front tooth.
    tooth.endsAreCut = front == isFrontal;
    try
    {
      tooth.model = std::make_shared<const PoseToothContourModel>(
        crowns, front ? LandmarkCounterpartSet::RuleEnum::Foremost : LandmarkCounterpartSet::RuleEnum::Middle, m_Jaw);
    }
    catch (const std::invalid_argument & error)
    {
      itkExceptionMacro("The crown of " << tooth.name << " cannot be used: " << error.what()
                                        << " Read or build its mesh again.");
    }
    const ErrorsType errors = WithSigma(m_Errors, ComputeSigma(polyline, geometry));
    // A mark shares what the hand got wrong; where the crown was cut and what a template is placed by it does not.
    const auto sharedVariance = [&](double error) {
      return marked ? SharedErrorShare * ComputeHandVariance(error) * perMillimetre * perMillimetre : 0.0;
    };
    const double ofArch = isFrontal ? ArchAlongFilm[position - 1] : 1.0;
    const double along = std::hypot(errors.along, magnification * ofArch * sigmaAlong) * perMillimetre;
    const double across = errors.across * perMillimetre;
    const double lingual = m_Errors.lingual * perMillimetre;
    const double width = magnification * sigmaWidth * perMillimetre;
    const auto   makeWay = [&](const std::array<double, 2> & origin, const std::array<double, 4> & sigmas) {
      WayType way;
      way.origin = origin;
      for (std::size_t c = 0; c < 4; ++c)
      {
        way.variances[c] = sigmas[c] * sigmas[c];
      }
      way.variances[0] += sharedVariance(errors.along);
      way.variances[1] += sharedVariance(errors.across);
      way.variances[4] = lingual * lingual;
      way.variances[5] = width * width;
      return way;
    };
    // A template is moved, turned and scaled by the hand as well, which moves its reference point.
    const double arm[2] = { outline->GetReference()[0] - outline->GetCentroid()[0],
                            outline->GetReference()[1] - outline->GetCentroid()[1] };
    const double placed[2] = { (front ? TipShare : 1.0) * m_Errors.templateAlong * perMillimetre,
                               m_Errors.templateAcross * perMillimetre };
    tooth.ways = {
      { makeWay(outline->GetCentroid(), { { along, across, errors.turn, errors.size } }),
        makeWay(outline->GetReference(),
                { { std::hypot(std::hypot(along, placed[0]), std::hypot(errors.turn * arm[1], errors.size * arm[0])),
                    std::hypot(std::hypot(across, placed[1]), std::hypot(errors.turn * arm[0], errors.size * arm[1])),
                    m_Errors.templateTurn,
                    m_Errors.templateSize } }) }
    };
    // Of a tooth that is drawn and matched without a fault: its crown's normals are those of the outline.
    const std::size_t n = outline->GetPoints().size();
    EvaluationType    faultless;
    for (const auto & normal : outline->GetNormals())
    {
      faultless.nu.push_back(normal[0]);
      faultless.nv.push_back(normal[1]);
    }
    NoiseType reference;
    reference.weights.assign(n, 1.0);
    MakeBasis(tooth, faultless, reference);
    this->Factorize(tooth, reference);
    tooth.logDeterminant = ComputeLogDeterminant(reference);
    teeth->push_back(tooth);
  }
  m_Teeth = teeth;
  m_TeethTime = time;
  if (teeth->empty())
  {
    m_Failure = m_Unused.empty() ? "the tracing has no outline"
                : isFrontal      ? "no outline of a tooth can be matched"
                                 : "no outline of a whole tooth can be matched";
    for (const UnusedType & unused : m_Unused)
    {
      m_Failure += (&unused == &m_Unused.front() ? ": " : "; ") + unused.name + ": " + unused.reason;
    }
  }
}

void
ToothOutlinePoseMetricv4::InitializeTerm()
{
  this->Prepare();
  if (!m_Failure.empty())
  {
    itkExceptionMacro("The outlines of the " << ToString(m_Jaw) << " jaw cannot be matched: " << m_Failure << '.');
  }
}

const ToothOutlinePoseMetricv4::TeethType &
ToothOutlinePoseMetricv4::GetTeeth() const
{
  if (!m_Teeth)
  {
    itkExceptionMacro("The metric is not prepared: call Initialize() or Prepare().");
  }
  return *m_Teeth;
}

bool
ToothOutlinePoseMetricv4::IsFrontal() const
{
  return this->GetTransform()->GetPoseGeometry().direction == CephalometricDirectionEnum::Frontal;
}

void
ToothOutlinePoseMetricv4::SetReach(double standardDeviations)
{
  if (m_Reach != standardDeviations)
  {
    m_Reach = standardDeviations;
    this->SettingsChanged();
  }
}

std::vector<ToothCode>
ToothOutlinePoseMetricv4::GetOutlinedTeeth() const
{
  std::vector<ToothCode> teeth;
  for (const ToothType & tooth : this->GetTeeth())
  {
    teeth.push_back(tooth.code);
  }
  return teeth;
}

SizeValueType
ToothOutlinePoseMetricv4::GetNumberOfResiduals() const
{
  SizeValueType count = 0;
  for (const ToothType & tooth : this->GetTeeth())
  {
    count += tooth.outline->GetPoints().size();
  }
  return count;
}

void
ToothOutlinePoseMetricv4::Match(const ToothOutline &          outline,
                                const PoseContourIndex &      index,
                                const std::array<double, 2> & shift,
                                EvaluationType &              at)
{
  const auto &      points = outline.GetPoints();
  const auto &      normals = outline.GetNormals();
  const std::size_t n = points.size();
  at.match.assign(n, NoMatch);
  at.nu.assign(n, 0.0);
  at.nv.assign(n, 1.0);
  at.facing.assign(n, 0.0);
  for (std::size_t i = 0; i < n && !index.Empty(); ++i)
  {
    const std::size_t j = index.Nearest(points[i][0] - shift[0],
                                        points[i][1] - shift[1],
                                        normals[i][0],
                                        normals[i][1],
                                        OrientationWeight * OrientationWeight);
    at.match[i] = j;
    at.nu[i] = at.contour.nu[j];
    at.nv[i] = at.contour.nv[j];
    const auto & direction = index.GetDirection(j);
    at.facing[i] = PoseMatching::FacingWeight(direction[0] * normals[i][0] + direction[1] * normals[i][1]);
  }
}

std::array<double, 2>
ToothOutlinePoseMetricv4::ComputeShift(const ToothOutline & outline, const EvaluationType & at)
{
  double uu = ShiftRidge, uv = 0.0, vv = ShiftRidge, bu = 0.0, bv = 0.0;
  for (std::size_t i = 0; i < at.match.size(); ++i)
  {
    if (at.match[i] == NoMatch)
    {
      continue;
    }
    const auto & p = outline.GetPoints()[i];
    const double r = at.nu[i] * (p[0] - at.contour.u[at.match[i]]) + at.nv[i] * (p[1] - at.contour.v[at.match[i]]);
    uu += at.facing[i] * at.nu[i] * at.nu[i];
    uv += at.facing[i] * at.nu[i] * at.nv[i];
    vv += at.facing[i] * at.nv[i] * at.nv[i];
    bu += at.facing[i] * at.nu[i] * r;
    bv += at.facing[i] * at.nv[i] * r;
  }
  const double determinant = uu * vv - uv * uv;
  return { { (vv * bu - uv * bv) / determinant, (uu * bv - uv * bu) / determinant } };
}

void
ToothOutlinePoseMetricv4::Evaluate(std::size_t number, const PositionType & x, EvaluationType & at) const
{
  const ToothType &    tooth = this->GetTeeth()[number];
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  const PoseModel      model(geometry, ToPoseParameters(x));
  if (m_Hold != HoldEnum::Nothing)
  {
    at.contour = m_Held[number].contour;
    PoseContourModel::Reproject(at.contour, PoseModel(geometry, ToPoseParameters(m_HeldPosition)), model);
  }
  else
  {
    at.contour = tooth.model->Compute(model);
  }
  const auto &      points = tooth.outline->GetPoints();
  const std::size_t n = points.size();
  at.residual.assign(n, 0.0);
  if (m_Hold == HoldEnum::Matches)
  {
    at.match = m_Held[number].match;
    at.nu = m_Held[number].nu;
    at.nv = m_Held[number].nv;
    at.facing = m_Held[number].facing;
  }
  else
  {
    const PoseContourIndex index(at.contour);
    std::array<double, 2>  shift{};
    // From the side a start has brought the jaw to its outlines; from the front none has.
    const int rounds = this->IsFrontal() ? ShiftRounds : 0;
    for (int round = 0; round < rounds; ++round)
    {
      Match(*tooth.outline, index, shift, at);
      shift = ComputeShift(*tooth.outline, at);
    }
    Match(*tooth.outline, index, shift, at);
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    if (at.match[i] != NoMatch)
    {
      at.residual[i] =
        at.nu[i] * (points[i][0] - at.contour.u[at.match[i]]) + at.nv[i] * (points[i][1] - at.contour.v[at.match[i]]);
    }
  }
}

const std::vector<ToothOutlinePoseMetricv4::EvaluationType> &
ToothOutlinePoseMetricv4::EvaluateAll(const PositionType & x) const
{
  if (m_LastPosition != x || m_Last.size() != this->GetTeeth().size())
  {
    m_LastPosition.clear();
    m_Last.resize(this->GetTeeth().size());
    for (std::size_t t = 0; t < m_Last.size(); ++t)
    {
      this->Evaluate(t, x, m_Last[t]);
    }
    m_LastPosition = x;
  }
  if (m_Noise.empty())
  {
    m_Noise = this->ComputeNoises(m_Last, m_Reach);
  }
  return m_Last;
}

void
ToothOutlinePoseMetricv4::Factorize(const ToothType & tooth, NoiseType & noise) const
{
  const std::size_t n = noise.weights.size();
  const auto &      arc = tooth.outline->GetArc();
  const auto &      normals = tooth.outline->GetNormals();
  noise.factor.assign(n * n, 0.0);
  const double drift2 = m_Errors.drift * m_Errors.drift;
  const double jitter = this->IsFrontal() ? m_Errors.frontalJitter : m_Errors.jitter;
  const double jitter2 = jitter * jitter;
  for (std::size_t j = 0; j < n; ++j)
  {
    for (std::size_t i = j; i < n; ++i)
    {
      const double d = (arc[i] - arc[j]) / DriftLength;
      double k = drift2 * std::exp(-0.5 * d * d) * (normals[i][0] * normals[j][0] + normals[i][1] * normals[j][1]);
      for (std::size_t c = 0; c < NumberOfErrors; ++c)
      {
        k += noise.basis[c * n + i] * noise.basis[c * n + j] * tooth.ways[noise.way].variances[c] / noise.weight;
      }
      noise.factor[j * n + i] = k;
    }
    noise.factor[j * n + j] += jitter2 / std::max(noise.weights[j], SmallestToothWeight);
  }
  if (!ContourNoiseModel::Factor(noise.factor.data(), n))
  {
    itkExceptionMacro("The covariance of the outline of " << tooth.name
                                                          << " is not positive definite: see SetErrors().");
  }
}

double
ToothOutlinePoseMetricv4::ComputeLogDeterminant(const NoiseType & noise)
{
  const std::size_t n = noise.weights.size();
  double            sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    sum += 2.0 * std::log(noise.factor[i * n + i]);
  }
  return sum;
}

void
ToothOutlinePoseMetricv4::MakeBasis(const ToothType & tooth, const EvaluationType & at, NoiseType & noise)
{
  const ToothOutline & outline = *tooth.outline;
  const std::size_t    n = outline.GetPoints().size();
  const auto &         origin = tooth.ways[noise.way].origin;
  noise.basis.assign(NumberOfErrors * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
  {
    const double a = outline.GetPoints()[i][0] - origin[0];
    const double b = outline.GetPoints()[i][1] - origin[1];
    noise.basis[i] = at.nu[i];
    noise.basis[n + i] = at.nv[i];
    noise.basis[2 * n + i] = at.nv[i] * a - at.nu[i] * b;
    noise.basis[3 * n + i] = at.nu[i] * a + at.nv[i] * b;
    noise.basis[4 * n + i] = outline.GetLingual()[i];
    // Where the outline faces along the arch it is the cut that ends the crown.
    const double facing = std::abs(outline.GetNormals()[i][0]);
    noise.basis[5 * n + i] = tooth.endsAreCut ? std::max(0.0, (facing - CutFacing) / (1.0 - CutFacing)) : 0.0;
  }
}

double
ToothOutlinePoseMetricv4::ComputeDistance(const ToothType & tooth, const NoiseType & noise)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < 4; ++c)
  {
    sum += noise.errors[c] * noise.errors[c] / tooth.ways[noise.way].variances[c];
  }
  return std::sqrt(0.5 * sum);
}

double
ToothOutlinePoseMetricv4::ComputeMatchedShare(const NoiseType & noise)
{
  double matched = 0.0;
  for (const double weight : noise.weights)
  {
    matched += weight > 0.25 ? 1.0 : 0.0;
  }
  return matched / static_cast<double>(noise.weights.size());
}

std::vector<ToothOutlinePoseMetricv4::NoiseType>
ToothOutlinePoseMetricv4::ComputeNoises(const std::vector<EvaluationType> & at, double widest) const
{
  // From the front nobody uses templates.
  if (this->IsFrontal() || at.empty() || m_Drawing == DrawingEnum::ByHand)
  {
    return this->ComputeNoises(at, 0, widest);
  }
  std::vector<NoiseType> byTemplate = this->ComputeNoises(at, 1, widest);
  if (m_Drawing == DrawingEnum::ByTemplate)
  {
    return byTemplate;
  }
  std::vector<NoiseType> byHand = this->ComputeNoises(at, 0, widest);
  double                 difference = TemplatePenalty;
  for (std::size_t t = 0; t < at.size(); ++t)
  {
    difference += byTemplate[t].deviance - byHand[t].deviance;
  }
  if (difference < 0.0)
  {
    byTemplate.front().charge += TemplatePenalty;
    return byTemplate;
  }
  return byHand;
}

std::vector<ToothOutlinePoseMetricv4::NoiseType>
ToothOutlinePoseMetricv4::ComputeNoises(const std::vector<EvaluationType> & at, std::size_t way, double widest) const
{
  std::vector<NoiseType> noises;
  std::vector<double>    distances;
  for (std::size_t t = 0; t < at.size(); ++t)
  {
    noises.push_back(this->ComputeNoise(this->GetTeeth()[t], at[t], way));
    distances.push_back(ComputeDistance(this->GetTeeth()[t], noises.back()));
  }
  double width = ToothWidthInSigmas;
  if (distances.size() >= FewestTeethWithASpread)
  {
    auto       sorted = distances;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    width = std::max(width, std::min(widest, WidthInSigmas * SigmaOfMedian * *middle));
  }
  for (std::size_t t = 0; t < at.size(); ++t)
  {
    this->WidenErrors(
      this->GetTeeth()[t], at[t], GemanMcClureKernel::Weight(distances[t] * distances[t], width), noises[t]);
  }
  return noises;
}

ToothOutlinePoseMetricv4::NoiseType
ToothOutlinePoseMetricv4::ComputeNoise(const ToothType & tooth, const EvaluationType & at, std::size_t way) const
{
  const ToothOutline & outline = *tooth.outline;
  const std::size_t    n = outline.GetPoints().size();
  NoiseType            noise;
  noise.way = way;
  MakeBasis(tooth, at, noise);
  noise.weights = at.facing;
  std::vector<double> left(n);
  for (int round = 0; round < Rounds; ++round)
  {
    noise.weight = 1.0;
    this->Factorize(tooth, noise);
    // The tooth's own errors given the residuals: S B' K^-1 r.
    std::vector<double> z = at.residual;
    ContourNoiseModel::Whiten(noise.factor.data(), n, z.data(), 1);
    ContourNoiseModel::WhitenTransposed(noise.factor.data(), n, z.data(), 1);
    left = at.residual;
    for (std::size_t c = 0; c < NumberOfErrors; ++c)
    {
      double sum = 0.0;
      for (std::size_t i = 0; i < n; ++i)
      {
        sum += noise.basis[c * n + i] * z[i];
      }
      noise.errors[c] = tooth.ways[way].variances[c] * sum;
      for (std::size_t i = 0; i < n; ++i)
      {
        left[i] -= noise.basis[c * n + i] * noise.errors[c];
      }
    }
    std::vector<double> sizes;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (at.facing[i] > 0.0)
      {
        sizes.push_back(std::abs(left[i]));
      }
    }
    double median = 0.0;
    if (!sizes.empty())
    {
      std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
      median = sizes[sizes.size() / 2];
    }
    const double width = std::max(PointWidth, WidthInSigmas * SigmaOfMedian * median);
    for (std::size_t i = 0; i < n; ++i)
    {
      // Past the end of the contour the distance along it.
      double beyond = 0.0;
      if (at.match[i] != NoMatch)
      {
        const auto & p = outline.GetPoints()[i];
        beyond = PoseMatching::BeyondEnd(at.nu[i] * (p[1] - at.contour.v[at.match[i]]) -
                                         at.nv[i] * (p[0] - at.contour.u[at.match[i]]));
        // As far as the tooth is shifted its points may be.
        beyond = std::max(0.0, beyond - std::hypot(noise.errors[0], noise.errors[1]));
      }
      noise.weights[i] = at.facing[i] * GemanMcClureKernel::Weight(left[i] * left[i] + beyond * beyond, width);
    }
  }
  return noise;
}

void
ToothOutlinePoseMetricv4::WidenErrors(const ToothType &      tooth,
                                      const EvaluationType & at,
                                      double                 weight,
                                      NoiseType &            noise) const
{
  const std::size_t n = noise.weights.size();
  noise.weight = weight;
  this->Factorize(tooth, noise);
  noise.charge = ComputeLogDeterminant(noise) - tooth.logDeterminant;
  // With what the kernel leaves of the tooth: a gross error is none of the other way's successes.
  std::vector<double> z = at.residual;
  ContourNoiseModel::Whiten(noise.factor.data(), n, z.data(), 1);
  noise.deviance = noise.charge;
  for (const double residual : z)
  {
    noise.deviance += residual * residual;
  }
}

void
ToothOutlinePoseMetricv4::UpdateNoiseCorrelation(const PositionType & x)
{
  m_Noise.clear();
  this->EvaluateAll(x);
}

void
ToothOutlinePoseMetricv4::ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const
{
  const auto &    teeth = this->EvaluateAll(x);
  const PoseModel model(this->GetTransform()->GetPoseGeometry(), ToPoseParameters(x));
  residuals.set_size(static_cast<unsigned int>(this->GetNumberOfResiduals()));
  if (jacobian != nullptr)
  {
    jacobian->set_size(residuals.size(), NumberOfPoseParameters);
  }
  unsigned int row = 0;
  for (std::size_t t = 0; t < teeth.size(); ++t)
  {
    const EvaluationType & at = teeth[t];
    const std::size_t      n = at.residual.size();
    std::vector<double>    whitened = at.residual;
    ContourNoiseModel::Whiten(m_Noise[t].factor.data(), n, whitened.data(), 1);
    for (std::size_t i = 0; i < n; ++i)
    {
      residuals[row + static_cast<unsigned int>(i)] = whitened[i];
    }
    if (jacobian != nullptr)
    {
      std::vector<double> columns(NumberOfPoseParameters * n, 0.0);
      for (std::size_t i = 0; i < n; ++i)
      {
        if (at.match[i] == NoMatch)
        {
          continue;
        }
        double own[14];
        PoseMatching::ComputeSampleJacobian(model, at.contour, at.match[i], own);
        for (std::size_t a = 0; a < NumberOfPoseParameters; ++a)
        {
          columns[a * n + i] = -(at.nu[i] * own[a] + at.nv[i] * own[7 + a]);
        }
      }
      ContourNoiseModel::Whiten(m_Noise[t].factor.data(), n, columns.data(), NumberOfPoseParameters);
      for (std::size_t i = 0; i < n; ++i)
      {
        for (unsigned int a = 0; a < NumberOfPoseParameters; ++a)
        {
          (*jacobian)(row + static_cast<unsigned int>(i), a) = columns[a * n + i];
        }
      }
    }
    row += static_cast<unsigned int>(n);
  }
}

double
ToothOutlinePoseMetricv4::ComputeValue(const PositionType & x) const
{
  double value = Superclass::ComputeValue(x);
  for (const NoiseType & noise : m_Noise)
  {
    value += noise.charge;
  }
  return value;
}

void
ToothOutlinePoseMetricv4::AddSquaredMotion(const PositionType & from,
                                           const PositionType & to,
                                           double &             sum,
                                           double &             count) const
{
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  const PoseModel      before(geometry, ToPoseParameters(from));
  const PoseModel      after(geometry, ToPoseParameters(to));
  for (const ToothType & tooth : this->GetTeeth())
  {
    double a[2] = { 0.0, 0.0 };
    double b[2] = { 0.0, 0.0 };
    before.Project(tooth.model->GetCentre().data(), a);
    after.Project(tooth.model->GetCentre().data(), b);
    sum += (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    count += 1.0;
  }
}

std::vector<ToothOutlinePoseMetricv4::ResidualType>
ToothOutlinePoseMetricv4::ComputeOutlineResiduals(const PositionType & x) const
{
  // First what says that the metric isn't prepared: one that is has a transform.
  const auto &              teeth = this->EvaluateAll(x);
  const PoseGeometry &      geometry = this->GetTransform()->GetPoseGeometry();
  const auto                noises = this->ComputeNoises(teeth, 0.0);
  std::vector<ResidualType> residuals;
  for (std::size_t t = 0; t < teeth.size(); ++t)
  {
    const ToothType & tooth = this->GetTeeth()[t];
    const NoiseType & noise = noises[t];
    // A shift in the working plane, in pixels of the radiograph.
    const auto origin = PoseModel::ToPixel(geometry, { { 0.0, 0.0 } });
    const auto end = PoseModel::ToPixel(geometry, { { noise.errors[0], noise.errors[1] } });
    residuals.push_back({ tooth.name,
                          { { end[0] - origin[0], end[1] - origin[1] } },
                          std::hypot(noise.errors[0] / std::sqrt(tooth.ways[noise.way].variances[0]),
                                     noise.errors[1] / std::sqrt(tooth.ways[noise.way].variances[1])),
                          ComputeDistance(tooth, noise),
                          noise.weight,
                          ComputeMatchedShare(noise),
                          noise.way == 1,
                          MakeOpenLine(teeth[t].contour, geometry) });
  }
  return residuals;
}

std::vector<std::pair<ToothOutlinePoseMetricv4::TransformType::InputPointType,
                      ToothOutlinePoseMetricv4::TransformType::OutputPointType>>
ToothOutlinePoseMetricv4::GetCorrespondences() const
{
  std::vector<std::pair<TransformType::InputPointType, TransformType::OutputPointType>> correspondences;
  const TeethType &                                                                     teeth = this->GetTeeth();
  const PoseGeometry & geometry = this->GetTransform()->GetPoseGeometry();
  for (const ToothType & tooth : teeth)
  {
    std::array<double, 2> middle{};
    for (const auto & p : tooth.outline->GetPoints())
    {
      middle[0] += p[0] / static_cast<double>(tooth.outline->GetPoints().size());
      middle[1] += p[1] / static_cast<double>(tooth.outline->GetPoints().size());
    }
    const auto                     pixel = PoseModel::ToPixel(geometry, middle);
    TransformType::InputPointType  moving;
    TransformType::OutputPointType fixed;
    for (unsigned int d = 0; d < 3; ++d)
    {
      moving[d] = tooth.model->GetCentre()[d];
    }
    fixed[0] = pixel[0];
    fixed[1] = pixel[1];
    correspondences.emplace_back(moving, fixed);
  }
  return correspondences;
}

double
ToothOutlinePoseMetricv4::ComputeKnownDeviance(const PositionType & x, bool) const
{
  constexpr double unit = ToothWidthInSigmas * ToothWidthInSigmas;
  double           deviance = 0.0;
  const auto       noises = this->ComputeNoises(this->EvaluateAll(x), 0.0);
  for (std::size_t t = 0; t < noises.size(); ++t)
  {
    const double distance = ComputeDistance(this->GetTeeth()[t], noises[t]);
    const double near = unit / (unit + distance * distance);
    deviance += unit * (1.0 - near * ComputeMatchedShare(noises[t]));
  }
  return deviance;
}

void
ToothOutlinePoseMetricv4::AddFit(const PositionType & x, RegistrationFit & fit) const
{
  // As of landmarks, of which one that is not explained at all costs 1.
  fit.cost += this->ComputeKnownDeviance(x, false) / (ToothWidthInSigmas * ToothWidthInSigmas);
  fit.numberOfPoints += this->GetTeeth().size();
}

void
ToothOutlinePoseMetricv4::Hold(HoldEnum what)
{
  m_Hold = HoldEnum::Nothing;
  m_LastPosition.clear();
  if (what != HoldEnum::Nothing)
  {
    m_HeldPosition = this->GetState().GetValues();
    m_Held = this->EvaluateAll(m_HeldPosition);
  }
  else
  {
    m_Held.clear();
  }
  m_Hold = what;
  m_LastPosition.clear();
}

LightObject::Pointer
ToothOutlinePoseMetricv4::InternalClone() const
{
  auto clone = Self::New();
  clone->SetFixedObject(this->GetFixedObject());
  clone->SetMovingObject(this->GetMovingObject());
  clone->m_Jaw = m_Jaw;
  clone->m_Errors = m_Errors;
  clone->m_MarkedTeeth = m_MarkedTeeth;
  clone->m_MaximumCutSigma = m_MaximumCutSigma;
  clone->m_ExcludedTeeth = m_ExcludedTeeth;
  clone->m_Drawing = m_Drawing;
  clone->m_Failure = m_Failure;
  clone->m_Unused = m_Unused;
  clone->m_Teeth = m_Teeth;
  clone->m_Hold = m_Hold;
  clone->m_HeldPosition = m_HeldPosition;
  clone->m_Held = m_Held;
  clone->m_Noise = m_Noise;
  clone->m_Reach = m_Reach;
  clone->CopyPose(*this);
  // Prepared as the original is: what the setters above changed is the same.
  clone->m_TeethTime = std::max(clone->Object::GetMTime(), m_TeethTime);
  return clone.GetPointer();
}

void
ToothOutlinePoseMetricv4::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Jaw: " << static_cast<int>(m_Jaw) << std::endl;
  os << indent << "Errors: " << m_Errors.along << " x " << m_Errors.across << " mm, " << m_Errors.turn << " rad, "
     << m_Errors.size << ", lingual " << m_Errors.lingual << " mm, drift " << m_Errors.drift << " px, jitter "
     << m_Errors.jitter << " px" << std::endl;
  os << indent << "MarkedTeeth: " << m_MarkedTeeth.size() << std::endl;
  os << indent << "MaximumCutSigma: " << m_MaximumCutSigma << std::endl;
  os << indent << "ExcludedTeeth: " << m_ExcludedTeeth.size() << std::endl;
  os << indent << "Drawing: " << static_cast<int>(m_Drawing) << std::endl;
  os << indent << "Failure: " << m_Failure << std::endl;
  os << indent << "Unused: " << m_Unused.size() << std::endl;
  os << indent << "Teeth: " << (m_Teeth ? m_Teeth->size() : 0) << std::endl;
  os << indent << "Hold: " << static_cast<int>(m_Hold) << ", held " << m_Held.size() << " at " << m_HeldPosition.size()
     << std::endl;
  os << indent << "Reach: " << m_Reach << std::endl;
  os << indent << "TeethTime: " << m_TeethTime << std::endl;
  os << indent << "Noise: " << m_Noise.size() << ", last " << m_Last.size() << " at " << m_LastPosition.size()
     << std::endl;
}
} // namespace itk
