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
#ifndef itkSilhouettePoseMetricv4_h
#define itkSilhouettePoseMetricv4_h

#include "itkPoseMetricv4.h"
#include "itkPoseSilhouetteKernel.h"

#include "itkDentalContour.h"
#include "itkMakeTriangleSurface.h"
#include "itkToothCode.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class SilhouettePoseMetricv4
 * \brief A scan's silhouette against a tracing of it: the term of a jaw in a registration of its pose.
 *
 * The scan, in its dental frame, is projected through the geometry of the transform; the open silhouette of the traced
 * side is made anew at each position. Residuals are the distances of the tracing's points from it along its normal, px
 * of 0.25 mm, with weights of a robust kernel and noise that is correlated along the tracing (generalised least
 * squares). The value is
 *
 *   r' K^-1 r + c^2/white^2 sum_i g_i charge(w_i),   K = smooth^2 G + white^2 diag(1 / (g_i w_i))
 *
 * with the tracing's weights g, the robust weights w at the position, kernel width c and the correlation G of
 * the noise model, by the normals at the position of the last UpdateNoiseCorrelation(). Documentation/Robust.md has all
 * formulas.
 *
 * Inputs: SetTransform() (its geometry; its parameters are where the state begins), SetMovingMesh() or
 * SetMovingSurface() (dental frame, mm, triangles wound outward), SetFixedContour() (continuous pixel indices),
 * SetJaw(). Blocks read: "pose" (pitch, roll, yaw, tx, ty, tz) and "scale" (kappa), or as named. In place of a scan
 * SetMovingContour() takes an outline, which then moves as a drawing on the midsagittal plane does.
 *
 * Options that are off by default, since they gain nothing on simulated cases (Documentation/Robust.md): GateByTooth;
 * ReverseWeight g' > 0 adds the direction from the moving contour to the tracing, censored where nothing was drawn:
 *
 *   g'/(smooth^2 + white^2) sum_j taper_j [w_j r_j^2 + c^2 charge(w_j)]
 *
 * It steers the fit alone: noise levels and covariance are of the forward direction, since it is the same drawing.
 *
 * Clone() shares meshes, tracing and everything prepared. Errors (ExceptionObject): a missing input, with the call to
 * make; a tracing that cannot be matched, with the reason.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT SilhouettePoseMetricv4 : public PoseMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SilhouettePoseMetricv4);

  using Self = SilhouettePoseMetricv4;
  using Superclass = PoseMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(SilhouettePoseMetricv4, PoseMetricv4);

  using ContourType = DentalContour;
  using JawEnum = ToothCode::JawEnum;
  using SurfacePointer = std::shared_ptr<const TriangleSurface>;

  /** The scan in its dental frame, mm. */
  void
  SetMovingSurface(SurfacePointer surface);
  template <typename TMesh>
  void
  SetMovingMesh(const TMesh * mesh)
  {
    this->SetMovingSurface(mesh == nullptr ? nullptr
                                           : std::make_shared<const TriangleSurface>(MakeTriangleSurface(mesh)));
  }
  const SurfacePointer &
  GetMovingSurface() const
  {
    return m_Surface;
  }

  /** Instead of a scan: an outline as it is seen with the transform as it stands, continuous pixel indices; of a DRR, a
   * segmentation, another radiograph. Its points move as if they lay in the midsagittal plane of the dental frame:
   * where roll, yaw and ty are held at 0 (SetBlockFree()), by a similarity. Same as SetMovingObject(). */
  void
  SetMovingContour(const ContourType * contour)
  {
    this->SetMovingObject(contour);
  }
  const ContourType *
  GetMovingContour() const
  {
    return dynamic_cast<const ContourType *>(this->GetMovingObject());
  }

  /** The tracing of this jaw. Same as SetFixedObject(). */
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

  /** Which side's outline was traced. Default Right. */
  itkSetEnumMacro(TracedSide, TracedSideEnum);
  itkGetEnumMacro(TracedSide, TracedSideEnum);

  /** Cut the scan at the midline plane; on by default. MidlineMargin: how far beyond the plane, mm, -0.5. */
  itkSetMacro(UseSideSelection, bool);
  itkGetConstMacro(UseSideSelection, bool);
  itkBooleanMacro(UseSideSelection);
  itkSetMacro(MidlineMargin, double);
  itkGetConstMacro(MidlineMargin, double);

  /** Keep the occlusal and anterior part of the outline alone; on by default. */
  itkSetMacro(UseFacingFilter, bool);
  itkGetConstMacro(UseFacingFilter, bool);
  itkBooleanMacro(UseFacingFilter);

  /** Match directions beside positions; on by default, 8 px a unit normal. */
  itkSetMacro(UseOrientation, bool);
  itkGetConstMacro(UseOrientation, bool);
  itkBooleanMacro(UseOrientation);
  itkSetMacro(OrientationWeight, double);
  itkGetConstMacro(OrientationWeight, double);

  /** Points above which a tracing is thinned; 200. */
  itkSetMacro(MaximumTracingPoints, unsigned int);
  itkGetConstMacro(MaximumTracingPoints, unsigned int);

  /** Match points that carry tooth codes with the same tooth or one up to ToothRange positions away; off by default,
   * range 1. Teeth of a scan are told by their place along the arch, of a moving contour by its codes. Sides are not
   * told apart; points without code match everything. */
  itkSetMacro(GateByTooth, bool);
  itkGetConstMacro(GateByTooth, bool);
  itkBooleanMacro(GateByTooth);
  itkSetMacro(ToothRange, unsigned int);
  itkGetConstMacro(ToothRange, unsigned int);

  /** Weight of the direction from the moving contour to the tracing beside the forward one; 0 (default) leaves it out.
   * Not negative. */
  void
  SetReverseWeight(double weight);
  itkGetConstMacro(ReverseWeight, double);
  /** The reverse direction fades in over this length from an end of the tracing, px; 6 by default. */
  itkSetMacro(TaperLength, double);
  itkGetConstMacro(TaperLength, double);
  /** Polylines of the tracing with a shorter gap between them have no end there, px; 8 by default. */
  itkSetMacro(GapLength, double);
  itkGetConstMacro(GapLength, double);

  /** FDI numbers of teeth to leave out. */
  void
  SetExcludedTeeth(const std::vector<std::uint8_t> & teeth);
  const std::vector<std::uint8_t> &
  GetExcludedTeeth() const
  {
    return m_ExcludedTeeth;
  }

  /** Makes the engine where something has changed. Unlike Initialize() it does not throw for a tracing that cannot be
   * matched: GetFailure() says why. May be called for several metrics at once, in several threads. */
  void
  Prepare();
  /** Empty where there is something to match; valid after Prepare() or Initialize(). */
  const std::string &
  GetFailure() const;
  const PoseSilhouetteKernel &
  GetKernel() const;

  /** Of kernel and noise model as well. */
  ModifiedTimeType
  GetMTime() const override;

  /** GemanMcClureKernel by default, width 3 px. */
  void
  SetRobustKernel(const RobustKernel * kernel) override;
  itkGetConstObjectMacro(RobustKernel, RobustKernel);
  void
  SetKernelWidth(double width) override;
  itkGetConstMacro(KernelWidth, double);
  /** CorrelatedNoiseModel by default. */
  void
  SetNoiseModel(const ResidualNoiseModel * model) override;
  itkGetConstObjectMacro(NoiseModel, ResidualNoiseModel);
  void
  SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) override;
  bool
  GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) const override;

  SizeValueType
  GetNumberOfResiduals() const override;
  void
  ComputeResiduals(const PositionType & x, VectorType & residuals, MatrixType * jacobian) const override;
  double
  ComputeValue(const PositionType & x) const override;
  void
  ComputeGradient(const PositionType & x, VectorType & gradient) const override;
  void
  AddSquaredMotion(const PositionType & from, const PositionType & to, double & sum, double & count) const override;
  void
  AddFit(const PositionType & x, RegistrationFit & fit) const override;
  void
  UpdateNoiseCorrelation(const PositionType & x) override;
  void
  AppendNoiseBlocks(const PositionType & x, std::vector<ResidualNoiseBlock> & blocks) const override;
  void
  AddFixedInformation(const PositionType & x,
                      MatrixType &         information,
                      VectorType &         gradient,
                      double &             value) const override;
  void
  Hold(HoldEnum what) override;

  /** The moving contour of each strand at a position of this metric's blocks: working plane, dental frame. */
  const std::vector<PoseContour> &
  GetContours(const PositionType & x) const;
  /** How well each strand is explained. */
  std::vector<PoseFitStatistics>
  ComputeFitStatistics(const PositionType & x) const;
  /** Standard deviation an axis that a covariance (7 x 7, of this metric's blocks) predicts, px of 0.25 mm: root mean
   * square over a strand's matched points, and the largest on its contour. */
  std::array<double, 2>
  PredictSigma(std::size_t strand, const PositionType & x, const std::array<double, 49> & covariance) const;

