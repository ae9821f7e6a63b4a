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
#ifndef itkLandmarkErrorFilter_h
#define itkLandmarkErrorFilter_h

#include "RegistrationEvaluationExport.h"
#include "itkDentalLandmarkSet.h"
#include "itkLandmarkErrorStatistics.h"

#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \class LandmarkErrorFilter
 * \brief Distances between predicted landmarks and those marked on the radiograph, of one jaw or of both.
 *
 * Inputs: two DentalLandmarkSet<2> in continuous pixel indices. Landmarks are paired by tooth and suffix, whatever the
 * numbering of their names ("UR6_MB" and "16_MB" are one); those of only one set are listed and not counted. Errors are
 * distances in pixels; where a pixel spacing is given also in mm, in the plane for which the spacing holds.
 *
 * With BisectSides, for a tracing in which the double contours of the sides were bisected, an error is that of the
 * middle between a right landmark and its left counterpart: such a tracing determines no more. A landmark whose
 * counterpart is missing in either set then has no error.
 *
 * No pair at all is no error: GetStatistics().GetCount() is 0.
 *
 * \sa LandmarkErrorStatistics
 * \ingroup RegistrationEvaluation
 */
class RegistrationEvaluation_EXPORT LandmarkErrorFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkErrorFilter);

  using Self = LandmarkErrorFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkErrorFilter, ProcessObject);

  using LandmarkSetType = DentalLandmarkSet<2>;
  using PointType = LandmarkSetType::PointType;
  using SpacingType = Vector<double, 2>;
  using JawEnum = ToothCode::JawEnum;
  using StatisticsObjectType = SimpleDataObjectDecorator<LandmarkErrorStatistics>;

  /** The error of one landmark, or of a bisected pair. */
  struct LandmarkErrorType
  {
    /** "UR6_MB", or "UR6_MB+UL6_MB" for the middle of two. */
    std::string name;
    /** The right one of a pair. */
    ToothCode tooth;
    PointType predicted;
    PointType reference;
    /** In pixels. */
    double distance{ 0.0 };
    /** Only with a pixel spacing. */
    std::optional<double> millimetres;
  };
  /** Predicted and marked landmarks, continuous pixel indices of the same radiograph. Both must be set. */
  itkSetInputMacro(PredictedLandmarks, LandmarkSetType);
  itkGetInputMacro(PredictedLandmarks, LandmarkSetType);
  itkSetInputMacro(ReferenceLandmarks, LandmarkSetType);
  itkGetInputMacro(ReferenceLandmarks, LandmarkSetType);

  /** The jaw whose landmarks count; Unknown, the default, is both. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);

  /** Measure the middles between the sides. Off by default. */
  itkSetMacro(BisectSides, bool);
  itkGetConstMacro(BisectSides, bool);
  itkBooleanMacro(BisectSides);

  /** mm a pixel, (u, v); 0, the default, is unknown. */
  itkSetMacro(PixelSpacing, SpacingType);
  itkGetConstReferenceMacro(PixelSpacing, SpacingType);

  /** The figures, after Update(). */
  const LandmarkErrorStatistics &
  GetStatistics() const;

  /** The same as a data object, for a pipeline. */
  const StatisticsObjectType *
  GetStatisticsOutput() const;

  /** Each error in the order of the reference landmarks, after Update(). */
  const std::vector<LandmarkErrorType> &
  GetErrors() const
  {
    return m_Errors;
  }

  /** Names of the jaw's landmarks that have no error: their partner is missing. */
  const std::vector<std::string> &
  GetUnpairedLandmarks() const
  {
    return m_UnpairedLandmarks;
  }

protected:
  LandmarkErrorFilter();
  ~LandmarkErrorFilter() override = default;

  using DataObjectPointerArraySizeType = ProcessObject::DataObjectPointerArraySizeType;
  using Superclass::MakeOutput;
  DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  JawEnum                        m_Jaw{ JawEnum::Unknown };
  bool                           m_BisectSides{ false };
  SpacingType                    m_PixelSpacing;
  std::vector<LandmarkErrorType> m_Errors;
  std::vector<std::string>       m_UnpairedLandmarks;
};
} // namespace itk

#endif
