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
#ifndef itkPoseRegistrationMethod_h
#define itkPoseRegistrationMethod_h

#include "PoseRegistrationExport.h"
#include "itkPoseRegistrationTypes.h"
#include "itkRegistrationVerdict.h"

#include "itkCephalometricGeometry.h"
#include "itkDataObjectDecorator.h"
#include "itkDentalContour.h"
#include "itkMatrix.h"
#include "itkMesh.h"
#include "itkProcessObject.h"
#include "itkVersorRigid3DTransform.h"

#include <string>
#include <vector>

namespace itk
{
/** \class PoseRegistrationMethod
 * \brief The robust registration as a process object: scans and tracing to pose, scale, uncertainty and verdict.
 *
 * Inputs: upper and lower mesh (mm, any orientation, triangles wound outward) with the tracing of each jaw (continuous
 * pixel indices), one jaw or both, and the nominal geometry without a pose. A geometry without a pixel spacing is
 * legal: the scale is then estimated with a wide prior. The dental frames are estimated from the meshes unless they are
 * set.
 *
 * Outputs: for each jaw, upper then lower, the rigid transform from mesh to cephalostat (decorated,
 * VersorRigid3DTransform, safe to load in Slicer) and a CephalometricGeometry with that pose that projects the mesh
 * onto the radiograph. The scale factor of the fit is in that geometry's pixel spacing: spacing, distances and depth
 * are one unobservable scale. A jaw without input, or that could not be registered, has an empty decorator and
 * GetVerdict() says why.
 *
 * Events: MultiResolutionIterationEvent and IterationEvent before global start, candidates, final refinement and
 * uncertainty (GetCurrentLevel() 0 to 3), ProgressEvent, AbortEvent.
 *
 * Errors: no jaw with mesh and contour, no geometry, cells that are not triangles, inconsistent distances.
 *
 * \sa PoseRegistrationKernel for the method, Documentation/Robust.md for formulas and figures.
 * \ingroup PoseRegistration
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT PoseRegistrationMethod : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseRegistrationMethod);

  using Self = PoseRegistrationMethod;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PoseRegistrationMethod, ProcessObject);

  using MeshType = TMesh;
  using ContourType = DentalContour;
  using GeometryType = CephalometricGeometry;
  using TransformType = VersorRigid3DTransform<double>;
  using DecoratedTransformType = DataObjectDecorator<TransformType>;
  using LandmarkCovarianceType = Matrix<double, 2, 2>;
  using LandmarkPointType = Point<double, 3>;
  using DataObjectPointer = Superclass::DataObjectPointer;
  using DataObjectPointerArraySizeType = Superclass::DataObjectPointerArraySizeType;

  /** Upper is 0, lower is 1 where a method takes a jaw. */
  static constexpr unsigned int NumberOfJaws = 2;

  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);
  itkSetInputMacro(UpperContour, ContourType);
  itkGetInputMacro(UpperContour, ContourType);
  itkSetInputMacro(LowerContour, ContourType);
  itkGetInputMacro(LowerContour, ContourType);
  itkSetInputMacro(Geometry, GeometryType);
  itkGetInputMacro(Geometry, GeometryType);

  /** Every ingredient of the method. Thread number and progress are this object's own. */
  void
  SetOptions(const PoseRegistrationOptions & options);
  const PoseRegistrationOptions &
  GetOptions() const
  {
    return m_Options;
  }

  /** Which side was traced: the option that cases differ in. */
  void
  SetTracedSide(PoseTracedSideEnum side);
  PoseTracedSideEnum
  GetTracedSide() const
  {
    return m_Options.tracedSide;
  }

  /** Whether the geometry's principal point is one. Default on; off, the tracing's centre is used. */
  itkSetMacro(PrincipalPointKnown, bool);
  itkGetConstMacro(PrincipalPointKnown, bool);
  itkBooleanMacro(PrincipalPointKnown);

  /** Dental frames of the meshes, from UMidlineDentalAxisFilter with RefineMidline for example. Set the same frame for
   * both where the jaws are in occlusion. Without a call the frames are estimated. */
  void
  SetFrames(const PoseFrame & upper, const PoseFrame & lower, bool jawsShareFrame);
  void
  EstimateFrames();
  itkGetConstMacro(UseGivenFrames, bool);

  /** Whether one pose was fitted to both jaws; valid after Update(). */
  itkGetConstMacro(JawsShareFrame, bool);

  /** Level of the running registration: 0 start, 1 candidates, 2 refinement, 3 uncertainty. */
  itkGetConstMacro(CurrentLevel, unsigned int);

  /** Decorated transform mesh -> cephalostat. */
  DecoratedTransformType *
  GetTransformOutput(unsigned int jaw);
  const TransformType *
  GetTransform(unsigned int jaw);
  /** Geometry with the pose: ProjectPoint() of a mesh point is its place on the radiograph. */
  GeometryType *
  GetGeometryOutput(unsigned int jaw);

  /** Everything else; valid after Update(). The indices are those of GetResultIndex(). */
  const PoseRegistrationResult &
  GetResult() const
  {
    return m_Result;
  }
  /** Index of a jaw in the result, or -1 where the jaw had no input. */
  int
  GetResultIndex(unsigned int jaw) const;

  /** Empty and ok for a jaw without input. */
  const RegistrationVerdict::JawVerdict &
  GetVerdict(unsigned int jaw) const;

  /** Covariance (pixels squared) of the projection of a point of the jaw's mesh. Throws where the jaw was not
   * registered. */
  LandmarkCovarianceType
  ComputeLandmarkCovariance(unsigned int jaw, const LandmarkPointType & point) const;

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  PoseRegistrationMethod();
  ~PoseRegistrationMethod() override = default;

  void
  VerifyPreconditions() ITKv5_CONST override;

  /** Meshes, contours and a geometry share no physical space that could be compared. */
  void
  VerifyInputInformation() ITKv5_CONST override
  {}

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  PoseRegistrationOptions                                     m_Options;
  bool                                                      m_PrincipalPointKnown{ true };
  bool                                                      m_UseGivenFrames{ false };
  bool                                                      m_GivenFramesAreShared{ false };
  std::array<PoseFrame, NumberOfJaws>                       m_GivenFrames;
  bool                                                      m_JawsShareFrame{ false };
  unsigned int                                              m_CurrentLevel{ 0 };
  PoseRegistrationResult                                      m_Result;
  std::array<int, NumberOfJaws>                             m_ResultIndex{ { -1, -1 } };
  std::array<PoseFrame, NumberOfJaws>                       m_UsedFrames;
  std::array<RegistrationVerdict::JawVerdict, NumberOfJaws> m_Verdicts;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkPoseRegistrationMethod.hxx"
#endif

#ifndef POSEREGISTRATION_INSTANTIATE
namespace itk
{
extern template class PoseRegistrationMethod<Mesh<float, 3>>;
extern template class PoseRegistrationMethod<Mesh<double, 3>>;
} // namespace itk
#endif

#endif
