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
#ifndef itkPoseStart_h
#define itkPoseStart_h

#include "PoseRegistrationExport.h"
#include "itkPoseTypes.h"

#include "itkLeastSquaresMetricv4.h"
#include "itkObject.h"

#include <vector>

namespace itk
{
/** \class PoseStart
 * \brief Where a pose registration may begin: finds poses that are worth refining.
 *
 * One object serves several threads at once; Search() changes nothing.
 *
 * \ingroup PoseRegistration
 */
class PoseRegistration_EXPORT PoseStart : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PoseStart);

  using Self = PoseStart;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkTypeMacro(PoseStart, Object);

  /** What is asked for. */
  struct RequestType
  {
    /** Where contours were made; what is not searched keeps its value. */
    PoseParameters pose{ {} };
    unsigned int   maximumNumberOfStarts{ 6 };
    /** The pixel spacing is not known: the scale is to be searched as well. */
    bool searchScale{ false };
    /** The rotation is held. */
    bool holdRotation{ false };
  };
  /** A pose and its cost, lower is better. */
  struct StartType
  {
    PoseParameters parameters{ {} }; /**< Where to begin. */
    double         cost{ 0.0 };      /**< Mean over the points of the tracing; for comparing starts of one run alone. */
  };

  /** \param metric  a metric or a sum, its contours held (HoldEnum::Contours) at the request's pose.
   *  \return best first; empty where there is nothing to match. */
  virtual std::vector<StartType>
  Search(const LeastSquaresMetricv4 & metric, const RequestType & request) const = 0;

protected:
  PoseStart() = default;
  ~PoseStart() override = default;
};
} // namespace itk

#endif
