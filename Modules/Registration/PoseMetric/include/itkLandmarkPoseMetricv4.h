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
#ifndef itkLandmarkPoseMetricv4_h
#define itkLandmarkPoseMetricv4_h

#include "PoseMetricExport.h"
#include "itkCephalometricLandmarkSet.h"
#include "itkDentalLandmarkSet.h"
#include "itkLandmarkCounterpartSet.h"
#include "itkPoseMetricv4.h"

#include "itkMatrix.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class LandmarkPoseMetricv4
 * \brief Landmarks of a scan against landmarks of the radiograph: a term of a registration of the scan's pose.
 *
 * Landmarks of the same name belong together; a name that only one of the sets has is left out. What a cephalometric
 * analysis has marked (SetCephalometricLandmarks()) may have two points on the scan (SetCounterparts()): the projected
 * position is the middle of their images, or the foremost one's. Which is foremost is settled by Initialize() and by
 * Hold(Matches), and stays while an optimizer runs. With the difference d between the marked and the projected
 * position, pixels, and the covariance C of the mark, the value is
 *
 *   sum_i w_i d_i' C_i^-1 d_i + c^2 charge(w_i)
 *
 * with the weights w of the robust kernel at the distance sqrt(d' C^-1 d), which has no unit; its width c is
 * KernelWidthInSigmas. What SetKernelWidth() of a sum anneals, in pixels, is not this one: the errors of marks are
 * known.
 *
 * Inputs: SetTransform() (its geometry; its parameters are where the state begins), SetMovingLandmarks() in the scan's
 * dental frame (mm), SetFixedLandmarks() (continuous pixel indices), and their errors: Sigma for all, or a covariance
 * each. Or SetCounterparts(), dental frame, and SetCephalometricLandmarks(), whose errors are the marks' own, else by
 * default those of readers (ReaderSigmaAlong, ReaderSigmaAcross), to which the counterparts' are added. Blocks read:
 * "pose" and "scale", or as named (PoseStateBlocks).
 *
 * Clone() shares the landmarks. Errors (ExceptionObject): a missing input, with the call to make; sets without a common
 * name, with both lists; a covariance that is not positive definite.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT LandmarkPoseMetricv4 : public PoseMetricv4
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkPoseMetricv4);

  using Self = LandmarkPoseMetricv4;
  using Superclass = PoseMetricv4;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkPoseMetricv4, PoseMetricv4);

  using MovingLandmarksType = DentalLandmarkSet<3>;
  using FixedLandmarksType = DentalLandmarkSet<2>;
  using CovarianceType = Matrix<double, 2, 2>;

  /** Landmarks of the scan, dental frame, mm. Same as SetMovingObject(). */
  void
  SetMovingLandmarks(const MovingLandmarksType * landmarks)
  {
    this->SetMovingObject(landmarks);
  }
  const MovingLandmarksType *
  GetMovingLandmarks() const
  {
    return dynamic_cast<const MovingLandmarksType *>(this->GetMovingObject());
  }

  /** Landmarks of the radiograph, continuous pixel indices. Same as SetFixedObject(). */
  void
  SetFixedLandmarks(const FixedLandmarksType * landmarks)
  {
    this->SetFixedObject(landmarks);
  }
  const FixedLandmarksType *
  GetFixedLandmarks() const
  {
    return dynamic_cast<const FixedLandmarksType *>(this->GetFixedObject());
  }

  /** Where the landmarks of an analysis are on the scan, dental frame, mm. Same as SetMovingObject(). */
  void
  SetCounterparts(const LandmarkCounterpartSet * counterparts)
  {
    this->SetMovingObject(counterparts);
  }
  const LandmarkCounterpartSet *
  GetCounterparts() const
  {
    return dynamic_cast<const LandmarkCounterpartSet *>(this->GetMovingObject());
  }

  /** Landmarks of a cephalometric analysis. Same as SetFixedObject(). */
  void
  SetCephalometricLandmarks(const CephalometricLandmarkSet * landmarks)
  {
    this->SetFixedObject(landmarks);
  }
  const CephalometricLandmarkSet *
  GetCephalometricLandmarks() const
  {
    return dynamic_cast<const CephalometricLandmarkSet *>(this->GetFixedObject());
  }

  /** Standard deviation of a mark of an analysis of which nobody said one, along the occlusal plane and across it, mm
   * on the detector: two readers of 150 films differ by (0.51, 0.76) mm at the upper incisor's tip, that is 0.45 and
   * 0.6 of each, and have a bias of 0.15 mm. */
  static constexpr double ReaderSigmaAlong = 0.47;
  static constexpr double ReaderSigmaAcross = 0.62;
  /** Factor on these by a detector's confidence, 0 to 1: the errors of detectors go from a good reader's to twice a
   * reader's. */
  static double
  ComputeConfidenceFactor(double confidence);

  /** Standard deviation an axis of marks without a covariance of their own, pixels of the radiograph; 4 by default:
   * 1 mm at 0.25 mm a pixel, what two observers differ by. */
  itkSetMacro(Sigma, double);
  itkGetConstMacro(Sigma, double);

  /** Covariance of a mark, square pixels; of one landmark by its name. */
  void
  SetCovariance(const std::string & name, const CovarianceType & covariance);
  void
  ClearCovariances();

  /** Teeth of which outlines are registered with as well, drawn by the same hand: the errors of their marks are shared
   * to ToothOutlinePoseMetricv4::SharedErrorShare, and their variances, as said, larger by it. On a lateral radiograph
   * the side does not matter. */
  void
  SetOutlinedTeeth(const std::vector<ToothCode> & teeth);

  /** Of the kernel as well. */
  ModifiedTimeType
  GetMTime() const override;

  /** Least squares by default. */
  void
  SetRobustKernel(const RobustKernel * kernel) override;
  itkGetConstObjectMacro(RobustKernel, RobustKernel);
  /** Width of the kernel in standard deviations, 4 by default. */
  itkSetMacro(KernelWidthInSigmas, double);
  itkGetConstMacro(KernelWidthInSigmas, double);

  /** Names of the landmarks that are matched, in the order of the residuals (u and v each); valid after Initialize().
   */
  std::vector<std::string>
  GetMatchedNames() const;

  /** How a landmark is explained. */
  struct ResidualType
  {
    std::string name; /**< As the landmarks of the radiograph name it. */
    /** Marked minus projected, pixels. */
    double difference[2];
    /** Of the difference: the mark's error and that of its place on the scan, standard deviations along u and v. */
    double sigma[2];
    /** In standard deviations: sqrt(d' C^-1 d). */
    double distance;
    /** Of the robust kernel, 1 to 0. */
    double weight;
  };
  /** Of each that is matched, in the order of GetMatchedNames(). */
  std::vector<ResidualType>
  ComputeLandmarkResiduals(const PositionType & x) const;

  /** A matched landmark with its counterpart as one point: the middle of two. */
  struct CorrespondenceType
  {
    TransformType::InputPointType  moving; /**< On the scan: dental frame, mm. */
    TransformType::OutputPointType fixed;  /**< On the radiograph: continuous pixel index. */
  };
  std::vector<CorrespondenceType>
  GetCorrespondences() const; /**< Those that the term is made of, one a landmark. Valid after Initialize(). */

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
  Hold(HoldEnum what) override;