protected:
  SilhouettePoseMetricv4();
  ~SilhouettePoseMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  /** Everything at one position. */
  struct EvaluationType
  {
    PositionType                                     x;
    std::vector<PoseContour>                         contours;
    std::vector<PoseSilhouetteKernel::Linearization> strands;
    /** Empty without a reverse direction. */
    std::vector<PoseReverseDirection::Linearization> reverse;
    std::vector<std::vector<double>>                 weights;
    /** Cholesky factors of the covariances and whitened residuals with the settings that they are of. */
    std::vector<std::vector<double>> factors;
    std::vector<std::vector<double>> whitened;
    double                           kernelWidth{ 0.0 };
    ContourNoiseLevels               levels;
    ModifiedTimeType                 settingsTime{ 0 };
  };
  using CorrelationsType = std::vector<std::vector<double>>;

  EvaluationType &
  Evaluate(const PositionType & x) const;
  void
  UpdateCorrelations() const;
  void
  UpdateWeights(EvaluationType & evaluation) const;
  void
  UpdateFactors(EvaluationType & evaluation) const;
  void
  FillCorrelation(const EvaluationType & evaluation, std::size_t strand, double * correlation) const;
  /** What the robust kernel and the facing leave of a residual. */
  double
  GetRobustWeight(double squaredDistance, double facing) const;
  double
  GetVariance() const
  {
    return m_NoiseLevels.smooth * m_NoiseLevels.smooth + m_NoiseLevels.white * m_NoiseLevels.white;
  }
  void
  TakeNormals(const EvaluationType & evaluation) const;

  SurfacePointer                   m_Surface;
  JawEnum                          m_Jaw{ JawEnum::Upper };
  TracedSideEnum                   m_TracedSide{ TracedSideEnum::Right };
  bool                             m_UseSideSelection{ true };
  double                           m_MidlineMargin{ -0.5 };
  bool                             m_UseFacingFilter{ true };
  bool                             m_UseOrientation{ true };
  double                           m_OrientationWeight{ 8.0 };
  unsigned int                     m_MaximumTracingPoints{ 200 };
  bool                             m_GateByTooth{ false };
  unsigned int                     m_ToothRange{ 1 };
  double                           m_ReverseWeight{ 0.0 };
  double                           m_TaperLength{ 6.0 };
  double                           m_GapLength{ 8.0 };
  std::vector<std::uint8_t>        m_ExcludedTeeth;
  RobustKernel::ConstPointer       m_RobustKernel;
  double                           m_KernelWidth{ 3.0 };
  ResidualNoiseModel::ConstPointer m_NoiseModel;
  ContourNoiseLevels               m_NoiseLevels;
  HoldEnum                         m_Hold{ HoldEnum::Nothing };

  /** Constant and shared by clones. */
  std::shared_ptr<const PoseSilhouetteKernel>     m_Kernel;
  ModifiedTimeType                                m_KernelTime{ 0 };
  mutable std::shared_ptr<const CorrelationsType> m_Correlations;
  /** Of the noise model that they are of. */
  mutable ModifiedTimeType              m_CorrelationsTime{ 0 };
  std::shared_ptr<const EvaluationType> m_Held;
  /** Normals, u and v, one strand after the other, by which the noise is correlated. */
  mutable std::vector<std::array<std::vector<double>, 2>> m_Normals;
  /** Changes with kernel, noise model and normals. */
  mutable TimeStamp m_SettingsTime;

  /** Where it was linearised last, and where it was evaluated last: what an optimizer goes back to, and what it tries.
   */
  mutable EvaluationType m_Linearized;
  mutable EvaluationType m_Last;
};
} // namespace itk

#endif
