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
#ifndef itkToothOutlinePoseMetricv4_h
#define itkToothOutlinePoseMetricv4_h

#include "PoseMetricExport.h"

#include "itkDentalContour.h"
#include "itkPoseContour.h"
#include "itkPoseMetricv4.h"
#include "itkToothCrownSet.h"

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
class PoseContourIndex;
class PoseToothContourModel;
class ToothOutline;

/** \class ToothOutlinePoseMetricv4
 * \brief Outlines of single teeth, as a standard cephalometric tracing and one of a frontal radiograph have them,
 * against the crowns of a scan: a term of a registration of the scan's pose.
 *
 * On a lateral radiograph the crown's part of each closed polyline with a tooth's code (WholeToothOutline) is matched
 * with the projected crown (PoseToothContourModel): of a front tooth the foremost of both sides, of a tooth behind the
 * canine the middle of both sides' images; the side in the code does not matter. On a frontal radiograph both sides are
 * seen beside each other, and an edge, a border or a closed crown (FrontalToothOutline) is matched with the crown of
 * its code. What a hand gets wrong of a tooth, it gets wrong of the whole tooth: n points of one are not n
 * measurements. The residuals r of a tooth, along the normals, have the covariance
 *
 *   K = B S B' + smooth^2 G + white^2 W^-1
 *
 * where the columns of B are what a shift along and across the occlusal plane, a turn and a change of size, an offset
 * of the palatal or lingual side and the width to which the crown was cut do to r; S are their variances (Errors
 * below); G is the correlation of a hand's drift and W are the points' weights. The value is the sum of
 *
 *   r' K^-1 r + log |K| - log |K0|,
 *
 * minus twice the logarithm of a likelihood: what is let go makes K large, and is charged for by that. K0 is the K of a
 * tooth that is drawn and matched without a fault, which no pose changes.
 * The picture's axes stand for those of the occlusal plane, from which heads tip them by some degrees.
 *
 * Teeth are drawn in one of two ways, by one hand all alike, and the likelier one is taken, unless SetDrawing() says
 * which it is. A hand that follows the tooth moves, turns and scales it a little about its centroid. A stock template
 * is placed by tip and axis: its shape is another tooth's, by a larger turn and size, but about the tooth's reference
 * point (WholeToothOutline::GetReference()), which that leaves where it is. Taken for the tooth's own shape it would
 * pull the tip by millimetres. From the front nobody uses templates.
 *
 * Where an outline's points have sigmas (DentalContour::PolylineType), their root mean square stands for the hand's
 * part of a shift's error, and turn and size change in proportion. An outline that is said to be of a crown or of a
 * labial side is not used; one that is said to be of a tooth is not doubted for its proportions.
 *
 * W, S and the way of drawing are made by UpdateNoiseCorrelation(), between runs of an optimizer, and held: a point
 * counts less where it lies apart from its tooth's others, by the Geman-McClure kernel on what the tooth's own errors
 * leave of r, and S is widened by the same kernel where the tooth as a whole lies further off than hands draw: one
 * gross error of four outlines does not move the others. While a registration is not at its end (SetReach()), and most
 * of four or more teeth lie far off, it may be the jaw that is not at its place yet: the kernel is as wide as they are
 * spread then, up to the reach.
 *
 * Inputs: SetTransform() (its geometry), SetCrowns() in the dental frame (mm), SetFixedContour() (continuous pixel
 * indices), SetJaw(). Blocks read: "pose" and "scale", or as named (PoseStateBlocks). Clone() shares what is prepared.
 * Errors (ExceptionObject): a missing input, with the call to make; no outline that can be matched, with the reasons.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT ToothOutlinePoseMetricv4 : public PoseMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ToothOutlinePoseMetricv4);

  using Self = ToothOutlinePoseMetricv4;
  using Superclass = PoseMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ToothOutlinePoseMetricv4, PoseMetricv4);

  using ContourType = DentalContour;
  using JawEnum = ToothCode::JawEnum;

  /** What hands get wrong of a tooth as a whole, standard deviations. Shifts are those of two readers of 150 films with
   * a reader's bias of 0.15 mm (0.47 and 0.62 mm), and what crown and outline differ by where both are right, a quarter
   * of a millimetre; turn and size are of the same order in what is known of hands; the palatal side lies up to 1 mm
   * beside the edge in a set of real tracings (Documentation/Landmarks.md). */
  struct ErrorsType
  {
    /** mm on the detector. */
    double along{ 0.52 };
    double across{ 0.70 };
    /** rad, and a share of the size: of a hand that draws the tooth. */
    double turn{ 0.035 };
    double size{ 0.03 };
    /** The same of a template's shape against the tooth's. */
    double templateTurn{ 0.08 };
    double templateSize{ 0.10 };
    /** mm on the detector, on top of the hand's: where the tip of a template, or the middle of its crown behind the
     * canines, lies against the tooth's. A tip is what it is placed by, and errs by four tenths of it along. */
    double templateAlong{ 0.8 };
    double templateAcross{ 0.4 };
    /** mm on the detector. */
    double lingual{ 0.5 };
    /** Along the line, px of 0.25 mm: a drift that is correlated over DriftLength px, and each point's own, which is
     * mostly that of its match. Points are matched anew at each position, and between the cusps of a molar, in its
     * fissures and where the middle of two crowns has a step the match jumps, and its residual with it, by up to a
     * pixel. With the 0.4 px of a hand alone each such jump would count as evidence: two pixels of the pose change the
     * squares of a molar by 1, jumps did by 9, and registrations ended in hollows between them. What a tooth says of
     * the pose is limited by the errors of the whole of it, not by this. */
    double drift{ 1.0 };
    double jitter{ 1.0 };
    /** Each point's own on a frontal radiograph, where a few points of an edge are matched with a curved outline and
     * jumps are of the hand's distance from it, half a millimetre. */
    double frontalJitter{ 1.5 };
  };
  static constexpr double DriftLength = 15.0; /**< Length over which a hand's drift keeps its sign, px of 0.25 mm. */

  /** The scan's crowns, dental frame, mm. Same as SetMovingObject(). */
  void
  SetCrowns(const ToothCrownSet * crowns)
  {
    this->SetMovingObject(crowns);
  }
  const ToothCrownSet *
  GetCrowns() const
  {
    return dynamic_cast<const ToothCrownSet *>(this->GetMovingObject());
  }

  /** The tracing of this jaw: polylines with their teeth's codes. Same as SetFixedObject(). */
  void
  SetFixedContour(const ContourType * contour)
  {
    this->SetFixedObject(contour);
  }
  const ContourType *
  GetFixedContour() const
  {
    return dynamic_cast<const ContourType *>(this->GetFixedObject());
  }

  /** Upper (default) or Lower. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);
  /** How much a hand errs; the defaults are what drawings of analyses showed. */
  void
  SetErrors(const ErrorsType & errors);
  const ErrorsType &
  GetErrors() const
  {
    return m_Errors;
  }

  /** Share of a tooth's error that its landmark has as well where one hand draws both: 0.3. Nobody has measured it: 0
   * and 1 are known to be wrong, as a tip is placed by the line that is drawn through it, and with 0.3 the sigma of
   * what is registered with both is a seventh too wide or a tenth too narrow where it is 0 or 0.6. */
  static constexpr double SharedErrorShare = 0.3;
  /** Teeth whose landmarks are registered with as well, which share a part of the hand's error in a shift: two such
   * measurements are worth two independent ones whose variances are larger by that part, but not where a crown was cut
   * or a template was placed. On a lateral radiograph the side does not matter. */
  void
  SetMarkedTeeth(const std::vector<ToothCode> & teeth);

  /** Crowns that may be further than this from where they were cut, standard deviation along the arch, mm, are left
   * out; without a limit by default. Of a frontal radiograph those of marked teeth. */
  itkSetMacro(MaximumCutSigma, double);
  itkGetConstMacro(MaximumCutSigma, double);

  /** How the outlines were drawn. */
  enum class DrawingEnum : std::uint8_t
  {
    /** The likelier of the two ways. */
    Unknown,
    ByHand,
    ByTemplate
  };
  /** Unknown by default. What a tracing of the other jaw, or the comparison of outlines (ToothOutlineComparison), says
   * of this one. Of a frontal radiograph it is not asked. */
  void
  SetDrawing(DrawingEnum drawing);
  itkGetEnumMacro(Drawing, DrawingEnum);

  /** FDI numbers of teeth to leave out: of a polyline's code. */
  void
  SetExcludedTeeth(const std::vector<std::uint8_t> & teeth);

  /** Prepares what is constant. Unlike Initialize() it does not throw where no outline can be matched: GetFailure()
   * says why. */
  void
  Prepare();
  const std::string &
  GetFailure() const
  {
    return m_Failure;
  }
  /** An outline that is not used, "U6" ("UR6" of a frontal radiograph), and why. Valid after Prepare() or
   * Initialize(). */
  struct UnusedType
  {
    std::string name;   /**< The tooth, as the tracing names it. */
    std::string reason; /**< In words for the person who drew it. */
  };
  const std::vector<UnusedType> &
  GetUnused() const
  {
    return m_Unused;
  } /**< What is not used, and why. Valid after Initialize(). */

  /** The codes of the outlines that are used. */
  std::vector<ToothCode>
  GetOutlinedTeeth() const;

  /** How a tooth's outline is explained. */
  struct ResidualType
  {
    /** "U1", "L6"; of a frontal radiograph "UR1". */
    std::string name;
    /** How far the hand has shifted it, as far as can be told: drawn minus projected, pixels. */
    std::array<double, 2> shift;
    /** The same over the standard deviations of the way in which it was drawn: 1.4 on average, as a landmark's. */
    double shiftDistance;
    /** Of shift, turn and size together, in standard deviations of a shift: 1.4 on average. */
    double distance;
    /** What the robust kernel leaves of it, 1 to 0. */
    double weight;
    /** Share of its points that lie on the crown, after shift, turn and size. */
    double matchedShare;
    /** Its shape is not the tooth's own. */
    bool isTemplate;
    /** What it was compared with: the projected outline of the crown, an open line, pixels. */
    std::vector<std::array<double, 2>> crown;
  };
  std::vector<ResidualType>
  ComputeOutlineResiduals(const PositionType & x) const; /**< One an outline. */

  /** Minus twice the logarithm of what the outlines say for a position among others, each as one measurement, as a
   * landmark is: the sum of 16 (1 - m 16 / (16 + d^2)) with a tooth's distance d and matched share m (ResidualType). It
   * is d^2 of a small d, and 16 of a tooth that is let go. The value is too sure of itself for that: a template's
   * shape, or a crown's that was cut elsewhere, leaves all of its points residuals beyond what a hand's line has, and
   * it counts each of them. */
  double
  ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const override;

  /** The centre of each outline's crown with that of the scan's, for a start; dental frame mm, pixels. */
  std::vector<std::pair<TransformType::InputPointType, TransformType::OutputPointType>>
  GetCorrespondences() const;

  SizeValueType
  GetNumberOfResiduals() const override;
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;
  /** The sum of the squared residuals and the charges, which are held as W, S and the way of drawing are: the slope is
   * that of the squared residuals. */
  double
  ComputeValue(const PositionType & x) const override;
  void
  AddSquaredMotion(const PositionType & from, const PositionType & to, double & sum, double & count) const override;
  void
  AddFit(const PositionType & x, RegistrationFit & fit) const override;
  void
  SetReach(double standardDeviations) override;
  void
  UpdateNoiseCorrelation(const PositionType & x) override;
  void
  Hold(HoldEnum what) override;

