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
#include "itkDentalPhantomCaseSource.h"

#include "itkDentalPhantomFilm.h"
#include "itkDentalPhantomHand.h"
#include "itkDentalPhantomHead.h"
#include "itkDentalPhantomMath.h"
#include "itkDentalPhantomModel.h"
#include "itkDentalPhantomRadiograph.h"
#include "itkDentalPhantomTracer.h"
#include "itkMakeTriangleSurface.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
enum Output : unsigned int
{
  MeshOutput = 0,
  TracingOutput = 2,
  TrueTracingOutput = 4,
  Landmarks3DOutput = 6,
  Landmarks2DOutput = 8,
  TrueGeometryOutput = 10,
  NominalGeometryOutput = 12,
  RadiographOutput = 13,
  NumberOfOutputs = 14
};

/** Random streams that only this class uses; those of the drawings are written where they are used. */
enum CaseStream : std::uint64_t
{
  FrameStream = 318
};

/** What a level's scan.frame calls the frames, in the order of FrameEnum. */
constexpr std::array<const char *, 5> FrameWords{ { "anatomical", "shared", "separate", "centred", "upright" } };

/** Triangles of the jaw that a tracing follows where the scan is not it: brackets, flaps and holes are not traced. */
constexpr unsigned int CleanTriangles = 60000;

using RotationType = CephalometricGeometry::RotationType;
using VectorType = CephalometricGeometry::VectorType;

void
FillContour(DentalContour * contour, const std::vector<DentalPhantomTracer::Polyline> & lines)
{
  contour->Initialize();
  // All there is: without it every Update() would execute again.
  contour->SetBufferedRegion(0);
  for (const auto & line : lines)
  {
    std::vector<DentalContour::PointType> points;
    for (const auto & p : line.points)
    {
      points.emplace_back(p.data());
    }
    contour->AddPolyline(points, ToothCode(line.fdi));
  }
}
} // namespace

DentalPhantomCaseSource::DentalPhantomCaseSource()
{
  m_ImageSize[0] = 703;
  m_ImageSize[1] = 938;
  this->SetNumberOfRequiredOutputs(NumberOfOutputs);
  for (DataObjectPointerArraySizeType index = 0; index < NumberOfOutputs; ++index)
  {
    this->SetNthOutput(index, this->MakeOutput(index));
  }
}

auto
DentalPhantomCaseSource::MakeOutput(DataObjectPointerArraySizeType index) -> DataObjectPointer
{
  if (index < TracingOutput)
  {
    return MeshType::New().GetPointer();
  }
  if (index < Landmarks3DOutput)
  {
    return DentalContour::New().GetPointer();
  }
  if (index < Landmarks2DOutput)
  {
    return Landmarks3DType::New().GetPointer();
  }
  if (index < TrueGeometryOutput)
  {
    return Landmarks2DType::New().GetPointer();
  }
  if (index < RadiographOutput)
  {
    return GeometryType::New().GetPointer();
  }
  return ImageType::New().GetPointer();
}

auto
DentalPhantomCaseSource::GetMesh(unsigned int jaw) -> MeshType *
{
  return static_cast<MeshType *>(this->GetOutput(MeshOutput + jaw));
}

DentalContour *
DentalPhantomCaseSource::GetTracing(unsigned int jaw)
{
  return static_cast<DentalContour *>(this->GetOutput(TracingOutput + jaw));
}

const DentalContour *
DentalPhantomCaseSource::GetTrueTracing(unsigned int jaw)
{
  return static_cast<DentalContour *>(this->GetOutput(TrueTracingOutput + jaw));
}

auto
DentalPhantomCaseSource::GetLandmarks3D(unsigned int jaw) -> Landmarks3DType *
{
  return static_cast<Landmarks3DType *>(this->GetOutput(Landmarks3DOutput + jaw));
}

auto
DentalPhantomCaseSource::GetLandmarks2D(unsigned int jaw) -> Landmarks2DType *
{
  return static_cast<Landmarks2DType *>(this->GetOutput(Landmarks2DOutput + jaw));
}

