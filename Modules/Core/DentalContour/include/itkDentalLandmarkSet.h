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
#ifndef itkDentalLandmarkSet_h
#define itkDentalLandmarkSet_h

#include "DentalContourExport.h"
#include "itkToothCode.h"

#include "itkDataObject.h"
#include "itkPoint.h"

#include <string>
#include <vector>

namespace itk
{
/** \class DentalLandmarkSet
 * \brief Named landmarks such as "UR6_MB", in the order in which they were added.
 *
 * A name is a tooth code, "_" and one of tip, cusp, B, MB, DB, ML, DL. 3-D landmarks are in the mesh's frame and unit,
 * 2-D ones continuous pixel indices.
 *
 * \ingroup DentalContour
 */
template <unsigned int VDimension>
class DentalLandmarkSet : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalLandmarkSet);

  using Self = DentalLandmarkSet;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;
  using PointType = Point<double, VDimension>;

  itkNewMacro(Self);
  itkTypeMacro(DentalLandmarkSet, DataObject);
  /** One named point and the tooth that its name tells. */
  struct LandmarkType
  {
    std::string name;  /**< As its file names it. */
    ToothCode   tooth; /**< Unknown where the name tells none. */
    PointType   point; /**< mm in the mesh's frame, or a continuous pixel index. */
  };

  /** The tooth of a landmark's name. Throws std::invalid_argument that says what a name looks like. */
  static ToothCode
  ParseName(const std::string & name);

  /** Throws std::invalid_argument for a name that is no landmark's, or is there already. */
  void
  AddLandmark(const std::string & name, const PointType & point);

  /** The landmark of that name, or null. */
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
  DentalLandmarkSet() = default;
  ~DentalLandmarkSet() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<LandmarkType> m_Landmarks;
};

extern template class DentalLandmarkSet<2>;
extern template class DentalLandmarkSet<3>;
} // namespace itk

#endif
