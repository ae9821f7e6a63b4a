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
#ifndef itkCephalometricLandmarkSet_h
#define itkCephalometricLandmarkSet_h

#include "DentalContourExport.h"
#include "itkToothCode.h"

#include "itkDataObject.h"
#include "itkPoint.h"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace itk
{
/** \class CephalometricLandmarkSet
 * \brief Dental landmarks of a cephalometric analysis, marked on a radiograph, as evidence for a registration.
 *
 * A landmark of an analysis is not one of a scan: "U1_tip" is the tip of the more prominent central incisor, "U6_MB"
 * the middle of the right and the left first molar's images, and programs call one point by many names. ParseName()
 * knows those names (Documentation/FileFormats.md has the table) and tells what each means: jaw, position of the tooth,
 * side where one was said, and which point of the tooth. A mesial contact, a mesiobuccal cusp and the middle of an
 * occlusal surface lie millimetres apart, and are different points here.
 *
 * Positions are continuous pixel indices, in the order in which they were added.
 *
 * \ingroup DentalContour
 */
class DentalContour_EXPORT CephalometricLandmarkSet : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CephalometricLandmarkSet);

  using Self = CephalometricLandmarkSet;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using PointType = Point<double, 2>;

  itkNewMacro(Self);
  itkTypeMacro(CephalometricLandmarkSet, DataObject);

  /** Which point of a tooth. */
  enum class FeatureEnum : std::uint8_t
  {
    /** Incisal edge, its middle. */
    Tip,
    /** The one cusp of a canine, or a premolar's buccal one. */
    Cusp,
    MesiobuccalCusp,
    DistobuccalCusp,
    MesiolingualCusp,
    DistolingualCusp,
    /** Contact point with the tooth in front. */
    MesialContact,
    /** Middle of the occlusal surface. */
    OcclusalMiddle,
    /** A molar's point of which the name does not say more. */
    Unspecified,
    /** End of the root, which no scan shows. */
    Apex
  };

  /** What a name means. */
  struct MeaningType
  {
    ToothCode::JawEnum jaw{ ToothCode::JawEnum::Unknown }; /**< Unknown where the name tells none. */
    /** 1 central incisor .. 8 third molar. */
    unsigned int position{ 0 };
    /** The tooth where the name says its side; else unknown: the analysis's own convention. */
    ToothCode   tooth;
    FeatureEnum feature{ FeatureEnum::Unspecified };
  };

  /** A mark, with what its name means. */
  struct LandmarkType
  {
    /** As the file has it, for messages. */
    std::string name;
    MeaningType meaning;
    PointType   point;
    /** Standard deviation an axis, pixels; 0 where nobody said one. */
    double sigma{ 0.0 };
    /** 0 to 1, of a detector; negative where nobody said one. */
    double confidence{ -1.0 };
  };

  /** The meaning of a name; position 0 where it is no dental landmark that is known. Case and blanks do not matter. */
  static MeaningType
  ParseName(const std::string & name);

  /** One name for each meaning: "U1_tip", "U6_MB", "L6_mesial", "UR6_MB". */
  static std::string
  MakeName(const MeaningType & meaning);

  /** Throws std::invalid_argument for a name that is no dental landmark's, one whose meaning is there already, a place
   * that is not finite, or a sigma that is negative. */
  void
  AddLandmark(const std::string & name, const PointType & point, double sigma = 0.0, double confidence = -1.0);

  /** The landmark of that meaning (name of MakeName()), or null. */
  const LandmarkType *
  Find(const std::string & name) const;
  /** All of them, in the order in which they were added, and how many. */
  const std::vector<LandmarkType> &
  GetLandmarks() const
  {
    return m_Landmarks;
  }
  std::size_t
  GetNumberOfLandmarks() const
  {
    return m_Landmarks.size();
  }
  /** Takes everything out. */
  void
  Initialize() override;

  void
  Graft(const DataObject * data) override;

protected:
  CephalometricLandmarkSet() = default;
  ~CephalometricLandmarkSet() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<LandmarkType> m_Landmarks;
};
} // namespace itk

#endif