auto
DentalPhantomCaseSource::GetTrueGeometry(unsigned int jaw) -> GeometryType *
{
  return static_cast<GeometryType *>(this->GetOutput(TrueGeometryOutput + jaw));
}

auto
DentalPhantomCaseSource::GetNominalGeometry() -> GeometryType *
{
  return static_cast<GeometryType *>(this->GetOutput(NominalGeometryOutput));
}

auto
DentalPhantomCaseSource::GetRadiograph() -> ImageType *
{
  return static_cast<ImageType *>(this->GetOutput(RadiographOutput));
}

void
DentalPhantomCaseSource::SetCohort(CohortEnum cohort)
{
  this->SetLevel(DentalPhantomLevel::Named(AcquisitionType::GetName(cohort)));
}

auto
DentalPhantomCaseSource::GetCohort() const -> CohortEnum
{
  const auto & names = DentalPhantomLevel::GetNames();
  return static_cast<CohortEnum>(std::find(names.begin(), names.end(), m_Level.name) - names.begin());
}

void
DentalPhantomCaseSource::SetLevel(const DentalPhantomLevel & level)
{
  try
  {
    level.Validate();
  }
  catch (const std::invalid_argument & error)
  {
    itkExceptionMacro(<< error.what() << " Correct it before SetLevel().");
  }
  if (level != m_Level)
  {
    m_Level = level;
    this->Modified();
  }
}

void
DentalPhantomCaseSource::SetTracedSide(TracedSideEnum side)
{
  if (side != this->GetTracedSide())
  {
    m_Level.tracedSide = ToString(side);
    this->Modified();
  }
}

auto
DentalPhantomCaseSource::GetTracedSide() const -> TracedSideEnum
{
  return TracedSideFromString(m_Level.tracedSide);
}

void
DentalPhantomCaseSource::SetFrame(FrameEnum frame)
{
  const char * const word = FrameWords.at(static_cast<std::size_t>(frame));
  // A level with mixed frames changes even where GetFrame() says the same.
  if (m_Level.frame != word)
  {
    m_Level.frame = word;
    this->Modified();
  }
}

auto
DentalPhantomCaseSource::GetFrame() const -> FrameEnum
{
  const auto word = std::find(FrameWords.begin(), FrameWords.end(), m_Level.frame);
  return word == FrameWords.end() ? FrameEnum::SharedScanner : static_cast<FrameEnum>(word - FrameWords.begin());
}

void
DentalPhantomCaseSource::SetNumberOfTriangles(unsigned int numberOfTriangles)
{
  const unsigned int clamped = std::min(std::max(numberOfTriangles, 2000u), 4000000u);
  if (clamped != m_Level.numberOfTriangles)
  {
    m_Level.numberOfTriangles = clamped;
    this->Modified();
  }
}

void
DentalPhantomCaseSource::SetMissingTeeth(const std::vector<unsigned int> & teeth)
{
  for (const unsigned int fdi : teeth)
  {
    if (fdi / 10 < 1 || fdi / 10 > 4 || fdi % 10 < 1 || fdi % 10 > 7)
    {
      itkExceptionMacro("A phantom has no tooth " << fdi << "; FDI numbers 11-17, 21-27, 31-37, 41-47 are known.");
    }
  }
  if (teeth != m_MissingTeeth)
  {
    m_MissingTeeth = teeth;
    this->Modified();
  }
}

