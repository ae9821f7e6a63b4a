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
// Executions of whole chains: each object once, nothing on a second Update(), after a change what lies downstream of
// it. The chains are those of Documentation/Pipeline.md: the objects of preset paper and of preset robust, from files
// on.
#include "itkCephalogramFileReader.h"
#include "itkContourDistanceFilter.h"
#include "itkContourMaskFilter.h"
#include "itkContourResampleFilter.h"
#include "itkCrownRegionMeshFilter.h"
#include "itkDentalContourFileReader.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkDentalPhantomCaseWriter.h"
#include "itkDentalPhantomMeshSource.h"
#include "itkLandmarkErrorFilter.h"
#include "itkLandmarkProjectionFilter.h"
#include "itkMatchedContourFilter.h"
#include "itkMeshSilhouetteContourSource.h"
#include "itkMidlineSideMeshFilter.h"
#include "itkOpenMeshMeshIOFactory.h"
#include "itkOpenSilhouetteContourSource.h"
#include "itkPipelineExecutions.h"
#include "itkPoseRegistrationMethod.h"
#include "itkProjectionSimilarityFilter.h"
#include "itkRegistrationOverlayFilter.h"
#include "itkRegistrationVerdictFilter.h"
#include "itkSilhouetteContourFilter.h"
#include "itkSilhouetteToContourRegistrationMethod.h"
#include "itkSurfaceDRRImageSource.h"
#include "itkUMidlineDentalAxisFilter.h"

#include "itkMeshFileReader.h"
#include "itkStreamingImageFilter.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <string>

namespace
{
using MeshType = itk::Mesh<float, 3>;
using ImageType = itk::Image<float, 2>;
using PictureType = itk::RegistrationOverlayFilter::PictureType;
using JawEnum = itk::ToothCode::JawEnum;
using Executions = itk::PipelineExecutions;
using Names = Executions::NamesType;

template <typename TProcess>
typename TProcess::Pointer
Make(const char * name)
{
  auto process = TProcess::New();
  process->SetObjectName(name);
  return process;
}

/** Readers of a case on disk, and the frames of its jaws. */
class Pipeline : public ::testing::Test
{
protected:
  static void
  SetUpTestSuite()
  {
    // Of the process: the tests of this file may run at the same time.
    s_Folder = std::string(DENTALSCR_TEST_OUTPUT_DIR) + "/Pipeline" + std::to_string(::getpid());
    auto source = itk::DentalPhantomCaseSource::New();
    source->SetSeed(15);
    source->SetNumberOfTriangles(12000);
    auto writer = itk::DentalPhantomCaseWriter::New();
    writer->SetCaseSource(source);
    writer->SetDirectoryName(s_Folder);
    writer->Update();
    itk::RegisterOpenMeshMeshIOFactories();
  }
  static void
  TearDownTestSuite()
  {
    std::filesystem::remove_all(s_Folder);
  }

  void
  SetUp() override
  {
    m_Upper->SetFileName(s_Folder + "/upper.stl");
    m_Lower->SetFileName(s_Folder + "/lower.stl");
    m_Tracing->SetFileName(s_Folder + "/contours.json");
    m_Axis->SetUpperMesh(m_Upper->GetOutput());
    m_Axis->SetLowerMesh(m_Lower->GetOutput());
    m_Geometry->SetPixelSpacing(itk::CephalometricGeometry::PixelSpacingType(0.25));
  }

  static std::string s_Folder;

  itk::MeshFileReader<MeshType>::Pointer           m_Upper{ Make<itk::MeshFileReader<MeshType>>("upper") };
  itk::MeshFileReader<MeshType>::Pointer           m_Lower{ Make<itk::MeshFileReader<MeshType>>("lower") };
  itk::DentalContourFileReader::Pointer            m_Tracing{ Make<itk::DentalContourFileReader>("tracing") };
  itk::UMidlineDentalAxisFilter<MeshType>::Pointer m_Axis{ Make<itk::UMidlineDentalAxisFilter<MeshType>>("axis") };
  itk::CephalometricGeometry::Pointer              m_Geometry{ itk::CephalometricGeometry::New() };
};
std::string Pipeline::s_Folder;

/** The paper's: crowns in the frame, radiograph, contour, registration, distances. */
class PaperPipeline : public Pipeline
{
protected:
  void
  SetUp() override
  {
    Pipeline::SetUp();
    m_Crowns->SetInput(m_Axis->GetUpperOutput());
    m_DRR->SetInput(m_Crowns->GetOutput());
    m_DRR->SetGeometry(m_Geometry);
    m_Silhouette->SetInput(m_DRR->GetOutput());
    m_Silhouette->SetLevel(itk::SilhouetteContourFilterEnums::Level::Absolute);
    m_Silhouette->SetLevelValue(0.5);
    m_Resample->SetInput(m_Silhouette->GetOutput());
    m_Resample->SetNumberOfPoints(200);
    m_Registration->SetFixedContour(m_Tracing->GetUpperOutput());
    m_Registration->SetMovingContour(m_Resample->GetOutput());
    m_Distances->SetFixedContour(m_Tracing->GetUpperOutput());
    m_Distances->SetMovingContour(m_Resample->GetOutput());
    m_Distances->SetTransformInput(m_Registration->GetOutput());
  }

