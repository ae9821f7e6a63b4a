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
#ifndef itkViewPoseMetricv4_h
#define itkViewPoseMetricv4_h

#include "PoseMetricExport.h"
#include "itkPoseMetricv4.h"

#include <string>
#include <vector>

namespace itk
{
/** \class ViewPoseMetricv4
 * \brief A term of another view: the one that it holds, with the head where it was for that view.
 *
 * A second radiograph shows the same body, at a scale of its own, and a head that stands a little differently in the
 * ear rods; even where both were taken at once, the principal point is known to some pixels only, which is a shift.
 * This term reads the body's pose ("pose"), how the head was moved for the view, and the view's scale (PoseStateBlocks:
 * MakeMoveName(), MakeScaleName()); the term that it holds gets the pose that comes of both (PoseComposition). Any term
 * of a pose serves: landmarks, silhouettes, outlines of teeth, with the geometry of the view in its transform. Priors
 * say how far the head may have moved (ParameterPriorMetricv4).
 *
 * Kernel, noise and matches are those of the term that it holds. How well a drawing fits (AddFit()) is said of the
 * first view alone: a candidate's score, and with it whether other readings of that drawing are tried, is not spoiled
 * by a view that contradicts. By default it joins with the candidates (GetJoins()): the search for where to begin looks
 * at the first view, in whose pixels this term's mean nothing.
 *
 * Position: pitch, roll, yaw, tx, ty, tz of the body, the same six of the move, kappa of the view.
 *
 * Clone() clones the term. Errors (ExceptionObject): no term, no name of a view.
 *
 * \test itkViewPoseMetricv4GTest.cxx
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT ViewPoseMetricv4 : public LeastSquaresMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ViewPoseMetricv4);

  using Self = ViewPoseMetricv4;
  using Superclass = LeastSquaresMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ViewPoseMetricv4, LeastSquaresMetricv4);

  using TermType = PoseMetricv4;
  static constexpr unsigned int NumberOfViewParameters = 13; /**< Seven of the pose, six of the head's move. */

  /** The term with the view's radiograph and geometry. */
  void
  SetTerm(TermType * term);
  const TermType *
  GetTerm() const
  {
    return m_Term;
  }

  /** Name of the view, of which its blocks are named. */
  void
  SetView(const std::string & name);
  itkGetStringMacro(View);

  /** The position of the term that is held: pitch, roll, yaw, tx, ty, tz, kappa in the view. */
  static PositionType
  MakeTermPosition(const PositionType & x);
  /** Its derivative: 7 x 13. */
  static MatrixType
  MakeTermJacobian(const PositionType & x);

  ModifiedTimeType
  GetMTime() const override;
  BlocksType
  DeclareBlocks() const override;
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
  SetReach(double standardDeviations) override;
  void
  SetKernelWidth(double width) override;
  void
  SetRobustKernel(const RobustKernel * kernel) override;
  void
  SetNoiseModel(const ResidualNoiseModel * model) override;
  void
  SetNoiseLevels(const ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) override;
  bool
  GetNoiseLevels(ContourNoiseLevels & levels, const ResidualNoiseModel * model = nullptr) const override;
  double
  ComputeKnownDeviance(const PositionType & x, bool noiseIsEstimated) const override;
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

protected:
  ViewPoseMetricv4();
  ~ViewPoseMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  TermType &
  VerifyTerm() const;

  TermType::Pointer m_Term;
  std::string       m_View;
};
} // namespace itk

#endif