void
DentalPhantomCaseSource::GenerateData()
{
  m_Acquisition = DentalPhantomAcquisition::Draw(m_Seed, m_Level);
  m_Acquisition.yaw += m_AdditionalYaw;
  m_Acquisition.roll += m_AdditionalRoll;
  const TracedSideEnum tracedSide = this->GetTracedSide();
  if (tracedSide == TracedSideEnum::Standard)
  {
    // Whole teeth are drawn with a drift of their own, whatever was drawn for the crowns of one side.
    m_Acquisition.correlationLength = DentalPhantomStandardTracing::CorrelationLength;
  }
  const bool traceLeft = tracedSide == TracedSideEnum::Left;

  // The dentition.
  ParametersType::Variation variation;
  variation.rotationDegrees = m_Acquisition.toothRotationDegrees;
  variation.tipDegrees = m_Level.toothTipDegrees;
  variation.torqueDegrees = m_Level.toothTorqueDegrees;
  variation.buccalOffset = m_Level.buccalOffset;
  variation.occlusalOffset = m_Level.occlusalOffset;
  variation.spacedArchProbability = m_Level.spacedProbability;
  variation.palateProbability = m_Level.palateProbability;
  m_Parameters = ParametersType::Draw(m_Seed, variation);
  m_Parameters.scannerNoise = m_Level.scannerNoise;
  m_Parameters.frame = this->GetFrame();
  if (m_Level.frame == "mixed")
  {
    // As exports are: half of them in occlusion, the others each jaw on its own.
    const double which = ReproducibleRandom(m_Seed, FrameStream).Uniform();
    m_Parameters.frame = which < 0.5    ? FrameEnum::SharedScanner
                         : which < 0.67 ? FrameEnum::SeparateScanner
                         : which < 0.84 ? FrameEnum::CentredScanner
                                        : FrameEnum::UprightScanner;
  }
  m_Traits = DentalPhantomTraits::Apply(m_Seed, m_Level, m_Parameters);
  m_Parameters.numberOfTriangles = m_Level.numberOfTriangles;
  m_Parameters.stoneBase = m_StoneBase;
  if (m_Acquisition.missingPosition != 0)
  {
    const unsigned int tooth = DentalPhantomJaw::GetIndex(!traceLeft, m_Acquisition.missingPosition - 1);
    m_Parameters.jaws[m_Acquisition.missingJaw].GetTooth(tooth).missing = true;
  }

  for (const unsigned int fdi : m_MissingTeeth)
  {
    const unsigned int quadrant = fdi / 10;
    const unsigned int tooth = DentalPhantomJaw::GetIndex(quadrant == 2 || quadrant == 3, fdi % 10 - 1);
    m_Parameters.jaws[quadrant > 2 ? 1 : 0].GetTooth(tooth).missing = true;
  }

  // The jaws.
  const unsigned int threads = this->GetNumberOfWorkUnits();
  auto               meshSource = MeshSourceType::New();
  meshSource->SetParameters(m_Parameters);
  meshSource->SetNumberOfWorkUnits(threads);
  // The jaws take most of the time, a second for 200,000 triangles: they can be ended in the midst of it.
  meshSource->AddObserver(ProgressEvent(), [this, source = meshSource.GetPointer()](const EventObject &) {
    this->UpdateProgress(0.5f * source->GetProgress());
    source->SetAbortGenerateData(this->GetAbortGenerateData());
  });
  meshSource->Update();
  const auto advance = [this](float progress) {
    this->UpdateProgress(progress);
    if (this->GetAbortGenerateData())
    {
      throw ProcessAborted(__FILE__, __LINE__);
    }
  };
  advance(0.5f);
  TriangleSurface               surfaces[2];
  std::vector<std::uint8_t>     labels[2];
  DentalPhantomModel::PointType middle{};
  std::size_t                   crownPoints = 0;
  ParametersType::RigidMotion   frames[2];
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    MeshType * mesh = jaw == 0 ? meshSource->GetUpperOutput() : meshSource->GetLowerOutput();
    surfaces[jaw] = MakeTriangleSurface<MeshType>(mesh);
    frames[jaw] = meshSource->GetParameters().ComputeFrame(jaw);
    for (auto it = mesh->GetPointData()->Begin(); it != mesh->GetPointData()->End(); ++it)
    {
      labels[jaw].push_back(static_cast<std::uint8_t>(it.Value()));
    }
    for (std::size_t i = 0; i < labels[jaw].size(); ++i)
    {
      if (labels[jaw][i] != 0)
      {
        const auto p = frames[jaw].ApplyInverse(surfaces[jaw].points[i]);
        for (unsigned int d = 0; d < 3; ++d)
        {
          middle[d] += p[d];
        }
        ++crownPoints;
      }
    }
    this->GetMesh(jaw)->Graft(mesh);
    Landmarks3DType * landmarks = this->GetLandmarks3D(jaw);
    landmarks->Initialize();
    for (const auto & landmark :
         (jaw == 0 ? meshSource->GetUpperLandmarks() : meshSource->GetLowerLandmarks())->GetLandmarks())
    {
      landmarks->AddLandmark(landmark.name, landmark.point);
    }
  }
  for (double & value : middle)
  {
    value /= std::max<double>(1.0, static_cast<double>(crownPoints));
  }

  m_Parameters = meshSource->GetParameters();
  const DentalPhantomModel & model = *meshSource->GetModel();
  const bool                 hasBrackets =
    std::any_of(m_Traits.begin(), m_Traits.end(), [](const auto & trait) { return trait.name == "bracket"; });
  const auto & scan = m_Parameters.scan;
  if (hasBrackets || scan.flaps + scan.crumbs + scan.specks + scan.holes + scan.decimateTo > 0)
  {
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      const auto clean = model.MakeCleanJaw(jaw, CleanTriangles, threads);
      surfaces[jaw] = clean.surface;
      labels[jaw] = clean.labels;
      for (auto & p : surfaces[jaw].points)
      {
        p = frames[jaw].Apply(p);
      }
    }
  }

  // Head and machine.
  const double                   facingSign = m_Facing == GeometryType::FacingEnum::Right ? 1.0 : -1.0;
  GeometryType::PixelSpacingType spacing;
  spacing.Fill(m_Acquisition.pixelSpacing);
  GeometryType::PixelIndexType principal;
  // On a raster of 0.01 px, mirrored where the patient faces left.
  principal[0] = std::nearbyint(100.0 * static_cast<double>(m_ImageSize[0]) * m_Acquisition.principalU) / 100.0;
  principal[1] = std::nearbyint(100.0 * static_cast<double>(m_ImageSize[1]) * m_Acquisition.principalV) / 100.0;
  if (facingSign < 0.0)
  {
    principal[0] = static_cast<double>(m_ImageSize[0]) - 1.0 - principal[0];
  }

  // The head turns about the ear rods; pitch about the teeth keeps them in the picture.
  const RotationType rotation = DentalPhantomHeadRotation(m_Acquisition.yaw, m_Acquisition.roll, m_Acquisition.pitch);
  VectorType         place;
  place[0] = m_Acquisition.anterior;
  place[1] = 0.0;
  place[2] = -m_Acquisition.down;
  place = DentalPhantomHeadRotation(m_Acquisition.yaw, m_Acquisition.roll, 0.0) * place;

  const auto setMachine = [&](GeometryType * geometry, double source, double detector) {
    geometry->SetSourceToMidsagittalDistance(source);
    geometry->SetSourceToDetectorDistance(detector);
    geometry->SetSourceSide(m_SourceSide);
    geometry->SetFacing(m_Facing);
    geometry->SetPrincipalPoint(principal);
    geometry->SetPixelSpacing(spacing);
    geometry->SetPoseToIdentity();
  };
  setMachine(this->GetNominalGeometry(), m_Acquisition.givenSourceToMidsagittal, m_Acquisition.givenSourceToDetector);
  VectorType middleVector(middle.data());
  // From the anatomical frame, for the radiograph.
  auto anatomical = GeometryType::New();
  setMachine(anatomical, m_Acquisition.trueSourceToMidsagittal, m_Acquisition.trueSourceToDetector);
  anatomical->SetPose(rotation, place - rotation * middleVector);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    // c = R (F^-1 q - middle) + place
    RotationType frame;
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
      {
        frame(row, column) = frames[jaw].rotation[3 * row + column];
      }
    }
    const RotationType toHead = rotation * RotationType(frame.GetTranspose());
    setMachine(this->GetTrueGeometry(jaw), m_Acquisition.trueSourceToMidsagittal, m_Acquisition.trueSourceToDetector);
    this->GetTrueGeometry(jaw)->SetPose(
      toHead, place - rotation * middleVector - toHead * VectorType(frames[jaw].translation.data()));
  }

  // The tracing.
  const double pixelSize = spacing[0] * m_Acquisition.trueSourceToMidsagittal / m_Acquisition.trueSourceToDetector;
  // Which end of a border is left out where a part is.
  ReproducibleRandom hand(m_Seed, 105);
  m_StandardTracing = nullptr;
  if (tracedSide == TracedSideEnum::Standard || m_Level.giveLandmarks)
  {
    std::map<std::string, DentalPhantomStandardTracing::PixelType> tips;
    for (unsigned int jaw = 0; jaw < 2; ++jaw)
    {
      for (const auto & landmark : this->GetLandmarks3D(jaw)->GetLandmarks())
      {
        const auto pixel = this->GetTrueGeometry(jaw)->ProjectPoint(landmark.point);
        tips[landmark.name] = { { pixel[0], pixel[1] } };
      }
    }
    m_StandardTracing = std::make_shared<const DentalPhantomStandardTracing>(
      model, anatomical->GetProjection(), tips, facingSign > 0.0 ? 1 : -1, spacing[0], m_Level, m_Seed, threads);
  }
  const DentalPhantomHand reader(
    m_Level, m_Seed, DentalPhantomStandardTracing::ComputeAlong(anatomical->GetProjection()), spacing[0]);
  const bool slips = m_Level.toothAlong > 0.0 || m_Level.toothAcross > 0.0 || m_Level.toothTurnDegrees > 0.0 ||
                     m_Level.toothScale > 0.0 || m_Level.readerBias > 0.0 || m_Level.grossProbability > 0.0;
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const GeometryType * geometry = this->GetTrueGeometry(jaw);
    const unsigned int   right = jaw == 0 ? 1 : 4;
    const unsigned int   left = jaw == 0 ? 2 : 3;
    std::vector<bool>    use;
    if (m_BuccalOutline)
    {
      for (std::size_t i = 0; i < labels[jaw].size(); ++i)
      {
        const std::uint8_t label = labels[jaw][i];
        const unsigned int position = label % 10;
        bool               buccal = true;
        if (position > 3)
        {
          const unsigned int tooth = DentalPhantomJaw::GetIndex(label / 10 != right, position - 1);
          const auto local = model.TransformToTooth(jaw, tooth, frames[jaw].ApplyInverse(surfaces[jaw].points[i]));
          buccal = local[1] > 0.15 * m_Parameters.jaws[jaw].GetTooth(tooth).buccolingual;
        }
        use.push_back(buccal);
      }
    }
    const auto trace = [&](unsigned int quadrant) {
      return DentalPhantomTracer::TraceSide(surfaces[jaw],
                                            labels[jaw],
                                            use,
                                            geometry->GetProjection(),
                                            jaw,
                                            quadrant,
                                            facingSign > 0.0 ? 1 : -1,
                                            pixelSize);
    };
    std::vector<std::vector<DentalPhantomTracer::Polyline>> drawn;
    switch (tracedSide)
    {
      case TracedSideEnum::Right:
        drawn = { trace(right) };
        break;
      case TracedSideEnum::Left:
        drawn = { trace(left) };
        break;
      case TracedSideEnum::Standard:
        break;
      case TracedSideEnum::Mean:
        drawn = { DentalPhantomTracer::Bisect(trace(right), trace(left)) };
        break;
      default:
        drawn = { trace(right), trace(left) };
        break;
    }
    const unsigned int                         skipped = m_Acquisition.untracedPosition[jaw];
    std::vector<DentalPhantomTracer::Polyline> exact;
    std::vector<DentalPhantomTracer::Polyline> noisy;
    for (std::size_t k = 0; k < drawn.size(); ++k)
    {
      auto & lines = drawn[k];
      if (skipped != 0 && k == 0)
      {
        lines.erase(std::remove_if(
                      lines.begin(), lines.end(), [skipped](const auto & line) { return line.fdi % 10u == skipped; }),
                    lines.end());
      }
      lines = DentalPhantomTracer::Resample(lines, jaw == 0 ? m_UpperNumberOfPoints : m_LowerNumberOfPoints);
      for (auto & line : lines)
      {
        const bool front = hand.Uniform() < 0.5;
        const long drop =
          std::min(static_cast<long>(std::lround(m_DropOutFraction * static_cast<double>(line.points.size()))),
                   static_cast<long>(line.points.size()) - 2);
        if (drop > 0 && front)
        {
          line.points.erase(line.points.begin(), line.points.begin() + drop);
        }
        else if (drop > 0)
        {
          line.points.erase(line.points.end() - drop, line.points.end());
        }
      }
      exact.insert(exact.end(), lines.begin(), lines.end());
      if (slips)
      {
        for (auto & line : lines)
        {
          DentalPhantomHand::Apply(reader.DrawOutline(line.fdi), line.points);
        }
      }
      DentalPhantomTracer::Noise noise;
      noise.correlated = m_Acquisition.correlatedNoise;
      noise.white = m_Acquisition.whiteNoise;
      noise.correlationLength = m_Acquisition.correlationLength;
      noise.toothShift = 1.2 * m_ToothBias;
      noise.toothRotation = 2.0 * Degree * m_ToothBias;
      noise.toothScale = 0.03 * m_ToothBias;
      DentalPhantomTracer::AddNoise(lines, noise, m_Seed, 200 + 2 * jaw + k);
      noisy.insert(noisy.end(), lines.begin(), lines.end());
    }
    FillContour(static_cast<DentalContour *>(this->GetOutput(TrueTracingOutput + jaw)), exact);
    FillContour(this->GetTracing(jaw), noisy);
    if (tracedSide == TracedSideEnum::Standard)
    {
      for (const auto & outline : m_StandardTracing->GetOutlines(jaw))
      {
        const auto add = [&outline](DentalContour * contour, const auto & from, double sigma) {
          DentalContour::PolylineType line;
          line.code = ToothCode(outline.fdi);
          line.closed = true;
          line.outline = DentalContour::OutlineEnum::Tooth;
          for (const auto & p : from)
          {
            line.points.emplace_back(p.data());
          }
          if (sigma > 0.0)
          {
            line.sigmas.assign(line.points.size(), sigma);
          }
          contour->AddPolyline(line);
        };
        add(static_cast<DentalContour *>(this->GetOutput(TrueTracingOutput + jaw)), outline.exact, 0.0);
        // What the files of such a case say of it.
        add(this->GetTracing(jaw), outline.drawn, m_Level.confidence != "none" ? outline.slip.statedSigma : 0.0);
      }
    }

    Landmarks2DType * projected = this->GetLandmarks2D(jaw);
    projected->Initialize();
    const bool both = tracedSide == TracedSideEnum::Mean || tracedSide == TracedSideEnum::Both ||
                      tracedSide == TracedSideEnum::Standard;
    for (const auto & landmark : this->GetLandmarks3D(jaw)->GetLandmarks())
    {
      if (both || landmark.tooth.IsLeft() == traceLeft)
      {
        const auto pixel = geometry->ProjectPoint(landmark.point);
        projected->AddLandmark(landmark.name, Landmarks2DType::PointType(pixel.GetDataPointer()));
      }
    }
    advance(jaw == 0 ? 0.6f : 0.7f);
  }

  ImageType * image = this->GetRadiograph();
  image->Initialize();
  if (m_MakeRadiograph)
  {
    std::vector<std::uint8_t> grey;
    if (m_Level.radiographStyle == "realistic")
    {
      DentalPhantomFilm film;
      film.projection = anatomical->GetProjection();
      film.facing = facingSign > 0.0 ? 1 : -1;
      film.earRod = { { principal[0], principal[1] } };
      film.pixelSize = pixelSize;
      film.size = { { static_cast<unsigned int>(m_ImageSize[0]), static_cast<unsigned int>(m_ImageSize[1]) } };
      film.seed = m_Seed;
      film.noise = m_Level.radiographNoise;
      film.blur = m_Level.radiographBlur;
      grey = film.Render(model, threads);
    }
    else
    {
      grey = DentalPhantomRadiograph::Render(
        model,
        anatomical->GetProjection(),
        facingSign > 0.0 ? 1 : -1,
        { { principal[0], principal[1] } },
        pixelSize,
        { { static_cast<unsigned int>(m_ImageSize[0]), static_cast<unsigned int>(m_ImageSize[1]) } },
        m_Seed,
        threads);
    }
    image->SetRegions(m_ImageSize);
    ImageType::SpacingType imageSpacing;
    imageSpacing[0] = spacing[0];
    imageSpacing[1] = spacing[1];
    image->SetSpacing(imageSpacing);
    image->Allocate();
    std::copy(grey.begin(), grey.end(), image->GetBufferPointer());
  }
  m_FrontalView = nullptr;
  if (m_Level.frontalView)
  {
    advance(0.85f);
    const DentalLandmarkSet<3> * landmarks[2] = { this->GetLandmarks3D(0), this->GetLandmarks3D(1) };
    m_FrontalView = DentalPhantomFrontalView::Make(model,
                                                   m_Level,
                                                   m_Acquisition,
                                                   m_Seed,
                                                   rotation,
                                                   place - rotation * middleVector,
                                                   frames,
                                                   landmarks,
                                                   m_ImageSize,
                                                   m_MakeRadiograph,
                                                   threads);
  }
}

