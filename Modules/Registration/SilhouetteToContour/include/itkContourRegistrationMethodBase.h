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
#ifndef itkContourRegistrationMethodBase_h
#define itkContourRegistrationMethodBase_h

#include "SilhouetteToContourExport.h"
#include "itkContourChamferKernel.h"
#include "itkDentalContour.h"
#include "itkRegistrationIterationInformation.h"

#include "itkDataObjectDecorator.h"
#include "itkProcessObject.h"
#include "itkSimilarity2DTransform.h"

#include <string>

namespace itk
{
/** \class ContourRegistrationMethodBase
 * \brief Whatever aligns a silhouette with a tracing by a 2-D similarity: inputs, output, start, events and abort.
 *
 * Our method and those that it is compared with derive from it, so that one can stand where another stood.
 *
 * Inputs: the fixed contour (tracing, pixels of the radiograph), the moving contour (silhouette, q coordinates in
 * pixels), an optional initial transform. Output: the similarity that maps moving to fixed, p = s R(theta) q + t, as a
 * decorated Similarity2DTransform with centre 0.
 *
 * Start: theta = 0, s the ratio of the diagonals of the two bounding boxes, t such that the centroids (weighted means
 * of the points) agree; or the initial transform.
 *
 * A subclass writes GenerateData(): it begins at what StartRun() gives, says where it is by SetIteration() before each
 * event, asks CheckAbort() after it, and ends with SetResult().
 *
 * Errors (ExceptionObject): a contour missing, or with fewer than two distinct points of positive weight; an initial
 * transform whose scale is not positive.
 *
 * \ingroup SilhouetteToContour
 */
class SilhouetteToContour_EXPORT ContourRegistrationMethodBase
  : public ProcessObject
  , public RegistrationIterationInformation
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ContourRegistrationMethodBase);

  using Self = ContourRegistrationMethodBase;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(ContourRegistrationMethodBase, ProcessObject);

  using ContourType = DentalContour;
  using TransformType = Similarity2DTransform<double>;
  using DecoratedTransformType = DataObjectDecorator<TransformType>;
  using ParametersType = OptimizerParameters<double>;

  /** Tracing, pixels of the radiograph. */
  itkSetInputMacro(FixedContour, ContourType);
  itkGetInputMacro(FixedContour, ContourType);

  /** Silhouette in q coordinates, pixels. */
  itkSetInputMacro(MovingContour, ContourType);
  itkGetInputMacro(MovingContour, ContourType);

  /** Start from this similarity (any centre) instead of the bounding boxes. */
  itkSetGetDecoratedObjectInputMacro(InitialTransform, TransformType);

  /** The result. Valid after Update(). */
  DecoratedTransformType *
  GetOutput();
  const DecoratedTransformType *
  GetOutput() const;
  const TransformType *
  GetTransform() const;

  /** The start (scale, rad, px, px), after Update(). */
  itkGetConstReferenceMacro(InitialParameters, ParametersType);

  /** The bounding-box start of two contours by the definition above. Throws where either has no two distinct points. */
  static TransformType::Pointer
  ComputeBoundingBoxTransform(const ContourType * fixed, const ContourType * moving);

  // RegistrationIterationInformation
  unsigned int
  GetCurrentLevel() const override
  {
    return m_CurrentLevel;
  }
  std::size_t
  GetOptimizerIteration() const override
  {
    return m_OptimizerIteration;
  }
  double
  GetMetricValue() const override
  {
    return m_MetricValue;
  }
  ParametersType
  GetOptimizerPosition() const override
  {
    return m_OptimizerPosition;
  }
  std::string
  GetOptimizerStopConditionDescription() const override
  {
    return m_StopConditionDescription;
  }

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  ContourRegistrationMethodBase();
  ~ContourRegistrationMethodBase() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Bounding boxes, or the initial transform where one is set; throws as the class says. */
  virtual ContourSimilarity
  FindStart() const;

  /** Forgets the run before and stands at the start, which it returns. */
  ContourSimilarity
  StartRun();

  /** Where the run is, for observers: of the level, the iteration in it, the metric there, the similarity. */
  void
  SetIteration(unsigned int level, std::size_t iteration, double value, const ContourSimilarity & similarity);
  /** What GetStopConditionDescription() will say. */
  void
  SetStopConditionDescription(const std::string & text)
  {
    m_StopConditionDescription = text;
  }

  /** Throws ProcessAborted, with where the run was as the stop condition, after an observer asked for it. */
  void
  CheckAbort();

  /** Puts the similarity out. */
  void
  SetResult(const ContourSimilarity & similarity);

  /** scale, rad, px, px. */
  static ParametersType
  MakeParameters(const ContourSimilarity & similarity);

private:
  ParametersType m_InitialParameters;
  unsigned int   m_CurrentLevel{ 0 };
  std::size_t    m_OptimizerIteration{ 0 };
  double         m_MetricValue{ 0.0 };
  ParametersType m_OptimizerPosition;
  std::string    m_StopConditionDescription;
};
} // namespace itk

#endif
