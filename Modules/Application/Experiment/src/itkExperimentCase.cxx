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
#include "itkExperimentCase.h"

#include "itkExperimentMistakeMaker.h"
#include "itkExperimentMonitor.h"

#include "itkDentalCaseFileReader.h"
#include "itkDentalCaseLoader.h"
#include "itkDentalInputError.h"
#include "itkDentalLandmarkFileReader.h"
#include "itkMath.h"
#include "itkReproducibleRandom.h"
#include "itkUMidlineDentalAxisFilter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace itk
{
namespace
{
using MeshType = DentalCaseData::MeshType;
using AxesType = std::array<std::array<double, 3>, 3>;
constexpr double Degree = Math::pi / 180.0;
/** Streams of the seed that the phantom does not use. */
enum Stream : std::uint64_t
{
  TiltStream = 901,
  NoiseStream = 902
};

void
EstimateFrames(ExperimentCase & experimentCase, const std::function<bool()> & isAborted)
{
  const DentalCaseData & data = *experimentCase.data;
  auto                   axis = UMidlineDentalAxisFilter<MeshType>::New();
  axis->SetUpperMesh(data.upper.mesh);
  axis->SetLowerMesh(data.lower.mesh);
  axis->SetJawsShareFrame(ToJawsShareFrame(data.description.occlusion));
  axis->RequireArchesOff();
  axis->TransformMeshesOff();
  AbortWhere(isAborted, axis);
  axis->Update();
  experimentCase.frames = axis->GetFrame();
}

/** A random rotation by at most 15 degrees. */
AxesType
DrawTilt(std::uint64_t seed)
{
  ReproducibleRandom    random(seed, TiltStream);
  std::array<double, 3> axis{ { random.Normal(), random.Normal(), random.Normal() } };
  const double          length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  for (double & value : axis)
  {
    value /= length;
  }
  const double angle = random.Uniform(0.0, 15.0 * Degree);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  AxesType     tilt{};
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int j = (i + 1) % 3;
    const unsigned int k = (i + 2) % 3;
    tilt[i][i] = c + (1.0 - c) * axis[i] * axis[i];
    tilt[i][j] = (1.0 - c) * axis[i] * axis[j] - s * axis[k];
    tilt[i][k] = (1.0 - c) * axis[i] * axis[k] + s * axis[j];
  }
  return tilt;
}

/** The proper signed permutation nearest to the axes. */
AxesType
NearestPermutation(const AxesType & axes)
{
  AxesType best{};
  double   bestTrace = -4.0;
  int      order[3] = { 0, 1, 2 };
  do
  {
    const double parity = (order[1] - order[0]) * (order[2] - order[1]) * (order[2] - order[0]) > 0 ? 1.0 : -1.0;
    for (unsigned int signs = 0; signs < 8; ++signs)
    {
      double   determinant = parity;
      double   trace = 0.0;
      AxesType candidate{};
      for (unsigned int row = 0; row < 3; ++row)
      {
        const double sign = (signs >> row & 1u) != 0 ? -1.0 : 1.0;
        candidate[row][order[row]] = sign;
        determinant *= sign;
        trace += sign * axes[row][order[row]];
      }
      if (determinant > 0.0 && trace > bestTrace)
      {
        bestTrace = trace;
        best = candidate;
      }
    }
  } while (std::next_permutation(order, order + 3));
  return best;
}

/** The mesh without what lies within `amount` mm of its distal end. */
MeshType::Pointer
TrimDistally(const MeshType * mesh, const DentalJawFrame & frame, double amount)
{
  std::vector<double> x;
  for (auto it = mesh->GetPoints()->Begin(); it != mesh->GetPoints()->End(); ++it)
  {
    double sum = 0.0;
    for (unsigned int d = 0; d < 3; ++d)
    {
      sum += frame.axes[0][d] * it.Value()[d];
    }
    x.push_back(sum);
  }
  const double limit = *std::min_element(x.begin(), x.end()) + amount;
  auto         trimmed = MeshType::New();
  trimmed->SetPoints(const_cast<MeshType *>(mesh)->GetPoints());
  using CellType = MeshType::CellType;
  using TriangleType = TriangleCell<CellType>;
  IdentifierType number = 0;
  for (auto it = mesh->GetCells()->Begin(); it != mesh->GetCells()->End(); ++it)
  {
    const auto * ids = it.Value()->GetPointIds();
    if (x[ids[0]] >= limit && x[ids[1]] >= limit && x[ids[2]] >= limit)
    {
      CellType::CellAutoPointer cell;
      cell.TakeOwnership(new TriangleType);
      for (unsigned int corner = 0; corner < 3; ++corner)
      {
        cell->SetPointId(static_cast<int>(corner), ids[corner]);
      }
      trimmed->SetCell(number++, cell);
    }
  }
  // Points that no triangle uses are not part of the surface.
  auto                                     points = MeshType::PointsContainer::New();
  std::map<IdentifierType, IdentifierType> numbers;
  for (auto it = trimmed->GetCells()->Begin(); it != trimmed->GetCells()->End(); ++it)
  {
    for (unsigned int corner = 0; corner < 3; ++corner)
    {
      const IdentifierType id = it.Value()->GetPointIds()[corner];
      const auto           inserted = numbers.emplace(id, numbers.size());
      if (inserted.second)
      {
        points->InsertElement(inserted.first->second, mesh->GetPoint(id));
      }
      it.Value()->SetPointId(static_cast<int>(corner), inserted.first->second);
    }
  }
  trimmed->SetPoints(points);
  return trimmed;
}

void
AddNoise(DentalContour::Pointer & contour, double sigma, ReproducibleRandom & random)
{
  auto         noisy = DentalContour::New();
  const double part = sigma * std::sqrt(0.5);
  for (auto polyline : contour->GetPolylines())
  {
    double                     slow[2] = { random.Normal(), random.Normal() };
    DentalContour::PointType * last = nullptr;
    DentalContour::PointType   lastPlace;
    for (auto & point : polyline.points)
    {
      // First-order autoregressive along the line, 15 px.
      const double keep = last == nullptr ? 1.0 : std::exp(-point.EuclideanDistanceTo(lastPlace) / 15.0);
      lastPlace = point;
      last = &point;
      for (unsigned int d = 0; d < 2; ++d)
      {
        slow[d] = keep * slow[d] + std::sqrt(std::max(0.0, 1.0 - keep * keep)) * random.Normal();
        point[d] += part * (slow[d] + random.Normal());
      }
    }
    noisy->AddPolyline(polyline);
  }
  contour = noisy;
}
} // namespace

