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
#ifndef itkDentalPhantomHand_h
#define itkDentalPhantomHand_h

#include "DentalPhantomExport.h"
#include "itkDentalPhantomLevel.h"

#include <array>
#include <cstdint>
#include <vector>

namespace itk
{
/** \class DentalPhantomHand
 * \brief How a reader (or a detector) errs tooth by tooth on one film.
 *
 * An outline of a tooth is moved, turned and scaled as a whole, independently of the other teeth: its points share that
 * error. A reader's bias is shared by all outlines and landmarks of the film; a gross error is rare and large. The
 * spread differs from item to item by a factor that an informative confidence knows. Figures: practice.md, section 1.
 * Drift and jitter along a line are DentalPhantomTracer::AddNoise().
 *
 * \ingroup DentalPhantom
 */
class DentalPhantom_EXPORT DentalPhantomHand
{
public:
  using PixelType = std::array<double, 2>;

  /** \param along      unit vector of the occlusal plane in the picture, anterior
   *  \param spacing    mm a pixel in the detector */
  DentalPhantomHand(const DentalPhantomLevel & level, std::uint64_t seed, const PixelType & along, double spacing);

  /** What happened to one outline or landmark. */
  struct Slip
  {
    /** px */
    PixelType shift{};
    /** rad, and factor */
    double turn{ 0.0 };
    double scale{ 1.0 };
    bool   gross{ false };
    /** The shift's standard deviation an axis from which it was drawn, px, without bias and gross errors. */
    double sigma{ 0.0 };
    /** What is said of it: sigma where confidence informs, a number of the same kind that knows nothing else. */
    double statedSigma{ 0.0 };

    /** The same as a detector says it, 0.05 to 0.98: its peak falls as its spread grows. */
    double
    GetPeak() const;
  };
  /** `item` numbers a tooth (its FDI number); the same for the same item. */
  Slip
  DrawOutline(unsigned int item) const;
  /** The landmark of a tooth; it shares a part of the outline's error where the level says so. `kind` tells several of
   * a tooth apart. */
  Slip
  DrawLandmark(unsigned int item, unsigned int kind) const;

  /** Moves points about their centroid. */
  static void
  Apply(const Slip & slip, std::vector<PixelType> & points);
  /** Shift of everything that it draws on this film, px. */
  const PixelType &
  GetBias() const
  {
    return m_Bias;
  }

private:
  Slip
  Draw(std::uint64_t stream, double along, double across, const double shared[2], double part) const;

  DentalPhantomLevel m_Level;
  std::uint64_t      m_Seed;
  PixelType          m_Along;
  double             m_Spacing;
  PixelType          m_Bias{};
};
} // namespace itk

#endif
