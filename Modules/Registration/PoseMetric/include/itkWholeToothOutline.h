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
#ifndef itkWholeToothOutline_h
#define itkWholeToothOutline_h

#include "PoseMetricExport.h"

#include "itkDentalContour.h"
#include "itkPoseTypes.h"
#include "itkToothCode.h"
#include "itkToothOutline.h"

#include "itkNumericTraits.h"

namespace itk
{
/** \class WholeToothOutline
 * \brief The closed outline of a whole tooth, crown and root, as a cephalometric analysis draws it, and the part of it
 * that a scan can show.
 *
 * The tooth's axis is the outline's long one, its occlusal end the one toward the other jaw. The crown ends at the
 * neck, which is put at a textbook's share of the tooth's length; a tenth of the crown before it is left out, as
 * gingiva covers it on a scan. Where the scan's crown is known to be lower, what is drawn of the tooth beyond that is
 * left out too: it could only be matched from a place too near to the root. Points lie at equal distances on what is
 * left, from one side over the occlusal end to the other. The reference is the incisal edge of a front tooth, the
 * middle of the crown of one behind it.
 *
 * Sources of the shares: Wheeler's dental anatomy, table of measurements (crown 10.5 of 23.5 mm in an upper central
 * incisor, 9 of 21.5 in a lower one, 7.5 of 20 and of 21.5 in first molars).
 *
 * \ingroup PoseMetric
 */
class PoseMetric_EXPORT WholeToothOutline : public ToothOutline
{
public:
  /** \param polyline  continuous pixel indices; an open one whose ends meet within a tenth of its length is closed.
   * \param scanned  how much of the crown from its occlusal end the scan shows, px of 0.25 mm in the detector plane. */
  WholeToothOutline(const PoseGeometry &                geometry,
                    const DentalContour::PolylineType & polyline,
                    ToothCode::JawEnum                  jaw,
                    double                              scanned = NumericTraits<double>::max());

  /** Along the axis, px. */
  double
  GetLength() const
  {
    return m_Length;
  }
  /** Length over width. */
  double
  GetElongation() const
  {
    return m_Elongation;
  }
  /** Unit vector from the root to the crown. */
  const PointType &
  GetAxis() const
  {
    return m_Axis;
  }

private:
  PointType m_Axis{};
  double    m_Length{ 0.0 };
  double    m_Elongation{ 0.0 };
};
} // namespace itk

#endif
