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
#ifndef itkLandmarkMatrixProjectionFilter_h
#define itkLandmarkMatrixProjectionFilter_h

#include "RegistrationEvaluationExport.h"
#include "itkDentalLandmarkSet.h"

#include "itkMatrix.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

namespace itk
{
/** \class LandmarkMatrixProjectionFilter
 * \brief Landmarks of a scan on the radiograph, by the projection matrix that a registration gives.
 *
 * Inputs: the landmarks in the mesh's frame and unit, and the 3 x 4 matrix from there to the homogeneous continuous
 * pixel index, as in "projection" of a result. Output: the projections of those of the jaw, in their order. This is
 * what remains where a registration knows no uncertainty; LandmarkProjectionFilter has it from a PoseSolution.
 *
 * Errors (ExceptionObject): no landmarks or no matrix.
 *
 * \sa LandmarkErrorFilter
 * \test itkLandmarkMatrixProjectionFilterGTest.cxx
 * \ingroup RegistrationEvaluation
 */
class RegistrationEvaluation_EXPORT LandmarkMatrixProjectionFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkMatrixProjectionFilter);

  using Self = LandmarkMatrixProjectionFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkMatrixProjectionFilter, ProcessObject);

  using JawEnum = ToothCode::JawEnum;
  using LandmarksType = DentalLandmarkSet<3>;
  using OutputType = DentalLandmarkSet<2>;
  using ProjectionMatrixType = Matrix<double, 3, 4>;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** Landmarks of the scan in the matrix's unit and frame, and the 3x4 matrix to pixels. Both must be set. */
  itkSetInputMacro(Landmarks, LandmarksType);
  itkGetInputMacro(Landmarks, LandmarksType);
  itkSetGetDecoratedInputMacro(ProjectionMatrix, ProjectionMatrixType);

  /** The jaw whose landmarks are projected; Unknown, the default, is both. */
  itkSetEnumMacro(Jaw, JawEnum);
  itkGetEnumMacro(Jaw, JawEnum);
  /** The landmarks as continuous pixel indices, under the same names. */
  OutputType *
  GetOutput();

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  LandmarkMatrixProjectionFilter();
  ~LandmarkMatrixProjectionFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  JawEnum m_Jaw{ JawEnum::Unknown };
};
} // namespace itk

#endif
