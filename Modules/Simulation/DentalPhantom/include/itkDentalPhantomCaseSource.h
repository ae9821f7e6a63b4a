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
#ifndef itkDentalPhantomCaseSource_h
#define itkDentalPhantomCaseSource_h

#include "DentalPhantomExport.h"
#include "itkCephalometricGeometry.h"
#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkDentalPhantomAcquisition.h"
#include "itkDentalPhantomFrontalView.h"
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkDentalPhantomParameters.h"
#include "itkDentalPhantomStandardTracing.h"
#include "itkDentalPhantomTraits.h"
#include "itkPerspectiveProjection.h"

#include "itkImage.h"
#include "itkProcessObject.h"
#include "itkTracedSide.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class DentalPhantomCaseSource
 * \brief A whole simulated case for a seed: two scans, a radiograph, a tracing on it, and the truth.
 *
 * Cohorts, as method.md section 2 defines them:
 *
 *   - ideal: no yaw or roll, central ray through the teeth's midpoint, true distances given, no tracing noise;
 *   - typical: yaw and roll 1.5 degrees (1 sd), true distances 1500/1524/1650 + 110...190 mm where 1524/1674 are given,
 *     principal point at the ear rods, tracing noise 1.2 px correlated over 10-20 px and 0.5 px white, tooth rotations
 *     5 degrees (1 sd);
 *   - hard: yaw and roll 3 degrees, noise 2.2 and 1.0 px, tooth rotations 9 degrees, in half of the cases a tooth of
 * the side that is not traced is missing, in half of the jaws one of the traced side is not traced.
 *
 * Real, real-hard, standard and practice are the tables of DentalPhantomLevel, which can be given parameter by
 * parameter; traits of real arches are DentalPhantomTraits, standard tracings DentalPhantomStandardTracing.
 *
 * The pitch is 8 degrees (5 sd) in all of them and the pixel spacing 0.24-0.26 mm, known. The tracing holds the labial
 * border of the central incisor and the incisal or occlusal border of the other crowns of the traced side, one polyline
 * a tooth, in pixels of the radiograph.
 *
 * GetNominalGeometry() is what a clinic would know; GetTrueGeometry() maps a jaw's mesh to the radiograph exactly.
 * Everything is the same for the same seed and settings whatever the number of work units.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomCaseSource : public ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalPhantomCaseSource);

  using Self = DentalPhantomCaseSource;
  using Superclass = ProcessObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalPhantomCaseSource, ProcessObject);

  using MeshType = Mesh<float, 3>;
  using MeshSourceType = DentalPhantomMeshSource<MeshType>;
  using ParametersType = DentalPhantomParameters;
  using GeometryType = CephalometricGeometry;
  using ImageType = Image<unsigned char, 2>;
  using Landmarks3DType = DentalLandmarkSet<3>;
  using Landmarks2DType = DentalLandmarkSet<2>;
  using FrameEnum = ParametersType::FrameEnum;
  using ImageSizeType = ImageType::SizeType;

  using AcquisitionType = DentalPhantomAcquisition;
  using CohortEnum = AcquisitionType::CohortEnum;

  using TracedSideEnum = itk::TracedSideEnum;
  /** What the case is drawn from; 1 by default. */
  itkSetMacro(Seed, std::uint64_t);
  itkGetConstMacro(Seed, std::uint64_t);

  /** A level's table of parameters; default Typical. The same as SetLevel(DentalPhantomLevel::Named()), hence call it
   * before the setters of traced side, frame and number of triangles. */
  void
  SetCohort(CohortEnum cohort);
  CohortEnum
  GetCohort() const;

  /** Every parameter of how bad the case may be. Traced side, frame and number of triangles are parameters of the
   * level: their setters change the level that is set, so that the last call wins whichever it is, and GetLevel() says
   * what the case is made with. Throws where a parameter is out of its range. */
  void
  SetLevel(const DentalPhantomLevel & level);
  const DentalPhantomLevel &
  GetLevel() const
  {
    return m_Level;
  }

  /** The level's tracing.side. Default Right. */
  void
  SetTracedSide(TracedSideEnum side);
  TracedSideEnum
  GetTracedSide() const;

  /** Follow the buccal cusps of premolars and molars, which lie inside the silhouette where the oral cusps hang lower.
   * Default off. */
  itkSetMacro(BuccalOutline, bool);
  itkGetConstMacro(BuccalOutline, bool);
  itkBooleanMacro(BuccalOutline);

  /** Each tooth drawn with an error of its own, as a factor on 1.2 px shift, 2 degrees, 3 % scale (1 sd). Default 0. */
  itkSetClampMacro(ToothBias, double, 0.0, 10.0);
  itkGetConstMacro(ToothBias, double);

  /** The part of each tooth's border that is not drawn, at one of its ends. Default 0. */
  itkSetClampMacro(DropOutFraction, double, 0.0, 0.9);
  itkGetConstMacro(DropOutFraction, double);

  /** Turns of the head about the vertical and the anterior axis beyond those that the cohort draws, rad. Default 0. */
  itkSetMacro(AdditionalYaw, double);
  itkGetConstMacro(AdditionalYaw, double);
  itkSetMacro(AdditionalRoll, double);
  itkGetConstMacro(AdditionalRoll, double);

  /** Teeth that the jaws lack beyond what the cohort draws, FDI numbers 11-17 to 41-47. Default none. */
  void
  SetMissingTeeth(const std::vector<unsigned int> & teeth);
  const std::vector<unsigned int> &
  GetMissingTeeth() const
  {
    return m_MissingTeeth;
  }

  /** A tracing that covers these numbers of points; 79 and 75 as in the paper. */
  itkSetClampMacro(UpperNumberOfPoints, unsigned int, 20, 100000);
  itkGetConstMacro(UpperNumberOfPoints, unsigned int);
  itkSetClampMacro(LowerNumberOfPoints, unsigned int, 20, 100000);
  itkGetConstMacro(LowerNumberOfPoints, unsigned int);

  /** Default Right and Right. */
  itkSetEnumMacro(Facing, GeometryType::FacingEnum);
  itkGetEnumMacro(Facing, GeometryType::FacingEnum);
  itkSetEnumMacro(SourceSide, GeometryType::SourceSideEnum);
  itkGetEnumMacro(SourceSide, GeometryType::SourceSideEnum);

  /** The meshes' frame, the level's scan.frame. Default SharedScanner. A level with mixed frames draws one, which
   * GetParameters() holds after Update(); GetFrame() says SharedScanner for it. */
  void
  SetFrame(FrameEnum frame);
  FrameEnum
  GetFrame() const;

  /** Closed casts with bases instead of open shells. Default off. */
  itkSetMacro(StoneBase, bool);
  itkGetConstMacro(StoneBase, bool);
  itkBooleanMacro(StoneBase);

  /** Of each jaw, the level's scan.triangles, clamped to 2000 to 4000000. Default 60000. */
  void
  SetNumberOfTriangles(unsigned int numberOfTriangles);
  unsigned int
  GetNumberOfTriangles() const
  {
    return m_Level.numberOfTriangles;
  }

  /** Default 703 x 938. */
  itkSetMacro(ImageSize, ImageSizeType);
  itkGetConstReferenceMacro(ImageSize, ImageSizeType);

  /** Whether to simulate the radiograph, which costs most of the time. Default on; off, GetRadiograph() is empty. */
  itkSetMacro(MakeRadiograph, bool);
  itkGetConstMacro(MakeRadiograph, bool);
  itkBooleanMacro(MakeRadiograph);

  /** Outputs. Meshes and 3-D landmarks are in the frame of the meshes; an upper one where an argument jaw is 0, a lower
   * one for 1. */
  MeshType *
  GetMesh(unsigned int jaw);
  DentalContour *
  GetTracing(unsigned int jaw);
  Landmarks3DType *
  GetLandmarks3D(unsigned int jaw);
  /** True projections of the landmarks of the traced side; of both for Mean and Both. */
  Landmarks2DType *
  GetLandmarks2D(unsigned int jaw);
  /** Pose from the jaw's mesh frame to the cephalostat, true distances. */
  GeometryType *
  GetTrueGeometry(unsigned int jaw);
  /** The geometry a clinic would state; without a pose. */
  GeometryType *
  GetNominalGeometry();
  ImageType *
  GetRadiograph();

  /** What was drawn; valid after Update(). */
  const ParametersType &
  GetParameters() const
  {
    return m_Parameters;
  }
  const AcquisitionType &
  GetAcquisition() const
  {
    return m_Acquisition;
  }
  /** The traits of real arches that the dentition has; valid after Update(). */
  const std::vector<DentalPhantomTrait> &
  GetTraits() const
  {
    return m_Traits;
  }
  /** Outlines and landmarks of a standard tracing with their errors; null without. Valid after Update(). */
  const DentalPhantomStandardTracing *
  GetStandardTracing() const
  {
    return m_StandardTracing.get();
  }
  using FrontalView = DentalPhantomFrontalView;
  /** Null where the level has none; valid after Update(). */
  const FrontalView *
  GetFrontalView() const
  {
    return m_FrontalView.get();
  }

  /** The tracing's points before noise, in the order of GetTracing(). */
  const DentalContour *
  GetTrueTracing(unsigned int jaw);

  using Superclass::MakeOutput;
  DataObjectPointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  DentalPhantomCaseSource();
  ~DentalPhantomCaseSource() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::uint64_t                m_Seed{ 1 };
  DentalPhantomLevel           m_Level;
  bool                         m_BuccalOutline{ false };
  double                       m_ToothBias{ 0.0 };
  double                       m_DropOutFraction{ 0.0 };
  double                       m_AdditionalYaw{ 0.0 };
  double                       m_AdditionalRoll{ 0.0 };
  std::vector<unsigned int>    m_MissingTeeth;
  unsigned int                 m_UpperNumberOfPoints{ 79 };
  unsigned int                 m_LowerNumberOfPoints{ 75 };
  GeometryType::FacingEnum     m_Facing{ GeometryType::FacingEnum::Right };
  GeometryType::SourceSideEnum m_SourceSide{ GeometryType::SourceSideEnum::Right };
  bool                         m_StoneBase{ false };
  ImageSizeType                m_ImageSize;
  bool                         m_MakeRadiograph{ true };

  ParametersType                                      m_Parameters;
  AcquisitionType                                     m_Acquisition;
  std::vector<DentalPhantomTrait>                     m_Traits;
  std::shared_ptr<const DentalPhantomStandardTracing> m_StandardTracing;
  std::shared_ptr<const FrontalView>                  m_FrontalView;
};
} // namespace itk

#endif
