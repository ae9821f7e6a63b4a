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
#ifndef itkDentalPhantomStandardTracing_h
#define itkDentalPhantomStandardTracing_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomHand.h"
#include "itkDentalPhantomLevel.h"
#include "itkDentalPhantomModel.h"
#include "itkPerspectiveProjection.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace itk
{
/** \class DentalPhantomStandardTracing
 * \brief What a cephalometric analysis draws: U1, L1, U6 and L6 as whole teeth, and landmarks.
 *
 * The incisor is the central one of each jaw that projects foremost; the molar stands in the middle of the two sides'
 * images (the right one's outline, moved, turned and scaled half-way to the left one's; where a side lacks it the other
 * one's). Instead of the patient's teeth stock outlines can be placed by tip and axis. Free of ITK objects.
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomStandardTracing
{
public:
  using PixelType = std::array<double, 2>;

  /** Over which the drift of a drawn outline is correlated, px: that of every film, since no level says more. */
  static constexpr double CorrelationLength{ 15.0 };

  /** One tooth, px; closed, without a repeated end. */
  struct Outline
  {
    std::uint8_t fdi{ 0 }; /**< The tooth, 11 to 48. */
    /** Before the hand's error; of the template where one is used, placed exactly. */
    std::vector<PixelType>  exact;
    std::vector<PixelType>  drawn;
    bool                    isTemplate{ false };
    DentalPhantomHand::Slip slip;
  };
  /** A landmark of the radiograph: where it is, and where the reader or the detector says that it is. */
  struct Landmark
  {
    /** "U1_tip", "U1A", "U6_MB", "Ms". */
    std::string             name;
    PixelType               exact{};
    PixelType               drawn{};
    DentalPhantomHand::Slip slip;
  };

  /** \param tips  projected landmarks of the scans by name, "UR1_tip", "UR6_MB"
   *  \param facing  +1 where anterior is to the right in the picture
   *  \param spacing  mm a pixel in the detector */
  DentalPhantomStandardTracing(const DentalPhantomModel &               model,
                               const PerspectiveProjection &            projection,
                               const std::map<std::string, PixelType> & tips,
                               int                                      facing,
                               double                                   spacing,
                               const DentalPhantomLevel &               level,
                               std::uint64_t                            seed,
                               unsigned int                             threads);

  /** Of a jaw: incisor, molar. */
  const std::vector<Outline> &
  GetOutlines(unsigned int jaw) const
  {
    return m_Outlines[jaw];
  }
  /** Of both jaws, to register with. */
  const std::vector<Landmark> &
  GetLandmarks() const
  {
    return m_Landmarks;
  }

  /** The occlusal plane's direction in the picture, anterior. */
  static PixelType
  ComputeAlong(const PerspectiveProjection & projection);

  /** A stock outline in mm: origin at the incisal edge or the mesiobuccal cusp, x anterior, y apical. `molar` or
   * incisor of a jaw; two sets. Drawn for this phantom after textbook proportions, taken from no program. */
  static std::vector<PixelType>
  GetTemplate(unsigned int jaw, bool molar, unsigned int set);

private:
  std::array<std::vector<Outline>, 2> m_Outlines;
  std::vector<Landmark>               m_Landmarks;
};
} // namespace itk

#endif
