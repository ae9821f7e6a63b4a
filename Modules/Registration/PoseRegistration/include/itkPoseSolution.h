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
#ifndef itkPoseSolution_h
#define itkPoseSolution_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"

#include "itkCephalometricGeometry.h"
#include "itkCephalometricPoseTransform.h"
#include "itkDataObject.h"
#include "itkMatrix.h"
#include "itkToothCode.h"
#include "itkVersorRigid3DTransform.h"

#include <array>
#include <string>
#include <vector>

namespace itk
{
/** \class PoseSolution
 * \brief What a pose registration found, as a data object: poses, covariance, candidates, fit, and why a jaw was not
 * registered.
 *
 * Output of PoseRegistrationMethod, input of what lies downstream: RegistrationVerdictFilter, LandmarkProjectionFilter.
 * Points of a jaw's mesh are in the mesh's frame, mm; pixels are continuous indices of the radiograph.
 *
 * Errors (ExceptionObject): a jaw without input or not registered; a result whose jaws and groups do not match.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseSolution : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseSolution);

  using Self = PoseSolution;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PoseSolution, DataObject);

  using JawEnum = ToothCode::JawEnum;
  using PointType = Point<double, 3>;
  using PixelIndexType = CephalometricGeometry::PixelIndexType;
  using CovarianceType = Matrix<double, 2, 2>;
  using ProjectionMatrixType = Matrix<double, 3, 4>;
  using RigidTransformType = VersorRigid3DTransform<double>;

  /** Everything, by index of jaw and group. */
  const PoseRegistrationResult &
  GetResult() const
  {
    return m_Result;
  }
  /** What the registration was asked for. */
  const PoseRegistrationOptions &
  GetOptions() const
  {
    return m_Options;
  }
  void
  SetResult(const PoseRegistrationResult & result, const PoseRegistrationOptions & options);

  /** Index of a jaw in the result, or -1 where it had no input. */
  int
  GetIndex(JawEnum jaw) const;
  bool
  IsRegistered(JawEnum jaw) const;
  /** Throws where the jaw had no input. */
  const PoseJawResult &
  GetJaw(JawEnum jaw) const;
  /** The group of jaws with one pose that a registered jaw belongs to. */
  const PoseGroupResult &
  GetGroup(JawEnum jaw) const;

  /** Points of the mesh in the unit of its file (1: mm, as the mesh was registered) to homogeneous continuous pixel
   * index. */
  ProjectionMatrixType
  GetProjectionMatrix(JawEnum jaw, double millimetresPerUnit = 1.0) const;

  /** The same under other parameters of its pose, as a candidate or an earlier step has them. */
  ProjectionMatrixType
  GetProjectionMatrix(JawEnum jaw, const PoseParameters & parameters, double millimetresPerUnit = 1.0) const;

  /** How far the moving contours of a group's jaws are apart under two poses: root mean square, pixels of 0.25 mm, as
   * steps of the optimizer are measured; 0 where nothing was matched. The group by its index in GetResult(). */
  double
  ComputeMotion(std::size_t group, const PoseParameters & from, const PoseParameters & to) const;

  /** Standard deviation an axis, pixels of the radiograph, that the covariance predicts along the tracing of a jaw (0
   * without one), and of the middles between the sides at its incisors and first molars. */
  double
  GetTracingSigma(JawEnum jaw) const;
  double
  GetMiddleSigma(JawEnum jaw) const;

  /** A minimum of the criterion that is a place of its own. */
  struct AlternativeType
  {
    /** As GetProjectionMatrix() gives that of the solution. */
    ProjectionMatrixType projection;
    /** Fixed-width cost and code term, which minima are ranked by. */
    double score{ 0.0 };
    /** Root mean square distance of the moving contours to those of the solution, pixels of the radiograph. */
    double distance{ 0.0 };
  };

  /** The solution itself, then the other minima of the jaw's group by their score. What ended within a pixel of the
   * working plane (0.25 mm) of the solution is the same place, reached twice, and is left out. */
  std::vector<AlternativeType>
  GetAlternatives(JawEnum jaw, double millimetresPerUnit = 1.0) const;
  /** Continuous pixel index of a point of the jaw's mesh, mm. */
  PixelIndexType
  ProjectPoint(JawEnum jaw, const PointType & point) const;
  /** Covariance, square pixels, of the projection of a point. */
  CovarianceType
  ComputeCovariance(JawEnum jaw, const PointType & point) const;

  /** Names of the views beside the first. */
  std::vector<std::string>
  GetViewNames() const;
  /** Throws where there is no such view. */
  const PoseViewResult &
  GetView(const std::string & name) const;
  /** The same solution as another view shows it: pose, scale, geometry and fit there. Everything downstream of a
   * registration takes it, landmarks and contours of that view come out. */
  Pointer
  MakeViewSolution(const std::string & name) const;

  /** The moving contour at the solution, open, continuous pixel indices: everything that could be matched, with normals
   * and rim points (frame of the mesh, mm). */
  DentalContour::Pointer
  MakeMovingContour(JawEnum jaw) const;

  /** Mesh frame to cephalostat frame. */
  RigidTransformType::Pointer
  MakeRigidTransform(JawEnum jaw) const;
  /** Dental frame of the jaw to the radiograph. */
  CephalometricPoseTransform::Pointer
  MakePoseTransform(JawEnum jaw) const;
  /** Gives a geometry the pose of a jaw's mesh; the scale of the fit is in its pixel spacing. */
  void
  CopyToGeometry(JawEnum jaw, CephalometricGeometry * geometry) const;

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  PoseSolution() = default;
  ~PoseSolution() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** From pixels of the working plane to those of the radiograph. */
  double
  ToRadiographPixels(double workingPixels) const;
  static ProjectionMatrixType
  ToProjectionMatrix(const std::array<double, 12> & rows, double millimetresPerUnit);

  PoseRegistrationResult  m_Result;
  PoseRegistrationOptions m_Options;
};
} // namespace itk

#endif