  using DRRType = itk::SurfaceDRRImageSource<MeshType, ImageType>;
  itk::CrownRegionMeshFilter<MeshType>::Pointer       m_Crowns{ Make<itk::CrownRegionMeshFilter<MeshType>>("crowns") };
  DRRType::Pointer                                    m_DRR{ Make<DRRType>("drr") };
  itk::SilhouetteContourFilter<ImageType>::Pointer    m_Silhouette{ Make<itk::SilhouetteContourFilter<ImageType>>(
    "silhouette") };
  itk::ContourResampleFilter::Pointer                 m_Resample{ Make<itk::ContourResampleFilter>("resample") };
  itk::SilhouetteToContourRegistrationMethod::Pointer m_Registration{ Make<itk::SilhouetteToContourRegistrationMethod>(
    "registration") };
  itk::ContourDistanceFilter::Pointer                 m_Distances{ Make<itk::ContourDistanceFilter>("distances") };
};

/** Preset robust's: pose, verdict, landmarks, outline where it lies, picture. */
class RobustPipeline : public Pipeline
{
protected:
  using MethodType = itk::PoseRegistrationMethod<MeshType>;
  using OutlineType = itk::OpenSilhouetteContourSource<MeshType>;

  void
  SetUp() override
  {
    Pipeline::SetUp();
    m_Axis->RefineMidlineOn();
    m_Radiograph->SetFileName(s_Folder + "/ceph.png");
    m_Scan3D->SetFileName(s_Folder + "/landmarks3d.json");
    m_Marked->SetFileName(s_Folder + "/landmarks2d.json");
    m_Method->SetUpperMesh(m_Upper->GetOutput());
    m_Method->SetLowerMesh(m_Lower->GetOutput());
    m_Method->SetUpperContour(m_Tracing->GetUpperOutput());
    m_Method->SetLowerContour(m_Tracing->GetLowerOutput());
    m_Method->SetGeometry(m_Geometry);
    m_Method->SetUpperFrame(m_Axis->GetUpperTransformOutput());
    m_Method->SetLowerFrame(m_Axis->GetLowerTransformOutput());
    m_Method->SetJointFrame(m_Axis->GetJointTransformOutput());
    m_Method->PrincipalPointKnownOff();
    m_Verdict->SetSolution(m_Method->GetOutput());
    m_Projection->SetSolution(m_Method->GetOutput());
    m_Projection->SetLandmarks(m_Scan3D->GetOutput());
    m_Errors->SetPredictedLandmarks(m_Projection->GetOutput());
    m_Errors->SetReferenceLandmarks(m_Marked->GetOutput());
    m_Similarity->SetSolution(m_Method->GetOutput());
    m_Similarity->SetMesh(m_Upper->GetOutput());
    m_Similarity->SetFrame(m_Axis->GetUpperTransformOutput());
    m_Half->SetInput(m_Upper->GetOutput());
    m_Half->SetFrameTransformInput(m_Axis->GetUpperTransformOutput());
    m_Outline->SetInput(m_Half->GetOutput());
    m_Outline->SetFrameTransformInput(m_Axis->GetUpperTransformOutput());
    m_Outline->SetGeometry(m_Method->GetGeometryOutput(JawEnum::Upper));
    m_Whole->SetInput(m_Upper->GetOutput());
    m_Whole->SetGeometry(m_Method->GetGeometryOutput(JawEnum::Upper));
    m_Matched->SetFixedContour(m_Tracing->GetUpperOutput());
    m_Matched->SetMovingContour(m_Outline->GetOutput());
    m_Overlay->SetRadiograph(m_Radiograph->GetOutput());
    m_Overlay->SetFixedContour(m_Tracing->GetUpperOutput());
    m_Overlay->SetMovingContour(0, m_Matched->GetOutput(), "matched");
    m_Overlay->SetMovingContour(1, m_Whole->GetOutput(), "whole");
    m_Overlay->SetPredictedLandmarks(m_Projection->GetOutput());
    m_Picture->SetInput(m_Overlay->GetOutput());
    m_Picture->SetNumberOfStreamDivisions(16);
  }

  /** All that a user would want of it. */
  void
  UpdateAll()
  {
    m_Picture->Update();
    m_Verdict->Update();
    m_Errors->Update();
    m_Similarity->Update();
  }
  std::vector<itk::ProcessObject *>
  GetLast()
  {
    return { m_Picture, m_Verdict, m_Errors, m_Similarity };
  }