protected:
  LandmarkPoseMetricv4();
  ~LandmarkPoseMetricv4() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;
  void
  InitializeTerm() override;
  LightObject::Pointer
  InternalClone() const override;

private:
  /** Landmarks of one name in both sets. */
  struct PairType
  {
    std::string name;
    /** One, or one of each side. */
    std::vector<TransformType::InputPointType> moving;
    LandmarkCounterpartSet::RuleEnum           rule;
    TransformType::OutputPointType             fixed;
    /** Inverse of the covariance's Cholesky factor, lower triangle: (0,0), (1,0), (1,1). */
    double whitening[3];
  };
  using PairsType = std::vector<PairType>;

  TransformType::Pointer
  MakeTransformAt(const PositionType & x) const;
  /** Pairs of landmarks of one name. */
  PairsType
  PairByName(const MovingLandmarksType & moving, const FixedLandmarksType & fixed) const;
  /** Pairs of an analysis's landmarks with their counterparts. */
  PairsType
  PairCounterparts(const LandmarkCounterpartSet & moving, const CephalometricLandmarkSet & fixed) const;
  void
  SetWhitening(const CovarianceType & covariance, PairType & pair) const;
  /** Share in the image of each of a pair's points. */
  std::array<double, 2>
  GetShares(std::size_t number) const;
  TransformType::OutputPointType
  ProjectPair(const TransformType & transform, std::size_t number) const;
  void
  ChooseForemost(const PositionType & x);
  /** Whitened difference of a pair, and its derivative: 2 x 7, row-major. */
  void
  ComputeDifference(const TransformType & transform, std::size_t number, double difference[2], double * jacobian) const;
  const PairsType &
  GetPairs() const;

  double                                m_Sigma{ 4.0 };
  std::map<std::string, CovarianceType> m_Covariances;
  std::vector<ToothCode>                m_OutlinedTeeth;
  RobustKernel::ConstPointer            m_RobustKernel;
  double                                m_KernelWidthInSigmas{ 4.0 };
  /** Constant and shared by clones. */
  std::shared_ptr<const PairsType> m_Pairs;
  /** Which point of a pair is foremost. */
  std::vector<std::uint8_t> m_Foremost;
  /** Weights that are held, one a pair, or empty. */
  std::vector<double> m_HeldWeights;
};
} // namespace itk

#endif
