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
#ifndef itkDentalFrameObject_h
#define itkDentalFrameObject_h

#include "UMidlineDentalAxisExport.h"
#include "itkDentalFrameEstimator.h"

#include "itkDataObject.h"

namespace itk
{
/** \class DentalFrameObject
 * \brief Everything that was found of the jaws' dental frames, as a data object of the pipeline.
 *
 * Output of UMidlineDentalAxisFilter beside the transforms, input of what judges the frames (ScanCheckFilter). A new
 * one says that no jaw has a valid frame. Lengths in mm, in the meshes' frames.
 *
 * \ingroup UMidlineDentalAxis
 */
class UMidlineDentalAxis_EXPORT DentalFrameObject : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(DentalFrameObject);

  using Self = DentalFrameObject;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(DentalFrameObject, DataObject);
  /** What EstimateDentalFrames() found. */
  void
  Set(const DentalFrameResult & frames);
  const DentalFrameResult &
  Get() const
  {
    return m_Frames;
  }

  void
  Initialize() override;
  void
  Graft(const DataObject * data) override;

protected:
  DentalFrameObject() = default;
  ~DentalFrameObject() override = default;
  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  DentalFrameResult m_Frames;
};
} // namespace itk

#endif