  itk::CephalogramFileReader::Pointer           m_Radiograph{ Make<itk::CephalogramFileReader>("radiograph") };
  itk::DentalLandmarkFileReader<3>::Pointer     m_Scan3D{ Make<itk::DentalLandmarkFileReader<3>>("landmarks") };
  itk::DentalLandmarkFileReader<2>::Pointer     m_Marked{ Make<itk::DentalLandmarkFileReader<2>>("marked") };
  MethodType::Pointer                           m_Method{ Make<MethodType>("registration") };
  itk::RegistrationVerdictFilter::Pointer       m_Verdict{ Make<itk::RegistrationVerdictFilter>("verdict") };
  itk::LandmarkProjectionFilter::Pointer        m_Projection{ Make<itk::LandmarkProjectionFilter>("projection") };
  itk::LandmarkErrorFilter::Pointer             m_Errors{ Make<itk::LandmarkErrorFilter>("errors") };
  itk::ProjectionSimilarityFilter::Pointer      m_Similarity{ Make<itk::ProjectionSimilarityFilter>("similarity") };
  itk::MidlineSideMeshFilter<MeshType>::Pointer m_Half{ Make<itk::MidlineSideMeshFilter<MeshType>>("half") };
  OutlineType::Pointer                          m_Outline{ Make<OutlineType>("outline") };
  itk::MeshSilhouetteContourSource<MeshType>::Pointer m_Whole{ Make<itk::MeshSilhouetteContourSource<MeshType>>(
    "whole") };
  itk::MatchedContourFilter::Pointer                  m_Matched{ Make<itk::MatchedContourFilter>("matched") };
  itk::RegistrationOverlayFilter::Pointer             m_Overlay{ Make<itk::RegistrationOverlayFilter>("overlay") };
  itk::StreamingImageFilter<PictureType, PictureType>::Pointer m_Picture{
    Make<itk::StreamingImageFilter<PictureType, PictureType>>("picture")
  };
};
} // namespace

TEST_F(PaperPipeline, PulledColdInStripsEachObjectUpstreamExecutesOnce)
{
  const auto streamer = Make<itk::StreamingImageFilter<ImageType, ImageType>>("streamer");
  streamer->SetInput(m_DRR->GetOutput());
  streamer->SetNumberOfStreamDivisions(16);
  Executions executions({ streamer });
  const auto update = [&streamer]() { streamer->UpdateLargestPossibleRegion(); };
  EXPECT_EQ(executions.During(update), (Names{ "axis", "crowns", "drr x16", "lower", "streamer", "upper" }));
  EXPECT_EQ(executions.During(update), Names{});
  m_DRR->SetDensity(2.0);
  EXPECT_EQ(executions.During(update), (Names{ "drr x16", "streamer" }));
  m_Crowns->SetMinimumCrownHeight(3.5);
  EXPECT_EQ(executions.During(update), (Names{ "crowns", "drr x16", "streamer" }));
  EXPECT_EQ(m_DRR->GetNumberOfFlattenings(), 2u);
  EXPECT_EQ(m_DRR->GetNumberOfProjections(), 3u);
}

TEST_F(PaperPipeline, AContourThatPullsStripsIsTheSameAndExecutesUpstreamOnce)
{
  Executions executions({ m_Silhouette });
  const auto update = [this]() { m_Silhouette->Update(); };
  EXPECT_EQ(executions.During(update), (Names{ "axis", "crowns", "drr", "lower", "silhouette", "upper" }));
  const auto whole = m_Silhouette->GetOutput()->GetPolylines();
  const auto image = m_DRR->GetOutput()->GetLargestPossibleRegion();
  EXPECT_EQ(m_DRR->GetOutput()->GetBufferedRegion(), image);

  // As the whole image is there it is not made again, in strips or not.
  m_Silhouette->SetNumberOfStreamDivisions(16);
  EXPECT_EQ(executions.During(update), (Names{ "silhouette" }));
  m_DRR->GetOutput()->ReleaseData();
  m_Silhouette->Modified();
  EXPECT_EQ(executions.During(update), (Names{ "drr x16", "silhouette" }));
  EXPECT_EQ(executions.During(update), Names{});
  EXPECT_LE(m_DRR->GetOutput()->GetBufferedRegion().GetSize(1), image.GetSize(1) / 16 + 1);
  const auto strips = m_Silhouette->GetOutput()->GetPolylines();
  ASSERT_EQ(strips.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    EXPECT_EQ(strips[i].points, whole[i].points);
  }
}

