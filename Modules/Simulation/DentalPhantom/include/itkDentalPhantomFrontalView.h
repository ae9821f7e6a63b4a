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
#ifndef itkDentalPhantomFrontalView_h
#define itkDentalPhantomFrontalView_h

#include "DentalPhantomExport.h"
#include "itkCephalometricGeometry.h"
#include "itkDentalContour.h"
#include "itkDentalLandmarkSet.h"
#include "itkDentalPhantomAcquisition.h"
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomParameters.h"
#include "itkPerspectiveProjection.h"

#include "itkImage.h"

#include <array>
#include <cstdint>
#include <memory>

namespace itk
{
class DentalPhantomModel;

/** \struct DentalPhantomFrontalView
 * \brief A postero-anterior radiograph of a phantom's patient: depth = S + x, u = pp + m y / sp, v = pp - m z / sp.
 *
 * \ingroup DentalPhantom
 */
struct DentalPhantom_EXPORT DentalPhantomFrontalView
{
  using ImageType = Image<unsigned char, 2>;
  using RotationType = CephalometricGeometry::RotationType;
  using VectorType = CephalometricGeometry::VectorType;

  /** Null where no picture was wanted. */
  ImageType::Pointer                      image;
  CephalometricGeometry::PixelIndexType   principalPoint;
  CephalometricGeometry::PixelSpacingType spacing;
  /** As a clinic would state them, mm. */
  double sourceToMidcoronal{ 1524.0 };
  double sourceToDetector{ 1674.0 };
  bool   sameHeadPosition{ true };
  /** From each jaw's mesh frame to pixels, with the true distances. */
  std::array<PerspectiveProjection, 2> projections;
  /** Of both jaws: with the reader's error, and true. */
  DentalLandmarkSet<2>::Pointer landmarks;
  DentalLandmarkSet<2>::Pointer trueLandmarks;
  /** Incisal edges and the molars' buccal contours, upper and lower. */
  std::array<DentalContour::Pointer, 2> tracings;

  /** \param headRotation, headTranslation  pose of the anatomical frame in the lateral view
   *  \param frames     from the anatomical frame to each jaw's mesh
   *  \param landmarks  of each jaw, in its mesh frame */
  static std::shared_ptr<const DentalPhantomFrontalView>
  Make(const DentalPhantomModel &                 model,
       const DentalPhantomLevel &                 level,
       const DentalPhantomAcquisition &           acquisition,
       std::uint64_t                              seed,
       const RotationType &                       headRotation,
       const VectorType &                         headTranslation,
       const DentalPhantomParameters::RigidMotion frames[2],
       const DentalLandmarkSet<3> * const         landmarks[2],
       const ImageType::SizeType &                imageSize,
       bool                                       makeRadiograph,
       unsigned int                               threads);
};
} // namespace itk

#endif