protected:
  ToothOutlinePoseMetricv4() = default;
  ~ToothOutlinePoseMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  /** A way of drawing a tooth. */
  struct WayType
  {
    /** About which the tooth is turned and scaled, px of 0.25 mm. */
    std::array<double, 2> origin{};
    /** Variances of B's columns, px^2 of 0.25 mm, rad^2, 1. */
    std::array<double, 6> variances{};
  };
  /** What is constant of one tooth. */
  struct ToothType
  {
    std::string                                  name;
    ToothCode                                    code;
    std::shared_ptr<const ToothOutline>          outline;
    std::shared_ptr<const PoseToothContourModel> model;
    /** By hand, by a template. */
    std::array<WayType, 2> ways;
    /** Whether normals along u are those of the ends at which the crown was cut from its neighbours. */
    bool endsAreCut{ false };
    /** log |K0|. */
    double logDeterminant{ 0.0 };
  };
  using TeethType = std::vector<ToothType>;

  /** A tooth at one position. */
  struct EvaluationType
  {
    PoseContour contour;
    /** Sample of the contour that each point is matched with. */
    std::vector<std::size_t> match;
    std::vector<double>      residual;
    std::vector<double>      nu;
    std::vector<double>      nv;
    /** 1 where contour and outline face the same way. */
    std::vector<double> facing;
  };
  /** What is held of a tooth between two updates of the noise. */
  struct NoiseType
  {
    /** Cholesky factor of K. */
    std::vector<double> factor;
    std::vector<double> weights;
    /** B, n x 6 column by column. */
    std::vector<double> basis;
    /** The tooth's own errors as far as can be told. */
    std::array<double, 6> errors{};
    double                weight{ 1.0 };
    /** Which of the tooth's ways. */
    std::size_t way{ 0 };
    /** log |K| - log |K0|, and on the first tooth what templates have to be better by. */
    double charge{ 0.0 };
    /** Minus twice the log likelihood of the residuals, but for a constant. */
    double deviance{ 0.0 };
  };

  void
  Evaluate(std::size_t tooth, const PositionType & x, EvaluationType & at) const;
  /** Matches the outline's points, moved back by a shift, with the contour. */
  static void
  Match(const ToothOutline &          outline,
        const PoseContourIndex &      index,
        const std::array<double, 2> & shift,
        EvaluationType &              at);
  /** How far the outline lies beside the contour by its matches, px of 0.25 mm. */
  static std::array<double, 2>
  ComputeShift(const ToothOutline & outline, const EvaluationType & at);
  const std::vector<EvaluationType> &
  EvaluateAll(const PositionType & x) const;
  /** Of all teeth, in the likelier way of drawing. */
  std::vector<NoiseType>
  ComputeNoises(const std::vector<EvaluationType> & at, double widest) const;
  /** In one way of drawing. */
  std::vector<NoiseType>
  ComputeNoises(const std::vector<EvaluationType> & at, std::size_t way, double widest) const;
  /** Weights of a tooth's points, and its own errors as if it were none of those that are let go. */
  NoiseType
  ComputeNoise(const ToothType & tooth, const EvaluationType & at, std::size_t way) const;
  /** Of a tooth that counts so much. */
  void
  WidenErrors(const ToothType & tooth, const EvaluationType & at, double weight, NoiseType & noise) const;
  /** B of the noise's way of drawing. */
  static void
  MakeBasis(const ToothType & tooth, const EvaluationType & at, NoiseType & noise);
  void
  Factorize(const ToothType & tooth, NoiseType & noise) const;
  static double
  ComputeLogDeterminant(const NoiseType & noise);
  /** Shift, turn and size of a tooth in standard deviations. */
  static double
  ComputeDistance(const ToothType & tooth, const NoiseType & noise);
  /** Share of a tooth's points that lie on the crown after its own errors. */
  static double
  ComputeMatchedShare(const NoiseType & noise);
  /** Whether the radiograph was taken from the front, where both sides are seen beside each other. */
  bool
  IsFrontal() const;
  const TeethType &
  GetTeeth() const;

  JawEnum                   m_Jaw{ JawEnum::Upper };
  ErrorsType                m_Errors;
  std::vector<ToothCode>    m_MarkedTeeth;
  double                    m_MaximumCutSigma{ std::numeric_limits<double>::infinity() };
  std::vector<std::uint8_t> m_ExcludedTeeth;
  DrawingEnum               m_Drawing{ DrawingEnum::Unknown };

  std::string             m_Failure;
  std::vector<UnusedType> m_Unused;
  /** Constant and shared by clones. */
  std::shared_ptr<const TeethType>    m_Teeth;
  ModifiedTimeType                    m_TeethTime{ 0 };
  HoldEnum                            m_Hold{ HoldEnum::Nothing };
  PositionType                        m_HeldPosition;
  std::vector<EvaluationType>         m_Held;
  mutable std::vector<NoiseType>      m_Noise;
  double                              m_Reach{ 0.0 };
  mutable PositionType                m_LastPosition;
  mutable std::vector<EvaluationType> m_Last;
};
} // namespace itk

#endif