ExperimentCase
MakePhantomExperimentCase(std::uint64_t                       seed,
                          DentalPhantomCaseSource::CohortEnum cohort,
                          bool                                withRadiograph,
                          const ExperimentVariation &         variation,
                          const std::function<bool()> &       isAborted)
{
  return MakePhantomExperimentCase(
    seed, DentalPhantomLevel::Named(DentalPhantomAcquisition::GetName(cohort)), withRadiograph, variation, isAborted);
}

ExperimentCase
MakePhantomExperimentCase(std::uint64_t                 seed,
                          const DentalPhantomLevel &    level,
                          bool                          withRadiograph,
                          const ExperimentVariation &   variation,
                          const std::function<bool()> & isAborted)
{
  using MistakeEnum = ExperimentMistakeEnums::Mistake;
  const MistakeEnum mistake = variation.mistake;
  auto              source = DentalPhantomCaseSource::New();
  source->SetSeed(seed);
  source->SetLevel(level);
  source->SetMakeRadiograph(withRadiograph);
  source->SetDropOutFraction(variation.dropOut);
  source->SetAdditionalYaw(variation.yawDegrees * Degree);
  source->SetAdditionalRoll(variation.rollDegrees * Degree);
  source->SetMissingTeeth(variation.missingTeeth);
  // What the case says: a mistake is that the tracing is of the other side.
  TracedSideEnum said = variation.tracedSide.value_or(source->GetTracedSide());
  if (mistake == MistakeEnum::OtherSideTraced || mistake == MistakeEnum::OtherSideTracedAndCoded)
  {
    said = TracedSideEnum::Right;
    source->SetTracedSide(TracedSideEnum::Left);
  }
  else
  {
    source->SetTracedSide(said);
  }
  source->SetBuccalOutline(variation.buccalOutline);
  source->SetToothBias(variation.toothBias);
  if (variation.facesLeft)
  {
    source->SetFacing(CephalometricGeometry::FacingEnum::Left);
    source->SetSourceSide(CephalometricGeometry::SourceSideEnum::Left);
  }
  if (variation.separateFrames)
  {
    source->SetFrame(DentalPhantomCaseSource::FrameEnum::SeparateScanner);
  }
  source->SetNumberOfWorkUnits(1);
  AbortWhere(isAborted, source);
  source->Update();
  auto scans = source;
  if (mistake == MistakeEnum::OtherPatient)
  {
    scans = DentalPhantomCaseSource::New();
    scans->SetSeed(seed + 1);
    scans->SetLevel(level);
    scans->SetMakeRadiograph(false);
    scans->SetNumberOfWorkUnits(1);
    AbortWhere(isAborted, scans);
    scans->Update();
  }

  ExperimentCase     experimentCase;
  std::ostringstream id;
  id << level.name << '-' << std::setw(4) << std::setfill('0') << seed;
  experimentCase.id = id.str();
  experimentCase.seed = seed;

  auto data = std::make_shared<DentalCaseData>();
  data->description.fileName = experimentCase.id;
  data->imageSize = { { static_cast<unsigned int>(source->GetImageSize()[0]),
                        static_cast<unsigned int>(source->GetImageSize()[1]) } };
  data->geometry = CephalometricGeometry::New();
  data->geometry->CopyParameters(source->GetNominalGeometry());
  data->geometry->SetPixelSpacing(data->geometry->GetPixelSpacing() * variation.spacingFactor);
  if (variation.sourceDistanceFactor != 1.0)
  {
    const double toDetector =
      data->geometry->GetSourceToDetectorDistance() - data->geometry->GetSourceToMidsagittalDistance();
    const double distance = data->geometry->GetSourceToMidsagittalDistance() * variation.sourceDistanceFactor;
    data->geometry->SetSourceToMidsagittalDistance(distance);
    data->geometry->SetSourceToDetectorDistance(distance + toDetector);
  }
  data->sources.sourceToMidsagittal = ValueSourceEnum::Given;
  data->sources.sourceToDetector = ValueSourceEnum::Given;
  data->sources.sourceSide = ValueSourceEnum::Given;
  data->sources.facing = ValueSourceEnum::Given;
  data->sources.pixelSpacing = ValueSourceEnum::Given;
  data->sources.principalPoint = ValueSourceEnum::Given;
  data->spacingVerdict = PixelSpacingVerdictEnum::UserGiven;
  data->spacingProvenance = "simulated";
  data->description.tracedSide = said;
  data->landmarks3D = DentalLandmarkSet<3>::New();
  auto marked = DentalLandmarkSet<2>::New();
  if (source->GetStandardTracing() != nullptr)
  {
    data->cephalometricLandmarks = CephalometricLandmarkSet::New();
    for (const auto & mark : source->GetStandardTracing()->GetLandmarks())
    {
      CephalometricLandmarkSet::PointType point;
      std::copy(mark.drawn.begin(), mark.drawn.end(), point.Begin());
      // As the file of such a case says it, in the form that the level names.
      data->cephalometricLandmarks->AddLandmark(mark.name,
                                                point,
                                                level.landmarkForm == "sigma" ? mark.slip.statedSigma : 0.0,
                                                level.landmarkForm == "detector" ? mark.slip.GetPeak() : -1.0);
    }
  }
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    auto & input = jaw == 0 ? data->upper : data->lower;
    input.mesh = scans->GetMesh(jaw);
    // Tooth labels are more than a scan file holds.
    input.mesh->SetPointData(nullptr);
    input.contour = source->GetTracing(jaw);
    for (const auto & landmark : scans->GetLandmarks3D(jaw)->GetLandmarks())
    {
      data->landmarks3D->AddLandmark(landmark.name, landmark.point);
    }
    for (const auto & landmark : source->GetLandmarks2D(jaw)->GetLandmarks())
    {
      marked->AddLandmark(landmark.name, landmark.point);
    }
    if (variation.extraNoise > 0.0)
    {
      ReproducibleRandom random(seed, NoiseStream + jaw);
      AddNoise(input.contour, variation.extraNoise, random);
    }
  }
  if (withRadiograph)
  {
    const auto * radiograph = source->GetRadiograph();
    data->image = DentalCaseData::ImageType::New();
    data->image->SetRegions(radiograph->GetBufferedRegion());
    data->image->Allocate();
    std::copy_n(radiograph->GetBufferPointer(),
                radiograph->GetBufferedRegion().GetNumberOfPixels(),
                data->image->GetBufferPointer());
  }
  if (!variation.knowsPixelSpacing)
  {
    auto geometry = CephalometricGeometry::New();
    geometry->SetSourceToMidsagittalDistance(data->geometry->GetSourceToMidsagittalDistance());
    geometry->SetSourceToDetectorDistance(data->geometry->GetSourceToDetectorDistance());
    geometry->SetSourceSide(data->geometry->GetSourceSide());
    geometry->SetFacing(data->geometry->GetFacing());
    geometry->SetPrincipalPoint(data->geometry->GetPrincipalPoint());
    data->geometry = geometry;
    data->sources.pixelSpacing = ValueSourceEnum::Estimated;
    data->spacingVerdict = PixelSpacingVerdictEnum::Unknown;
  }
  if (!variation.knowsPrincipalPoint)
  {
    CephalometricGeometry::PixelIndexType unknown;
    unknown.Fill(0.0);
    data->geometry->SetPrincipalPoint(unknown);
    data->sources.principalPoint = ValueSourceEnum::Estimated;
  }
  if (variation.jaws != ExperimentVariation::JawsEnum::Both)
  {
    (variation.jaws == ExperimentVariation::JawsEnum::UpperAlone ? data->lower : data->upper) =
      DentalCaseData::JawType();
  }
  MakeExperimentMistake(mistake, *data);
  experimentCase.data = data;
  experimentCase.marked = marked;
  EstimateFrames(experimentCase, isAborted);
  if (variation.distalTrim > 0.0)
  {
    for (const ToothCode::JawEnum jaw : { ToothCode::JawEnum::Upper, ToothCode::JawEnum::Lower })
    {
      auto & input = data->GetJaw(jaw);
      if (input.mesh.IsNotNull())
      {
        input.mesh = TrimDistally(input.mesh, experimentCase.frames.GetJaw(jaw), variation.distalTrim);
      }
    }
    EstimateFrames(experimentCase, isAborted);
  }

  const AxesType tilt = DrawTilt(seed);
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    const auto motion = source->GetParameters().ComputeFrame(jaw);
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
      {
        double sum = 0.0;
        for (unsigned int d = 0; d < 3; ++d)
        {
          sum += tilt[row][d] * motion.rotation[3 * column + d];
        }
        experimentCase.fileAxes[jaw][row][column] = sum;
      }
    }
  }
  return experimentCase;
}

