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
#ifndef itkLandmarkCounterpartSet_h
#define itkLandmarkCounterpartSet_h

#include "PoseMetricExport.h"
#include "itkToothCode.h"

#include "itkDataObject.h"
#include "itkPoint.h"

#include <string>
#include <vector>

namespace itk
{
/** \class LandmarkCounterpartSet
 * \brief Where the landmarks of a cephalometric analysis are on the scans.
 *
 * A landmark without a side is not one point of a scan. Where both teeth have their point, an incisor's landmark is the
 * one that stands foremost in the picture, and a posterior tooth's the middle of the images of both.
 *
 * Points are in the frame that the holder says: the mesh's, or a metric's dental frame, mm.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT LandmarkCounterpartSet : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LandmarkCounterpartSet);

  using Self = LandmarkCounterpartSet;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using PointType = Point<double, 3>;

  itkNewMacro(Self);
  itkTypeMacro(LandmarkCounterpartSet, DataObject);

  /** How far the image of the other side's tooth may be from that of this one's, standard deviations, mm: arches are
   * not symmetric, heads turn by two degrees, and 45 mm lie between first molars. */
  static constexpr double OneSideSigmaAlong = 1.2;
  static constexpr double OneSideSigmaAcross = 0.6;

  /** What is imaged of two points. */
  enum class RuleEnum : uint8_t
  {
    Middle,
    Foremost
  };

  /** A landmark's place or places. */
  struct CounterpartType
  {
    /** CephalometricLandmarkSet::MakeName(). */
    std::string        name;
    ToothCode::JawEnum jaw{ ToothCode::JawEnum::Unknown };
    /** One or two. */
    std::vector<PointType> points;
    RuleEnum               rule{ RuleEnum::Middle };
    /** How far the landmark may be from there, standard deviation along the occlusal plane and across it, mm. */
    double sigmaAlong{ 0.0 };
    double sigmaAcross{ 0.0 };
    /** How it was found, for a person: "landmarks_3d"; where the two points were found differently "landmarks_3d and
     * tooth labels", the right one's first. */
    std::string source;
  };

  /** Throws std::invalid_argument where there is one of that name already, or not one or two points. */
  void
  Add(const CounterpartType & counterpart);

  /** Null where there is none. */
  const CounterpartType *
  Find(const std::string & name) const;
  /** All of them, in the order in which they were added. */
  const std::vector<CounterpartType> &
  GetCounterparts() const
  {
    return m_Counterparts;
  }

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  LandmarkCounterpartSet() = default;
  ~LandmarkCounterpartSet() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<CounterpartType> m_Counterparts;
};
} // namespace itk

#endif
