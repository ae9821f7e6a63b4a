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

#include "itkPoseRegistrationMethodBase.h"

#include "itkMesh.h"

namespace itk
{
/** \class PoseRegistrationMethod
 * \brief The registration of preset "robust" as a process object: scans and tracing to pose, scale and uncertainty.
 *
 * Inputs: upper and lower mesh (mm, any orientation, triangles wound outward) with the tracing of each jaw (continuous
 * pixel indices), one jaw or both, and the nominal geometry without a pose. A geometry without a pixel spacing is
 * legal: the scale is then estimated with a wide prior. Dental frames as UMidlineDentalAxisFilter gives them; those
 * that are not set are estimated.
 *
 * Outputs: a PoseSolution (pose, covariance, candidates, fit) for RegistrationVerdictFilter and whatever else lies
 * downstream; for each jaw the rigid transform from mesh to cephalostat (decorated, VersorRigid3DTransform, safe to
 * load in Slicer) and a CephalometricGeometry with that pose that projects the mesh onto the radiograph. The scale
 * factor of the fit is in that geometry's pixel spacing: spacing, distances and depth are one unobservable scale. A jaw
 * without input, or that could not be registered, has an empty decorator; the solution says why.
 *
 * How: each jaw is a SilhouettePoseMetricv4; the jaws that share a pose, priors on pose and scale, and the terms that
 * are added with AddMetric() are one sum, which LevenbergMarquardtOptimizerv4 minimizes from every start that PoseStart
 * finds, while kernel width and noise levels follow their schedule between its runs. The best candidate is the result;
 * hypotheses name likely mistakes. Documentation/Robust.md has formulas and figures.
 *
 * Events, all in the thread that calls Update(): MultiResolutionIterationEvent where a level begins
 * (GetCurrentLevel()); IterationEvent at every step that is tried, of this object (GetCurrentIteration()) and of the
 * optimizer, and of the metric (GetMetric()) at those steps that are no hypothesis's, whose criterion is another one;
 * ProgressEvent; AbortEvent. AbortGenerateDataOn() in an observer ends it within a step.
 *
 * In ITK a MultiResolutionIterationEvent is an IterationEvent: an observer of IterationEvent is called at the start of
 * a level too. typeid(event) == typeid(IterationEvent) is true of steps alone, as in RegistrationIterationCommand.
 *
 * Errors: no jaw with mesh and contour, no geometry, cells that are not triangles, inconsistent distances.
 *
 * \ingroup PoseRegistration
 */
template <typename TMesh = Mesh<float, 3>>
class ITK_TEMPLATE_EXPORT PoseRegistrationMethod : public PoseRegistrationMethodBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseRegistrationMethod);

  using Self = PoseRegistrationMethod;
  using Superclass = PoseRegistrationMethodBase;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(PoseRegistrationMethod, PoseRegistrationMethodBase);

  using MeshType = TMesh;
  using typename Superclass::JawEnum;
  /** Scans in their own frames, mm; one of them may be missing. */
  itkSetInputMacro(UpperMesh, MeshType);
  itkGetInputMacro(UpperMesh, MeshType);
  itkSetInputMacro(LowerMesh, MeshType);
  itkGetInputMacro(LowerMesh, MeshType);

protected:
  PoseRegistrationMethod() = default;
  ~PoseRegistrationMethod() override = default;
  /** Whether a jaw has a scan, and the scan as flat arrays. */
  bool
  HasMesh(JawEnum jaw) const override;
  TriangleSurface
  MakeSurface(JawEnum jaw) const override;
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
