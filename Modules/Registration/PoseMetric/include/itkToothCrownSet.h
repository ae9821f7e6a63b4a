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
#ifndef itkToothCrownSet_h
#define itkToothCrownSet_h

#include "PoseMetricExport.h"

#include "itkDataObject.h"
#include "itkObjectFactory.h"
#include "itkToothCode.h"
#include "itkTriangleSurface.h"

#include <memory>
#include <string>
#include <vector>

namespace itk
{
/** \class ToothCrownSet
 * \brief The crowns of single teeth as the scans show them: what an outline of a whole tooth is compared with.
 *
 * Surfaces are in the frame that the holder says: the mesh's, or a metric's dental frame, mm.
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT ToothCrownSet : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ToothCrownSet);

  using Self = ToothCrownSet;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(ToothCrownSet, DataObject);

  /** A tooth's crown. */
  struct CrownType
  {
    ToothCode tooth; /**< Whose crown it is. */
    /** Not null, and not without a triangle. */
    std::shared_ptr<const TriangleSurface> surface;
    /** How far what was cut out of the scan may be from the crown along the arch, standard deviation, mm: next to
     * nothing where labels tell the tooth, millimetres where a textbook does. */
    double sigmaAlong{ 0.0 };
    /** How far its two ends along the arch may be from the crown's, standard deviation, mm. */
    double sigmaWidth{ 0.0 };
    /** How it was found, for a person: "tooth labels". */
    std::string source;
    /** What of it has the outline that is seen from the side, where a cut that is not known by labels has the
     * neighbours' edges beside it, as an incisor's has: its middle. Null: the surface. */
    std::shared_ptr<const TriangleSurface> profile{};
  };

  /** Throws std::invalid_argument where the tooth is not known, is there already, or has no triangle. */
  void
  Add(const CrownType & crown);

  /** Null where there is none. */
  const CrownType *
  Find(const ToothCode & tooth) const;
  /** All of them, in the order in which they were added. */
  const std::vector<CrownType> &
  GetCrowns() const
  {
    return m_Crowns;
  }

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  ToothCrownSet() = default;
  ~ToothCrownSet() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::vector<CrownType> m_Crowns;
};
} // namespace itk

#endif