TEST_F(PaperPipeline, OneUpdateRunsAllOnceASecondNothingAndAChangeWhatLiesBelow)
{
  Executions  executions({ m_Distances });
  const auto  update = [this]() { m_Distances->Update(); };
  const Names all{ "axis",         "crowns",   "distances",  "drr",     "lower",
                   "registration", "resample", "silhouette", "tracing", "upper" };
  EXPECT_EQ(executions.GetNames(), all);
  EXPECT_EQ(executions.During(update), all);
  EXPECT_EQ(executions.During(update), Names{});

  m_Registration->SetNumberOfLevels(2);
  EXPECT_EQ(executions.During(update), (Names{ "distances", "registration" }));
  m_Resample->SetNumberOfPoints(300);
  EXPECT_EQ(executions.During(update), (Names{ "distances", "registration", "resample" }));
  m_Silhouette->SetLevelValue(0.6);
  EXPECT_EQ(executions.During(update), (Names{ "distances", "registration", "resample", "silhouette" }));
  m_Geometry->SetSourceToDetectorDistance(1700.0);
  EXPECT_EQ(executions.During(update), (Names{ "distances", "drr", "registration", "resample", "silhouette" }));
  m_Tracing->SetNumbering(itk::ToothCode::NumberingEnum::FDI);
  EXPECT_EQ(executions.During(update), (Names{ "distances", "registration", "tracing" }));
  m_Axis->RefineMidlineOn();
  EXPECT_EQ(executions.During(update),
            (Names{ "axis", "crowns", "distances", "drr", "registration", "resample", "silhouette" }));
  EXPECT_EQ(executions.During(update), Names{});
}

TEST_F(RobustPipeline, OneUpdateRunsAllOnceASecondNothingAndAChangeWhatLiesBelow)
{
  Executions executions(this->GetLast());
  const auto update = [this]() { this->UpdateAll(); };
  EXPECT_EQ(executions.During(update), executions.GetNames());
  EXPECT_EQ(executions.GetNames().size(), 18u);
  EXPECT_EQ(executions.During(update), Names{});

  m_Overlay->SetTitle("changed");
  EXPECT_EQ(executions.During(update), (Names{ "overlay", "picture" }));
  m_Projection->SetMillimetresPerUnit(1.001);
  EXPECT_EQ(executions.During(update), (Names{ "errors", "overlay", "picture", "projection" }));
  m_Matched->SetMaximumDistance(9.0);
  EXPECT_EQ(executions.During(update), (Names{ "matched", "overlay", "picture" }));
  m_Half->SetMargin(1.5);
  EXPECT_EQ(executions.During(update), (Names{ "half", "matched", "outline", "overlay", "picture" }));
  m_Similarity->Modified();
  EXPECT_EQ(executions.During(update), (Names{ "similarity" }));
  m_Method->SetSpacingSource(itk::ScalePrior::SpacingSource::Dicom);
  EXPECT_EQ(executions.During(update),
            (Names{ "errors",
                    "matched",
                    "outline",
                    "overlay",
                    "picture",
                    "projection",
                    "registration",
                    "similarity",
                    "verdict",
                    "whole" }));
  EXPECT_EQ(executions.During(update), Names{});
}

TEST_F(RobustPipeline, ATransformThatIsAskedForFirstDoesNotCostTheMeshesAnExecution)
{
  // Of a filter with outputs of several kinds all are made by whichever is asked for.
  Executions executions({ m_Axis });
  EXPECT_EQ(executions.During([this]() { m_Axis->GetLowerTransformOutput()->Update(); }),
            (Names{ "axis", "lower", "upper" }));
  EXPECT_EQ(executions.During([this]() {
    m_Axis->GetUpperOutput()->Update();
    m_Axis->GetLowerOutput()->Update();
    m_Axis->GetJointTransformOutput()->Update();
  }),
            Names{});

  const auto phantom = itk::DentalPhantomMeshSource<MeshType>::New();
  Executions ofPhantom({ phantom });
  EXPECT_EQ(ofPhantom.During([&phantom]() { phantom->GetUpperLandmarks()->Update(); }),
            (Names{ "DentalPhantomMeshSource" }));
  EXPECT_EQ(ofPhantom.During([&phantom]() {
    phantom->GetUpperOutput()->Update();
    phantom->GetLowerOutput()->Update();
  }),
            Names{});
  const auto source = itk::DentalPhantomCaseSource::New();
  source->SetNumberOfTriangles(8000);
  source->MakeRadiographOff();
  Executions ofCase({ source });
  EXPECT_EQ(ofCase.During([&source]() { source->GetTrueGeometry(0)->Update(); }), (Names{ "DentalPhantomCaseSource" }));
  EXPECT_EQ(ofCase.During([&source]() {
    source->GetMesh(1)->Update();
    source->GetTracing(0)->Update();
    source->GetLandmarks3D(1)->Update();
  }),
            Names{});
}