void
DentalPhantomCaseSource::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "Level: " << m_Level.name << std::endl;
  os << indent << "TracedSide: " << this->GetTracedSide() << std::endl;
  os << indent << "BuccalOutline: " << m_BuccalOutline << std::endl;
  os << indent << "ToothBias: " << m_ToothBias << std::endl;
  os << indent << "DropOutFraction: " << m_DropOutFraction << std::endl;
  os << indent << "AdditionalYaw: " << m_AdditionalYaw << std::endl;
  os << indent << "AdditionalRoll: " << m_AdditionalRoll << std::endl;
  os << indent << "MissingTeeth:";
  for (const unsigned int fdi : m_MissingTeeth)
  {
    os << ' ' << fdi;
  }
  os << std::endl;
  os << indent << "UpperNumberOfPoints: " << m_UpperNumberOfPoints << std::endl;
  os << indent << "LowerNumberOfPoints: " << m_LowerNumberOfPoints << std::endl;
  os << indent << "Facing: " << m_Facing << std::endl;
  os << indent << "SourceSide: " << m_SourceSide << std::endl;
  os << indent << "Frame: " << m_Level.frame << std::endl;
  os << indent << "StoneBase: " << m_StoneBase << std::endl;
  os << indent << "NumberOfTriangles: " << m_Level.numberOfTriangles << std::endl;
  os << indent << "ImageSize: " << m_ImageSize << std::endl;
  os << indent << "MakeRadiograph: " << m_MakeRadiograph << std::endl;
  os << indent << "Traits:";
  for (const DentalPhantomTrait & trait : m_Traits)
  {
    os << ' ' << trait.name;
  }
  os << std::endl;
  os << indent << "StandardTracing: " << (m_StandardTracing ? "made" : "(null)") << std::endl;
  os << indent << "FrontalView: " << (m_FrontalView ? "made" : "(null)") << std::endl;
  os << indent << "Yaw: " << m_Acquisition.yaw << std::endl;
  os << indent << "Roll: " << m_Acquisition.roll << std::endl;
  os << indent << "Pitch: " << m_Acquisition.pitch << std::endl;
  os << indent << "CorrelatedNoise: " << m_Acquisition.correlatedNoise << std::endl;
  os << indent << "WhiteNoise: " << m_Acquisition.whiteNoise << std::endl;
  os << indent << "CorrelationLength: " << m_Acquisition.correlationLength << std::endl;
  os << indent << "Parameters:" << std::endl;
  m_Parameters.Print(os, indent.GetNextIndent());
}
} // namespace itk
