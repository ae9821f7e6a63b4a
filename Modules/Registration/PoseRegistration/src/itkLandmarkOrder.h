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
#ifndef itkLandmarkOrder_h
#define itkLandmarkOrder_h

#include "itkDentalFrameEstimator.h"
#include "itkToothCode.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace itk
{
/** \class LandmarkOrder
 * \brief Which landmarks of a jaw stand at another tooth's place, by the names and places alone.
 *
 * Two things tell, each of single landmarks. Along the arch, from the patient's right to the left, landmarks follow
 * each other as their teeth do (UR8 .. UR1, UL1 .. UL8), and a molar's mesial cusps come before its distal ones toward
 * the midline. And the step from a tooth to the next one of its side is about as long as on the other side: a mark one
 * tooth back leaves a step of two teeth. The latter needs both sides' marks and neighbours by number, so that a lost
 * tooth, on one side or on both, raises no alarm.
 *
 * Of a pair that is out of order the one is named that lies away from the mirror image of its fellow on the other
 * side; both where that does not tell.
 *
 * \ingroup PoseRegistration
 */
class LandmarkOrder
{
public:
  /** In the mesh's frame, mm. */
  using LandmarkType = std::pair<std::string, std::array<double, 3>>;
  using LandmarksType = std::vector<LandmarkType>;

  /** How far two landmarks may stand in the wrong order, mm along the arch: crowded teeth overlap. */
  static constexpr double MaximumOverlap = 1.5;

  /** Of one jaw. */
  LandmarkOrder(const DentalJawFrame & frame, const LandmarksType & landmarks);

  /** Indices of those at another tooth's place, ascending. */
  const std::vector<std::size_t> &
  GetMisplaced() const
  {
    return m_Misplaced;
  }
  /** How far the worst of them is out of order, or its step too long or too short, mm; 0 where none is. */
  double
  GetLargest() const
  {
    return m_Largest;
  }

private:
  /** A landmark as it is compared. */
  struct PlaceType
  {
    ToothCode tooth;
    /** After the tooth's code: tip, B, MB and so on. */
    std::string suffix;
    /** Position in the row of teeth, from the right to the left, in thirds of a tooth. */
    int rank{ 0 };
    /** Anterior and to the left of the middle of the molar baseline, mm. */
    double x{ 0.0 };
    double y{ 0.0 };
    /** mm from the mirror image of its fellow; negative where it has none. */
    double fromFellow{ -1.0 };
  };

  void
  MeasureFellows();
  /** How far two are in the wrong order, mm; 0 where they are not, or cannot be compared. */
  double
  ComputeOverlap(const PlaceType & a, const PlaceType & b) const;
  void
  FindOutOfOrder();
  void
  FindWrongSteps();
  /** Of that tooth the one by which steps are measured, or null. */
  const PlaceType *
  FindFirst(ToothCode tooth) const;
  void
  Add(std::size_t index, double amount);

  std::vector<PlaceType>   m_Places;
  std::vector<std::size_t> m_Misplaced;
  double                   m_Largest{ 0.0 };
};
} // namespace itk

#endif
