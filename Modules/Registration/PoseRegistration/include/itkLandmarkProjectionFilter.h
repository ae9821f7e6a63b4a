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
#ifndef itkLandmarkProjectionFilter_h
#define itkLandmarkProjectionFilter_h

#include "itkPoseSolution.h"

#include "itkDentalLandmarkSet.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkProcessObject.h"

#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class LandmarkProjectionFilter
 * \brief Landmarks of the scans as a pose registration places them on the radiograph, with their uncertainty.
 *
 * Inputs: a PoseSolution, and landmarks in the frame of the mesh files; MillimetresPerUnit says in what unit (1: mm).
 * Output: the landmarks of the jaws that were registered, continuous pixel indices, with a covariance each (square
 * pixels). GetSigma() is the standard deviation an axis, the root of half the covariance's trace.
 *
 * Of the middle between a right and its left landmark, which is all that a bisected tracing determines,
 * GetMiddles() knows as well. Points that were found on the scans by other means (SetCounterparts(), as
 * LandmarkCounterpartFilter finds them) have middles too where the landmarks have none of that name; that they may lie
 * elsewhere on the tooth is in their covariance. GetExpectedError() sums a jaw up, by its landmarks.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT LandmarkProjectionFilter : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkProjectionFilter);

  using Self = LandmarkProjectionFilter;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkProjectionFilter, ProcessObject);

  using LandmarksType = DentalLandmarkSet<3>;
  using OutputType = DentalLandmarkSet<2>;
  using CovarianceType = PoseSolution::CovarianceType;
  using JawEnum = ToothCode::JawEnum;
  using Superclass::MakeOutput;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;
  /** What a registration found, which must be set, and landmarks of the scans in their own unit and frame. */
  itkSetInputMacro(Solution, PoseSolution);
  itkGetInputMacro(Solution, PoseSolution);
  itkSetInputMacro(Landmarks, LandmarksType);
  itkGetInputMacro(Landmarks, LandmarksType);
  /** Points found on the scans, frames of the meshes, mm: they or the landmarks must be set. */
  itkSetInputMacro(Counterparts, LandmarkCounterpartSet);
  itkGetInputMacro(Counterparts, LandmarkCounterpartSet);
  /** Unit of the landmarks, mm; 1 by default. */
  itkSetMacro(MillimetresPerUnit, double);
  itkGetConstMacro(MillimetresPerUnit, double);
  /** The landmarks of the jaws that were registered, continuous pixel indices. */
  OutputType *
  GetOutput();

  /** Of a landmark of the output, valid after Update(). Throws for a name that is not there. */
  CovarianceType
  GetCovariance(const std::string & name) const;
  double
  GetSigma(const std::string & name) const;
  bool
  HasMiddleCovariance(const std::string & name) const;
  CovarianceType
  GetMiddleCovariance(const std::string & name) const;

  /** The middle between a right landmark's image and its left one's, which is all that a bisected tracing and a
   * cephalometric analysis mark. */
  struct MiddleType
  {
    /** Without a side: "U6_MB". */
    std::string           name;
    JawEnum               jaw{ JawEnum::Upper };
    OutputType::PointType point;
    /** Of the middle that a person would mark: of the pose and, for a counterpart, of its place on the scan. */
    CovarianceType covariance;
    /** How the points were found on the scan: "landmarks_3d", or what the counterpart says, with "one side" where one
     * of the two was found. */
    std::string source;
  };
  /** Of every pair in the output, in the order of the right ones, then of the counterparts whose names are not among
   * these; valid after Update(). */
  const std::vector<MiddleType> &
  GetMiddles() const
  {
    return m_Middles;
  }
  /** Standard deviation an axis: the root of half the covariance's trace. */
  static double
  ToSigma(const CovarianceType & covariance);

  /** Whether what was drawn tells of the middles between the sides alone (IsBisected()): the expected error is that of
   * the middles then. Default off. */
  itkSetMacro(Bisected, bool);
  itkGetConstMacro(Bisected, bool);
  itkBooleanMacro(Bisected);

  /** The distance, pixels, that a landmark of a jaw is expected to be off by: the mean over its landmarks in the
   * output, or over its middles where Bisected is on and there are any. Valid after Update(); throws where the output
   * has none of the jaw. */
  double
  GetExpectedError(JawEnum jaw) const;
  bool
  HasExpectedError(JawEnum jaw) const;
  /** The mean length of a two-dimensional normal error with this standard deviation an axis: sqrt(pi / 2) of it. */
  static double
  ToMeanDistance(double sigma);

  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  LandmarkProjectionFilter();
  ~LandmarkProjectionFilter() override = default;
  void
  VerifyPreconditions() ITKv5_CONST override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  PoseSolution::PointType
  ToMillimetres(const LandmarksType::PointType & point) const;

  /** Of the landmarks of a jaw, or of its middles. */
  std::vector<double>
  CollectSigmas(JawEnum jaw) const;
  void
  ProjectLandmarks(const LandmarksType & landmarks);
  void
  AddMiddle(const LandmarkCounterpartSet::CounterpartType & counterpart);

  double                                m_MillimetresPerUnit{ 1.0 };
  bool                                  m_Bisected{ false };
  std::map<std::string, CovarianceType> m_Covariances;
  std::map<std::string, CovarianceType> m_MiddleCovariances;
  std::vector<MiddleType>               m_Middles;
};
} // namespace itk

#endif
