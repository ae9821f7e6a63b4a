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
#include "itkDentalPhantomFrontalView.h"

#include "itkDentalPhantomFilm.h"
#include "itkDentalPhantomHead.h"
#include "itkDentalPhantomMath.h"
#include "itkDentalPhantomModel.h"
#include "itkDentalPhantomOutline.h"
#include "itkDentalPhantomTracer.h"
#include "itkReproducibleRandom.h"

#include <algorithm>
#include <cmath>

namespace itk
{
using namespace DentalPhantomMath;

namespace
{
enum FrontalStream : std::uint64_t
{
  FrontalHeadStream = 501,
  FrontalMachineStream = 502,
  FrontalHandStream = 503
};
} // namespace

std::shared_ptr<const DentalPhantomFrontalView>
DentalPhantomFrontalView::Make(const DentalPhantomModel &                 model,
                               const DentalPhantomLevel &                 level,
                               const DentalPhantomAcquisition &           acquisition,
                               std::uint64_t                              seed,
                               const RotationType &                       headRotation,
                               const VectorType &                         headTranslation,
                               const DentalPhantomParameters::RigidMotion frames[2],
                               const DentalLandmarkSet<3> * const         landmarks[2],
                               const ImageType::SizeType &                imageSize,
                               bool                                       makeRadiograph,
                               unsigned int                               threads)
{
  auto               view = std::make_shared<DentalPhantomFrontalView>();
  ReproducibleRandom turn(seed, FrontalHeadStream);
  ReproducibleRandom machine(seed, FrontalMachineStream);
  ReproducibleRandom hand(seed, FrontalHandStream);

  // The head: as in the lateral view, or turned a little in the same ear rods.
  const double pitch = level.frontalPitchDegrees * Degree * turn.Normal();
  const double roll = level.frontalTurnDegrees * Degree * turn.Normal();
  const double yaw = level.frontalTurnDegrees * Degree * turn.Normal();
  VectorType   shift;
  for (unsigned int d = 0; d < 3; ++d)
  {
    shift[d] = level.frontalShift * turn.Normal();
  }
  view->sameHeadPosition = level.sameHeadPosition;
  RotationType rotation = headRotation;
  VectorType   translation = headTranslation;
  if (!view->sameHeadPosition)
  {
    const RotationType more = DentalPhantomHeadRotation(yaw, roll, pitch);
    rotation = more * rotation;
    translation = more * translation + shift;
  }

  const double distance = acquisition.trueSourceToMidsagittal;
  const double gap = std::nearbyint(100.0 * machine.Uniform(110.0, 190.0)) / 100.0;
  view->spacing.Fill(std::nearbyint(1e4 * machine.Uniform(0.24, 0.26)) / 1e4);
  // The ear rods stand in the picture's middle.
  view->principalPoint[0] =
    std::nearbyint(100.0 * static_cast<double>(imageSize[0]) * machine.Uniform(0.48, 0.52)) / 100.0;
  view->principalPoint[1] =
    std::nearbyint(100.0 * static_cast<double>(imageSize[1]) * machine.Uniform(0.43, 0.47)) / 100.0;
  view->sourceToMidcoronal = acquisition.givenSourceToMidsagittal;
  view->sourceToDetector = level.knownMachine ? distance + gap : 1674.0;

  // depth = S + x, u = pp + m y / sp, v = pp - m z / sp, m = D / depth (the source behind the patient).
  const auto project = [&](const RotationType & r, const VectorType & t) {
    PerspectiveProjection projection;
    const double          k = (distance + gap) / view->spacing[0];
    for (unsigned int column = 0; column < 4; ++column)
    {
      const double x = column < 3 ? r(0, column) : t[0];
      const double y = column < 3 ? r(1, column) : t[1];
      const double z = column < 3 ? r(2, column) : t[2];
      const double depth = x + (column == 3 ? distance : 0.0);
      projection.matrix[column] = k * y + view->principalPoint[0] * depth;
      projection.matrix[4 + column] = -k * z + view->principalPoint[1] * depth;
      projection.matrix[8 + column] = depth;
    }
    // The source in the object's frame: R^T (s - t), s = (-S, 0, 0).
    for (unsigned int column = 0; column < 3; ++column)
    {
      projection.source[column] = r(0, column) * (-distance - t[0]) - r(1, column) * t[1] - r(2, column) * t[2];
    }
    return projection;
  };
  const PerspectiveProjection anatomical = project(rotation, translation);
  view->landmarks = DentalLandmarkSet<2>::New();
  view->trueLandmarks = DentalLandmarkSet<2>::New();
  const double error = level.frontalNoise / view->spacing[0];
  for (unsigned int jaw = 0; jaw < 2; ++jaw)
  {
    RotationType frame;
    for (unsigned int row = 0; row < 3; ++row)
    {
      for (unsigned int column = 0; column < 3; ++column)
      {
        frame(row, column) = frames[jaw].rotation[3 * row + column];
      }
    }
    const RotationType toHead = rotation * RotationType(frame.GetTranspose());
    view->projections[jaw] = project(toHead, translation - toHead * VectorType(frames[jaw].translation.data()));
    for (const auto & landmark : landmarks[jaw]->GetLandmarks())
    {
      DentalLandmarkSet<2>::PointType pixel;
      view->projections[jaw].Project(landmark.point.GetDataPointer(), pixel[0], pixel[1]);
      view->trueLandmarks->AddLandmark(landmark.name, pixel);
      // What a reader marks from the front: central incisors, canines, first molars.
      const unsigned int position = landmark.tooth.GetPosition();
      const bool         mesial = landmark.name.find("DB") == std::string::npos;
      for (unsigned int d = 0; d < 2; ++d)
      {
        pixel[d] = std::nearbyint(1e3 * (pixel[d] + error * hand.Normal())) / 1e3;
      }
      if (mesial && (position == 1 || position == 3 || position == 6))
      {
        view->landmarks->AddLandmark(landmark.name, pixel);
      }
    }
    // The outer outline: incisal edges of incisors and canines, buccal contours of first molars.
    view->tracings[jaw] = DentalContour::New();
    for (const unsigned int position : { 0u, 1u, 2u, 5u })
    {
      for (const bool left : { false, true })
      {
        const unsigned int tooth = DentalPhantomJaw::GetIndex(left, position);
        const auto         crown = DentalPhantomOutline::Resample(
          DentalPhantomOutline::Trace(model, jaw, tooth, anatomical, false, 0.8, threads), 120);
        if (crown.empty())
        {
          continue;
        }
        // The part whose outward normal looks occlusally (laterally for molars): the longest run.
        double area = 0.0;
        for (std::size_t i = 0; i < crown.size(); ++i)
        {
          const auto & a = crown[i];
          const auto & b = crown[(i + 1) % crown.size()];
          area += a[0] * b[1] - b[0] * a[1];
        }
        std::vector<bool> looks;
        for (std::size_t i = 0; i < crown.size(); ++i)
        {
          const auto & a = crown[(i + crown.size() - 2) % crown.size()];
          const auto & b = crown[(i + 2) % crown.size()];
          const double turned = area > 0.0 ? 1.0 : -1.0;
          const double l = std::max(std::hypot(b[0] - a[0], b[1] - a[1]), 1e-9);
          const double normal[2] = { turned * (b[1] - a[1]) / l, -turned * (b[0] - a[0]) / l };
          looks.push_back(position < 3 ? (jaw == 0 ? normal[1] : -normal[1]) > 0.5
                                       : (left ? normal[0] : -normal[0]) > 0.5);
        }
        std::size_t best = 0;
        std::size_t length = 0;
        for (std::size_t i = 0; i < crown.size(); ++i)
        {
          std::size_t n = 0;
          while (n < crown.size() && looks[(i + n) % crown.size()])
          {
            ++n;
          }
          if (n > length)
          {
            best = i;
            length = n;
          }
        }
        std::vector<DentalPhantomTracer::Polyline> lines(1);
        for (std::size_t n = 0; n < length; ++n)
        {
          lines[0].points.push_back(crown[(best + n) % crown.size()]);
        }
        if (length < 4)
        {
          continue;
        }
        lines[0].fdi = DentalPhantomDentition::ToothFDI(jaw, tooth);
        DentalPhantomTracer::Noise noise;
        noise.correlated = level.correlatedNoise;
        noise.white = level.whiteNoise;
        DentalPhantomTracer::AddNoise(lines, noise, seed, 600 + lines[0].fdi);
        std::vector<DentalContour::PointType> points;
        for (const auto & p : lines[0].points)
        {
          points.emplace_back(p.data());
        }
        view->tracings[jaw]->AddPolyline(points, ToothCode(lines[0].fdi));
      }
    }
  }
  if (makeRadiograph)
  {
    DentalPhantomFilm film;
    film.view = DentalPhantomFilm::ViewEnum::Frontal;
    film.projection = anatomical;
    film.earRod = { { view->principalPoint[0], view->principalPoint[1] } };
    film.pixelSize = view->spacing[0] * distance / (distance + gap);
    film.size = { { static_cast<unsigned int>(imageSize[0]), static_cast<unsigned int>(imageSize[1]) } };
    film.seed = seed ^ 0x5bd1e995u;
    film.noise = level.radiographNoise;
    film.blur = level.radiographBlur;
    const auto grey = film.Render(model, threads);
    view->image = ImageType::New();
    view->image->SetRegions(imageSize);
    view->image->Allocate();
    std::copy(grey.begin(), grey.end(), view->image->GetBufferPointer());
  }
  return view;
}
} // namespace itk