ExperimentCase
LoadExperimentCase(const std::string & fileName, const std::string & id, const std::function<bool()> & isAborted)
{
  const DentalCase description = ReadDentalCase(fileName);
  if (description.landmarks2DFile.empty())
  {
    itkDentalInputErrorMacro(fileName,
                             "landmarks_2d",
                             "is absent: there is nothing to measure the errors with",
                             "mark landmarks in the radiograph and name their file");
  }
  ExperimentCase experimentCase;
  experimentCase.id = id;
  experimentCase.data = LoadDentalCase(description);
  auto reader = DentalLandmarkFileReader<2>::New();
  reader->SetFileName(description.landmarks2DFile);
  if (description.numbering)
  {
    reader->SetNumbering(*description.numbering);
  }
  reader->Update();
  experimentCase.marked = reader->GetOutput();
  const bool measurable =
    experimentCase.data->landmarks3D.IsNotNull() &&
    std::any_of(experimentCase.marked->GetLandmarks().begin(),
                experimentCase.marked->GetLandmarks().end(),
                [&](const auto & each) { return experimentCase.data->landmarks3D->Find(each.name) != nullptr; });
  if (!measurable)
  {
    itkDentalInputErrorMacro(fileName,
                             "landmarks_3d",
                             experimentCase.data->landmarks3D.IsNull()
                               ? "is absent: there is nothing to measure the errors with"
                               : "has no name of landmarks_2d: there is nothing to measure the errors with",
                             "mark the same landmarks on the scans and in the radiograph");
  }
  EstimateFrames(experimentCase, isAborted);
  experimentCase.fileAxes[0] = NearestPermutation(experimentCase.frames.upper.axes);
  experimentCase.fileAxes[1] = NearestPermutation(experimentCase.frames.lower.axes);
  return experimentCase;
}
} // namespace itk
